#include "core/hardware.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/hand/hand.hpp"
#include "core/hand/hand_fault.hpp"
#include "core/routing.hpp"

namespace reeve::core {
namespace {

struct Bounds {
  double low = 0;
  double high = 0;
  const char* unit = "";
};
constexpr Bounds coefficients{0, 10, ""};
constexpr Bounds angles{0, 1000, "rad"};
constexpr Bounds lengths{1e-3, 1e6, "mm"};
constexpr Bounds closing_weights{1e-3, 1e3, ""};

class FaultFinder {
 public:
  const std::optional<InputFault>& first() const { return first_; }

  void look_at(const Hardware& hardware) {
    law("tube", hardware.tube);
    law("bearing", hardware.bearing);
    law("sheath", hardware.sheath);
    if (hardware.block) law("block", *hardware.block);
    range("lengths", "strand_mm", hardware.strand_mm, lengths);
    range("lengths", "motor_side_mm", hardware.motor_side_mm, lengths);
    range("lengths", "hand_mm", hardware.hand_mm, lengths);
    std::uint64_t seen = 0;
    for (const FingerHardware& finger : hardware.fingers) {
      look_at(finger, hardware);
      if (first_) return;
      const std::uint64_t bit = std::uint64_t{1} << (finger.finger - 1);
      if ((seen & bit) != 0) {
        first_ = {.where = "hardware",
                  .what = fmt::format("finger {} is given twice", finger.finger)};
      }
      seen |= bit;
    }
    for (const ContactHardware& contact : hardware.contacts) look_at(contact);
    if (!first_) first_ = hand_fault(hardware);
  }

 private:
  static InputFault fault(std::string where, std::string what, double value, std::string expected) {
    return {.where = std::move(where),
            .what = std::move(what),
            .value = fmt::format("{}", value),
            .expected = std::move(expected),
            .form = InputForm::equals};
  }

  void range(std::string_view where, std::string_view what, const std::optional<double>& value,
             const Bounds& bounds) {
    if (first_ || !value || (*value >= bounds.low && *value <= bounds.high)) return;
    first_ = fault("hardware", fmt::format("{}.{}", where, what), *value,
                   fmt::format("a number from {} to {}{}{}", bounds.low, bounds.high,
                               *bounds.unit == 0 ? "" : " ", bounds.unit));
  }

  void exponent(std::string_view where, double phi) {
    if (first_ || phi <= max_exponent) return;
    first_ = fault(fmt::format("hardware: {}", where), "mu * angle", phi,
                   fmt::format("at most {}", max_exponent));
  }

  void law(std::string_view where, const ContactLaw& law) {
    range(where, "mu", law.mu, coefficients);
    range(where, "angle_rad", law.angle_rad, angles);
    exponent(where, law.exponent());
  }

  void look_at(const FingerHardware& finger, const Hardware& hardware) {
    if (!first_ && !(finger.finger >= 1 && finger.finger <= max_fingers)) {
      first_ = fault("hardware", "finger number", finger.finger,
                     fmt::format("a number from 1 to {}", max_fingers));
    }
    const std::string where = fmt::format("finger.{}", finger.finger);
    range(where, "tip_mu", finger.tip_mu, coefficients);
    range(where, "tip_angle_rad", finger.tip_angle_rad, angles);
    range(where, "sheath_mu", finger.sheath_mu, coefficients);
    range(where, "sheath_angle_rad", finger.sheath_angle_rad, angles);
    range(where, "strand_mm", finger.strand_mm, lengths);
    range(where, "closing", finger.closing, closing_weights);
    for (const ContactLaw& tip : {hardware.tube, hardware.bearing}) {
      exponent(where + " tip",
               finger.tip_mu.value_or(tip.mu) * finger.tip_angle_rad.value_or(tip.angle_rad));
    }
    exponent(where + " sheath", finger.sheath_mu.value_or(hardware.sheath.mu) *
                                    finger.sheath_angle_rad.value_or(hardware.sheath.angle_rad));
  }

  void look_at(const ContactHardware& contact) {
    const std::string where = fmt::format("contact {}-{}", contact.segment, contact.other_segment);
    range(where, "mu", contact.mu, coefficients);
    range(where, "angle_rad", contact.angle_rad, angles);
  }

  std::optional<InputFault> first_;
};

// Its own numbers, or those of all: tip and sheath coefficients, length and share.
std::array<double, 8> coefficients_of(const Hardware& hardware, int finger) {
  const auto found =
      std::find_if(hardware.fingers.begin(), hardware.fingers.end(),
                   [&](const FingerHardware& candidate) { return candidate.finger == finger; });
  const FingerHardware own = found == hardware.fingers.end() ? FingerHardware{} : *found;
  return {own.tip_mu.value_or(hardware.tube.mu),
          own.tip_angle_rad.value_or(hardware.tube.angle_rad),
          own.tip_mu.value_or(hardware.bearing.mu),
          own.tip_angle_rad.value_or(hardware.bearing.angle_rad),
          own.sheath_mu.value_or(hardware.sheath.mu),
          own.sheath_angle_rad.value_or(hardware.sheath.angle_rad),
          own.strand_mm.value_or(hardware.strand_mm),
          own.closing.value_or(1)};
}

}  // namespace

std::optional<InputFault> fault(const Hardware& hardware) {
  FaultFinder finder;
  finder.look_at(hardware);
  return finder.first();
}

void validate(const Hardware& hardware) {
  if (const auto found = fault(hardware)) throw InputError(*found);
}

bool treats_fingers_alike(const Hardware& hardware, int fingers) {
  if (!hardware.contacts.empty()) return false;
  for (int finger = 2; finger <= fingers; ++finger) {
    if (coefficients_of(hardware, finger) != coefficients_of(hardware, 1)) return false;
    if (finger_parts(hardware, finger) != finger_parts(hardware, 1)) return false;
  }
  return true;
}

}  // namespace reeve::core
