// Contacts that take a friction coefficient or a wrap angle of their kind, and those that have one
// of their own.
//
// A value of one finger, one contact or the word stands in place of the kind's. A change of the
// kind's value, by an option or by a draw, leaves it alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/mechanics.hpp"

namespace reeve::core {

enum class LawValue : std::uint8_t { mu, angle };

class ValueUse {
 public:
  ValueUse(const Hardware& hardware, std::vector<ContactKind> kinds, LawValue value);

  void look_at(const Network& network);

  // Says that one of more networks than can be looked at may have a contact that takes it.
  void suppose_taken() { is_taken_ = true; }
  // True if a contact, or a guide of a finger, takes the value of its kind.
  bool is_taken() const { return is_taken_; }
  // True if contacts of these kinds have values of their own.
  bool has_owners() const;
  // True if all contacts of these kinds have values of their own.
  bool is_idle() const { return has_owners() && !is_taken_; }
  // "tips of fingers 1, 2 and sheaths of finger 1 and contact a-T1"; empty without owners.
  std::string owners() const;
  // "tubes or sheaths"
  std::string kinds() const;

 private:
  void look_at(const Network& network, const TendonSpan& tendon, std::size_t k);
  void look_at_guides(int fingers);
  bool is_of_kind(ContactKind kind) const;
  const FingerHardware* own_values(int finger) const;
  bool is_owned_by_finger(const Contact& contact) const;

  MechanicsBuilder builder_;
  Hardware hardware_;
  std::vector<ContactKind> kinds_;
  LawValue value_;
  bool is_taken_ = false;
  std::set<int> tips_;
  std::set<int> sheaths_;
  std::set<std::string> contacts_;
  bool in_word_ = false;
};

// Shows a ValueUse the networks that an option is about.
using LookAtNetworks = std::function<void(ValueUse&)>;
LookAtNetworks looks_at(const std::vector<Routing>& routings);

// "--sheath-mu leaves sheaths of finger 1 alone, which have values of their own"
std::string left_alone(const std::string& option, const ValueUse& use);

// Throws InputError if no contact takes the value of an option of this name.
void require_taken(const std::string& option, const ValueUse& use);

}  // namespace reeve::core
