#include "diagnosis/model/prediction.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace reeve {
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

const TensionState& Predictor::at(const Reading& reading) {
  const Key key{reading.routing, reading.grasp.held, reading.direction, reading.sheath_angle_rad};
  const auto found = solved_.find(key);
  if (found != solved_.end()) return found->second;
  try {
    return solved_.emplace(key, solve(reading)).first->second;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}:{}: {}", data_.file, reading.line, error.what()));
  }
}

TensionState Predictor::solve(const Reading& reading) {
  const Network& network = data_.routings[reading.routing].network;
  const Mechanics mechanics = reeve::mechanics(
      network, reading.sheath_angle_rad ? with_sheath_angle(hardware_, *reading.sheath_angle_rad)
                                        : hardware_);
  TensionState state;
  solver_.solve(network, mechanics, reading.grasp, reading.direction, state);
  return state;
}

}  // namespace reeve
