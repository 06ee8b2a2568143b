#include "core/value_use.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace reeve::core {
namespace {

const char* plural_of(ContactKind kind) {
  constexpr std::array names{"tubes", "bearings", "sheaths", "blocks", "bars"};
  return names[static_cast<std::size_t>(kind)];
}

void add_fingers(const char* what, const std::set<int>& fingers, std::vector<std::string>& parts) {
  if (fingers.empty()) return;
  parts.push_back(fmt::format("{} of finger{} {}", what, fingers.size() == 1 ? "" : "s",
                              fmt::join(fingers, ", ")));
}

ContactKind kind_of(JointGuide guide) {
  return guide == JointGuide::tube ? ContactKind::tube : ContactKind::bearing;
}

}  // namespace

ValueUse::ValueUse(const Hardware& hardware, std::vector<ContactKind> kinds, LawValue value)
    : builder_(hardware), hardware_(hardware), kinds_(std::move(kinds)), value_(value) {}

bool ValueUse::is_of_kind(ContactKind kind) const {
  return std::ranges::find(kinds_, kind) != kinds_.end();
}

const FingerHardware* ValueUse::own_values(int finger) const {
  const auto own = std::ranges::find(hardware_.fingers, finger, &FingerHardware::finger);
  return own == hardware_.fingers.end() ? nullptr : &*own;
}

void ValueUse::look_at(const Network& network) {
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      if (is_of_kind(network.contacts[tendon.first_contact + k].kind)) look_at(network, tendon, k);
    }
  }
  if (value_ == LawValue::mu) look_at_guides(network.fingers);
}

bool ValueUse::is_owned_by_finger(const Contact& contact) const {
  const FingerHardware* own = own_values(contact.finger);
  if (own == nullptr) return false;
  const bool tip = contact.place == ContactPlace::tip;
  if (value_ == LawValue::mu) return (tip ? own->tip_mu : own->sheath_mu).has_value();
  return (tip ? own->tip_angle_rad : own->sheath_angle_rad).has_value();
}

void ValueUse::look_at(const Network& network, const TendonSpan& tendon, std::size_t k) {
  const Contact& contact = network.contacts[tendon.first_contact + k];
  const bool is_mu = value_ == LawValue::mu;
  const ContactHardware* own = builder_.own_values(network, tendon, k);
  if (!is_mu && contact.angle.is_given()) {
    in_word_ = true;
  } else if (own != nullptr && (is_mu ? own->mu : own->angle_rad)) {
    contacts_.insert(name_of(*own));
  } else if (is_owned_by_finger(contact)) {
    (contact.place == ContactPlace::tip ? tips_ : sheaths_).insert(contact.finger);
  } else {
    is_taken_ = true;
  }
}

void ValueUse::look_at_guides(int fingers) {
  for (int finger = 1; finger <= fingers; ++finger) {
    const FingerHardware* own = own_values(finger);
    const bool has_own = own != nullptr && !own->parts.joints.empty();
    for (const FingerJoint& joint : (has_own ? own->parts : hardware_.finger_parts).joints) {
      if (joint.guide == JointGuide::none || joint.mu) continue;
      is_taken_ = is_taken_ || is_of_kind(kind_of(joint.guide));
    }
  }
}

bool ValueUse::has_owners() const {
  return in_word_ || !tips_.empty() || !sheaths_.empty() || !contacts_.empty();
}

std::string ValueUse::owners() const {
  std::vector<std::string> parts;
  add_fingers("tips", tips_, parts);
  add_fingers("sheaths", sheaths_, parts);
  for (const std::string& contact : contacts_) parts.push_back("contact " + contact);
  if (in_word_) parts.emplace_back("contacts with an angle in the word");
  return fmt::format("{}", fmt::join(parts, " and "));
}

std::string ValueUse::kinds() const {
  std::vector<std::string> names;
  for (const ContactKind kind : kinds_) names.emplace_back(plural_of(kind));
  return fmt::format("{}", fmt::join(names, " or "));
}

LookAtNetworks looks_at(const std::vector<Routing>& routings) {
  return [&routings](ValueUse& use) {
    for (const Routing& routing : routings) use.look_at(expand(routing));
  };
}

std::string left_alone(const std::string& option, const ValueUse& use) {
  return fmt::format("{} leaves {} alone, which have values of their own", option, use.owners());
}

void require_taken(const std::string& option, const ValueUse& use) {
  if (use.is_taken()) return;
  const bool owned = use.has_owners();
  throw InputError(
      {.where = option,
       .what = owned ? fmt::format("it changes nothing, since {} have values of their own",
                                   use.owners())
                     : fmt::format("it changes nothing, since there are no {}", use.kinds()),
       .expected = owned ? "a hardware file without them" : "a routing with them",
       .form = InputForm::unknown});
}

}  // namespace reeve::core
