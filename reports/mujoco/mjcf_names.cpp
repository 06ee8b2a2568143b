#include <fmt/format.h>

#include "reports/mujoco/mjcf_rig.hpp"

namespace reeve::reports {

std::string rope_name(std::size_t rope) { return fmt::format("tendon_{}", rope + 1); }

std::string runner_name(std::size_t finger) { return fmt::format("runner_{}", finger + 1); }

std::string joint_name(std::size_t finger, std::size_t joint) {
  return fmt::format("finger_{}_joint_{}", finger + 1, joint + 1);
}

std::string carriage_name(std::size_t motor) {
  return motor == 1 ? "carriage" : fmt::format("carriage_{}", motor);
}

std::string mover_name(const MjcfRig& rig, const Leg& leg) {
  switch (leg.mover) {
    case Mover::runner:
      return runner_name(leg.owner - 1);
    case Mover::carriage:
      return carriage_name(leg.owner);
    case Mover::block:
      return block_name(rig.network.blocks[leg.owner]);
    case Mover::left_arm:
      return block_name(rig.network.blocks[leg.owner]) + "_left";
    case Mover::right_arm:
      break;
  }
  return block_name(rig.network.blocks[leg.owner]) + "_right";
}

std::string site_name(const MjcfRig& rig, const RopePoint& at) {
  if (at.kind == PointKind::fixed) return fmt::format("fixed_{}", at.index + 1);
  return (at.kind == PointKind::eyelet ? "eye_" : "") + rig.plan.legs[at.index].name;
}

}  // namespace reeve::reports
