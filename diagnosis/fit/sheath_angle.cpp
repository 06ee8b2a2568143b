#include "diagnosis/fit/sheath_angle.hpp"

#include <string>

#include "core/network.hpp"

namespace reeve::diagnosis {
namespace {

// A sheath lies between a motor-side segment and one at the hand; the pulley of a P lies between
// two motor-side segments.
bool is_sheath(const ContactHardware& contact) {
  const auto is_motor_side = [](const std::string& segment) {
    return parse_segment(segment).kind == SegmentKind::motor_side;
  };
  return is_motor_side(contact.segment) != is_motor_side(contact.other_segment);
}

}  // namespace

Hardware with_sheath_angle(Hardware hardware, double angle_rad) {
  hardware.sheath.angle_rad = angle_rad;
  for (FingerHardware& finger : hardware.fingers) finger.sheath_angle_rad.reset();
  for (ContactHardware& contact : hardware.contacts) {
    if (is_sheath(contact)) contact.angle_rad.reset();
  }
  return hardware;
}

}  // namespace reeve::diagnosis
