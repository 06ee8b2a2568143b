// Values of [finger.N] and [contact."a-T1"] of a hardware that act at no contact.
//
// A finger's tip may be tied (1x), its strands may end at no sheath, and a routing may lack a
// contact of that name. An angle does not act where the word gives another.
#pragma once

#include <string>
#include <vector>

#include "core/mechanics.hpp"

namespace reeve::core {

class IdleValues {
 public:
  // Looks at the values of fingers 1 … `fingers` alone: a file may describe a larger hand.
  IdleValues(const Hardware& hardware, int fingers);

  // Removes the values that act in this network.
  void look_at(const Network& network);

  bool empty() const { return of_fingers_.empty() && of_contacts_.empty(); }
  // Their keys in the file, such as "finger.1.sheath_mu" and "contact.a-T1".
  std::vector<std::string> keys() const;

 private:
  struct OfFinger {
    std::string key;
    int finger = 0;
    bool at_tip = false;
    bool is_angle = false;
  };

  MechanicsBuilder builder_;
  std::vector<OfFinger> of_fingers_;
  std::vector<std::string> of_contacts_;
};

}  // namespace reeve::core
