#include "core/hardware.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/error.hpp"
#include "core/routing.hpp"

namespace reeve {
namespace {

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

}  // namespace

void require_exponent(std::string_view where, double phi) {
  if (!(phi <= max_exponent)) {
    throw InputError(fmt::format("hardware: {}: mu * angle = {}: expected at most {}", where, phi,
                                 max_exponent));
  }
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

}  // namespace reeve
