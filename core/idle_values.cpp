#include "core/idle_values.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reeve::core {

IdleValues::IdleValues(const Hardware& hardware, int fingers) : builder_(hardware) {
  for (const FingerHardware& own : hardware.fingers) {
    if (own.finger > fingers) continue;
    const auto add = [&](const char* name, const std::optional<double>& value, bool at_tip,
                         bool is_angle) {
      if (!value) return;
      of_fingers_.push_back(
          {fmt::format("finger.{}.{}", own.finger, name), own.finger, at_tip, is_angle});
    };
    add("tip_mu", own.tip_mu, true, false);
    add("tip_angle_rad", own.tip_angle_rad, true, true);
    add("sheath_mu", own.sheath_mu, false, false);
    add("sheath_angle_rad", own.sheath_angle_rad, false, true);
  }
  for (const ContactHardware& own : hardware.contacts) of_contacts_.push_back(name_of(own));
}

void IdleValues::look_at(const Network& network) {
  std::erase_if(of_fingers_, [&](const OfFinger& value) {
    return std::any_of(network.contacts.begin(), network.contacts.end(),
                       [&](const Contact& contact) {
                         const bool is_tip = contact.place == ContactPlace::tip;
                         return contact.finger == value.finger && is_tip == value.at_tip &&
                                !(value.is_angle && contact.angle.is_given());
                       });
  });
  if (of_contacts_.empty()) return;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const ContactHardware* own = builder_.own_values(network, tendon, k);
      const WrapAngle angle = network.contacts[tendon.first_contact + k].angle;
      if (own == nullptr || (!own->mu && angle.is_given())) continue;
      std::erase(of_contacts_, name_of(*own));
    }
  }
}

std::vector<std::string> IdleValues::keys() const {
  std::vector<std::string> keys;
  for (const OfFinger& value : of_fingers_) keys.push_back(value.key);
  for (const std::string& name : of_contacts_) keys.push_back("contact." + name);
  return keys;
}

}  // namespace reeve::core
