#include "core/hardware.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/error.hpp"

namespace reeve {
namespace {

// Beyond any physical contact (rope three times round pine has phi = 3), and small enough that
// e^{-phi} along a whole tendon stays a number.
constexpr double max_exponent = 10;

void require_range(std::string_view quantity, double value, double low, double high,
                   std::string_view unit) {
  if (!(value >= low && value <= high)) {
    throw InputError(fmt::format("hardware: {} = {}: expected a number from {} to {}{}{}", quantity,
                                 value, low, high, unit.empty() ? "" : " ", unit));
  }
}

void require_mu(std::string_view quantity, double mu) { require_range(quantity, mu, 0, 10, ""); }
void require_angle(std::string_view quantity, double angle) {
  require_range(quantity, angle, 0, 1000, "rad");
}
void require_length(std::string_view quantity, double length) {
  require_range(quantity, length, 1e-3, 1e6, "mm");
}

void require_exponent(std::string_view where, double phi) {
  if (!(phi <= max_exponent)) {
    throw InputError(fmt::format("hardware: {}: mu * angle = {}: expected at most {}", where, phi,
                                 max_exponent));
  }
}

void validate(std::string_view where, const ContactLaw& law) {
  require_mu(fmt::format("{}.mu", where), law.mu);
  require_angle(fmt::format("{}.angle_rad", where), law.angle_rad);
  require_exponent(where, law.exponent());
}

template <typename Check>
void if_given(const std::optional<double>& value, const std::string& quantity, Check check) {
  if (value) check(quantity, *value);
}

void validate(const FingerHardware& finger, const Hardware& hardware) {
  require_range("finger number", finger.finger, 1, max_fingers, "");
  const std::string where = fmt::format("finger.{}", finger.finger);
  if_given(finger.tip_mu, where + ".tip_mu", require_mu);
  if_given(finger.tip_angle_rad, where + ".tip_angle_rad", require_angle);
  if_given(finger.sheath_mu, where + ".sheath_mu", require_mu);
  if_given(finger.sheath_angle_rad, where + ".sheath_angle_rad", require_angle);
  if_given(finger.strand_mm, where + ".strand_mm", require_length);
  require_range(where + ".closing", finger.closing, 1e-3, 1e3, "");
  for (const ContactLaw& tip : {hardware.tube, hardware.bearing}) {
    require_exponent(where + " tip",
                     finger.tip_mu.value_or(tip.mu) * finger.tip_angle_rad.value_or(tip.angle_rad));
  }
  require_exponent(where + " sheath",
                   finger.sheath_mu.value_or(hardware.sheath.mu) *
                       finger.sheath_angle_rad.value_or(hardware.sheath.angle_rad));
}

void validate(const ContactHardware& contact) {
  const std::string where = fmt::format("contact {}-{}", contact.segment, contact.other_segment);
  if_given(contact.mu, where + ".mu", require_mu);
  if_given(contact.angle_rad, where + ".angle_rad", require_angle);
}

int number_from_letters(std::string_view text) {
  int number = 0;
  for (const char c : text) {
    if (c < 'a' || c > 'z' || number > 10000) return 0;
    number = 26 * number + (c - 'a' + 1);
  }
  return number;
}

Segment parse_segment(const std::string& text) {
  const bool numbered = text.size() > 1 && text.size() < 6 && (text[0] == 'T' || text[0] == 'h') &&
                        text.find_first_not_of("0123456789", 1) == std::string::npos &&
                        text[1] != '0';
  if (numbered) {
    const int number = std::stoi(text.substr(1));
    if (text[0] == 'T') return {SegmentKind::strand, number, (number + 1) / 2};
    return {SegmentKind::hand, number, 0};
  }
  const int number = number_from_letters(text);
  if (number == 0) {
    throw InputError(fmt::format(
        "hardware: contact: segment '{}': expected a strand (T1), a motor-side segment (a) or a "
        "stretch at the hand (h1)",
        text));
  }
  return {SegmentKind::motor_side, number, 0};
}

bool same(const Segment& a, const Segment& b) { return a.kind == b.kind && a.number == b.number; }

}  // namespace

int highest_finger(const ContactHardware& contact) {
  return std::max(parse_segment(contact.segment).finger,
                  parse_segment(contact.other_segment).finger);
}

void validate(const Hardware& hardware) {
  validate("tube", hardware.tube);
  validate("bearing", hardware.bearing);
  validate("sheath", hardware.sheath);
  require_length("lengths.strand_mm", hardware.strand_mm);
  require_length("lengths.motor_side_mm", hardware.motor_side_mm);
  require_length("lengths.hand_mm", hardware.hand_mm);
  std::uint64_t seen = 0;
  for (const FingerHardware& finger : hardware.fingers) {
    validate(finger, hardware);
    const std::uint64_t bit = std::uint64_t{1} << (finger.finger - 1);
    if ((seen & bit) != 0) {
      throw InputError(fmt::format("hardware: finger {} is given twice", finger.finger));
    }
    seen |= bit;
  }
  for (const ContactHardware& contact : hardware.contacts) validate(contact);
}

MechanicsBuilder::MechanicsBuilder(const Hardware& hardware) : hardware_(hardware) {
  validate(hardware_);
  for (const ContactKind kind : {ContactKind::tube, ContactKind::bearing, ContactKind::sheath}) {
    const auto i = static_cast<std::size_t>(kind);
    phi_[i] = law(kind).exponent();
    decay_[i] = std::exp(-phi_[i]);
  }
  if (!hardware_.fingers.empty()) by_finger_.resize(max_fingers + 1);
  for (const FingerHardware& finger : hardware_.fingers) {
    by_finger_[static_cast<std::size_t>(finger.finger)] = finger;
  }
  for (const ContactHardware& contact : hardware_.contacts) {
    by_contact_.push_back(
        {parse_segment(contact.segment), parse_segment(contact.other_segment), contact});
  }
}

const ContactLaw& MechanicsBuilder::law(ContactKind kind) const {
  if (kind == ContactKind::tube) return hardware_.tube;
  return kind == ContactKind::bearing ? hardware_.bearing : hardware_.sheath;
}

ContactLaw MechanicsBuilder::law(const Contact& contact) const {
  ContactLaw law = this->law(contact.kind);
  if (contact.finger == 0 || by_finger_.empty()) return law;
  const auto& finger = by_finger_[static_cast<std::size_t>(contact.finger)];
  if (!finger) return law;
  const bool tip = contact.place == ContactPlace::tip;
  law.mu = (tip ? finger->tip_mu : finger->sheath_mu).value_or(law.mu);
  law.angle_rad = (tip ? finger->tip_angle_rad : finger->sheath_angle_rad).value_or(law.angle_rad);
  return law;
}

void MechanicsBuilder::apply(const Network& network, Mechanics& mechanics) const {
  mechanics.length.clear();
  for (const Segment& segment : network.segments) {
    mechanics.length.push_back(segment.kind == SegmentKind::strand       ? hardware_.strand_mm
                               : segment.kind == SegmentKind::motor_side ? hardware_.motor_side_mm
                                                                         : hardware_.hand_mm);
  }
  mechanics.phi.clear();
  mechanics.decay.clear();
  for (const Contact& contact : network.contacts) {
    mechanics.phi.push_back(phi_[static_cast<std::size_t>(contact.kind)]);
    mechanics.decay.push_back(decay_[static_cast<std::size_t>(contact.kind)]);
  }
  mechanics.closing.assign(static_cast<std::size_t>(network.fingers), 1.0);
  if (!by_finger_.empty() || !by_contact_.empty()) apply_overrides(network, mechanics);
}

void MechanicsBuilder::apply_overrides(const Network& network, Mechanics& mechanics) const {
  for (const FingerHardware& finger : hardware_.fingers) {
    if (finger.finger > network.fingers) continue;
    mechanics.closing[static_cast<std::size_t>(finger.finger - 1)] = finger.closing;
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
      if (finger.strand_mm && network.segments[i].finger == finger.finger) {
        mechanics.length[i] = *finger.strand_mm;
      }
    }
  }
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      const std::size_t contact = tendon.first_contact + k;
      ContactLaw law = this->law(network.contacts[contact]);
      for (const ContactOverride& override_ : by_contact_) {
        const Segment& l = network.segments[left];
        const Segment& r = network.segments[right];
        if ((same(override_.a, l) && same(override_.b, r)) ||
            (same(override_.a, r) && same(override_.b, l))) {
          law.mu = override_.law.mu.value_or(law.mu);
          law.angle_rad = override_.law.angle_rad.value_or(law.angle_rad);
        }
      }
      require_exponent(name(network.segments[left]) + "-" + name(network.segments[right]),
                       law.exponent());
      mechanics.phi[contact] = law.exponent();
      mechanics.decay[contact] = std::exp(-law.exponent());
    }
  }
}

std::vector<std::string> MechanicsBuilder::unmatched_contacts(const Network& network) const {
  std::vector<std::string> unmatched;
  for (const ContactOverride& wanted : by_contact_) {
    bool found = false;
    for (const TendonSpan& tendon : network.tendons) {
      for (std::size_t k = 0; k < tendon.contacts; ++k) {
        const Segment& l = network.segments[ends_of(tendon, k).left];
        const Segment& r = network.segments[ends_of(tendon, k).right];
        found |=
            (same(wanted.a, l) && same(wanted.b, r)) || (same(wanted.a, r) && same(wanted.b, l));
      }
    }
    if (!found) unmatched.push_back(wanted.law.segment + "-" + wanted.law.other_segment);
  }
  return unmatched;
}

Mechanics mechanics(const Network& network, const Hardware& hardware) {
  Mechanics result;
  MechanicsBuilder(hardware).apply(network, result);
  return result;
}

}  // namespace reeve
