#include "reports/mujoco/mjcf_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/mechanics.hpp"
#include "core/tension/tension.hpp"

namespace reeve::reports {
namespace {

constexpr double finger_pitch_m = 0.03;
constexpr double strand_gap_m = 0.008;
constexpr double lane_pitch_m = 0.012;
constexpr double margin_m = 0.02;
// Slider in place of a finger without joints: its strands give up half of their length at most,
// against a spring that a pull of 10 N stretches by a fifth of the usual 100 mm.
constexpr double slider_share = 0.5;
constexpr double slider_spring_N_m = 500;

double strand_mm(const Hardware& hardware, int finger) {
  for (const FingerHardware& own : hardware.fingers) {
    if (own.finger == finger && own.strand_mm) return *own.strand_mm;
  }
  return hardware.strand_mm;
}

RigFinger slider(double length_m, double weight) {
  RigFinger finger;
  finger.closing_m = slider_share * length_m;
  finger.spring_N_m = slider_spring_N_m / weight;
  finger.reach_m = length_m;
  return finger;
}

RigFinger jointed(const HandFinger& hand, double length_m) {
  RigFinger finger;
  finger.joints = hand.joints;
  finger.closing_m = hand.excursion_mm * m_per_mm;
  finger.reach_m = std::max(length_m, finger.closing_m + margin_m);
  return finger;
}

std::vector<RigFinger> rig_fingers(const Network& network, const Hardware& hardware,
                                   const Mechanics& mechanics) {
  const std::optional<Hand> known = hand(hardware);
  std::vector<RigFinger> fingers;
  for (int f = 1; f <= network.fingers; ++f) {
    const double length_m = strand_mm(hardware, f) * m_per_mm;
    fingers.push_back(known ? jointed(known->finger(f), length_m)
                            : slider(length_m, mechanics.closing[static_cast<std::size_t>(f) - 1]));
    fingers.back().y_m = finger_pitch_m * (f - 1);
  }
  return fingers;
}

// No block travels further for each millimetre that fingers close, and no extensor is let out
// further. It serves where fingers have second tendons, which may jam with all carriages alike.
constexpr double ample_travel = 2;

double closing_together(const TensionState& state) {
  return std::accumulate(state.closing.begin(), state.closing.end(), 0.0);
}

// Returns the travel of each block for each millimetre that fingers close.
std::vector<double> travel_per_closing(const Network& network, const Mechanics& mechanics) {
  std::vector<double> greatest(network.blocks.size(), network.shared ? ample_travel : 0);
  for (const WeightedGrasp& grasp : single_grasps(network.fingers)) {
    const TensionState state = tensions(network, mechanics, grasp.grasp);
    const double closing = closing_together(state);
    if (!(closing > 0)) continue;
    for (std::size_t b = 0; b < greatest.size(); ++b) {
      greatest[b] = std::max(greatest[b], std::abs(state.block_travel[b]) / closing);
    }
  }
  return greatest;
}

// A spool that is wound the other way lets its end out while the fingers close.
double let_out_per_closing(const Network& network, const Mechanics& mechanics) {
  if (network.shared) return ample_travel;
  double least = 0;
  for (const double ratio : mechanics.spools) least = std::min(least, ratio);
  if (least == 0) return 0;
  const double closing = closing_together(tensions(network, mechanics, Grasp{}));
  return closing > 0 ? -least / closing : 0;
}

// Legs have lanes of their own among those of one finger or block, or of all motors.
std::pair<Mover, std::size_t> place_of(const Leg& leg) {
  if (leg.mover == Mover::runner) return {leg.mover, leg.owner};
  return leg.mover < Mover::block ? std::pair{Mover::carriage, std::size_t{0}}
                                  : std::pair{Mover::block, leg.owner};
}

// The lane of a leg, from 0.
std::size_t lane_of(const RopePlan& plan, std::size_t leg) {
  std::size_t lane = 0;
  for (std::size_t k = 0; k < leg; ++k) {
    if (place_of(plan.legs[k]) == place_of(plan.legs[leg])) ++lane;
  }
  return lane;
}

std::vector<RigEnd> ends_apart(const Network& network, const Mechanics& mechanics, RopePlan& plan) {
  std::vector<RigEnd> ends;
  for (std::size_t k = 0; k < plan.legs.size(); ++k) {
    if (plan.legs[k].mover != Mover::carriage) continue;
    const auto segment = find_segment(network, *segment_named(plan.legs[k].name));
    RigEnd end{k, mechanics.spool(*segment), {}};
    if (!mechanics.springs_mm.empty() && mechanics.springs_mm[*segment] > 0) {
      end.spring_N_m = mechanics.EA_N / mechanics.springs_mm[*segment] / m_per_mm;
    }
    if (end.ratio == 1 && !end.spring_N_m) continue;
    plan.legs[k].mover = Mover::own_end;
    ends.push_back(end);
  }
  return ends;
}

}  // namespace

RigLayout rig_layout(const Network& network, const Hardware& hardware, RopePlan& plan) {
  const Mechanics numbers = mechanics(network, hardware);
  RigLayout layout;
  layout.ends = ends_apart(network, numbers, plan);
  layout.fingers = rig_fingers(network, hardware, numbers);
  double all_closing_m = 0;
  for (const RigFinger& finger : layout.fingers) all_closing_m += finger.closing_m;
  layout.let_out_m = let_out_per_closing(network, numbers) * all_closing_m;
  double y_m = finger_pitch_m * network.fingers;
  for (const double travel : travel_per_closing(network, numbers)) {
    layout.blocks.push_back({travel * all_closing_m + margin_m, y_m});
    y_m += finger_pitch_m;
  }
  return layout;
}

RigPlace mover_place(const RigLayout& layout, const RopePlan& plan, std::size_t leg) {
  const Leg& what = plan.legs[leg];
  const double lane = static_cast<double>(lane_of(plan, leg));
  if (what.mover == Mover::runner) {
    const RigFinger& finger = layout.fingers[what.owner - 1];
    return {finger.reach_m, finger.y_m + (lane - 0.5) * strand_gap_m};
  }
  if (what.mover < Mover::block) return {carriage_x_m, lane * lane_pitch_m};
  const RigBlock& block = layout.blocks[what.owner];
  return {carriage_x_m / 2, block.y_m + lane * strand_gap_m};
}

RigPlace eyelet_place(const RigLayout& layout, const RopePlan& plan, std::size_t leg) {
  const Leg& what = plan.legs[leg];
  RigPlace place = mover_place(layout, plan, leg);
  if (what.mover == Mover::runner) {
    const RigFinger& finger = layout.fingers[what.owner - 1];
    place.x_m = what.is_tail ? finger.reach_m + finger.closing_m + margin_m : 0;
  } else if (what.mover < Mover::block) {
    place.x_m += margin_m + layout.let_out_m;
  } else {
    const double reach = layout.blocks[what.owner].reach_m;
    place.x_m += what.is_tail ? -reach : reach;
  }
  return place;
}

void MjcfText::open(const char* name, const Attributes& attributes) {
  xml_.OpenElement(name);
  for (const auto& [key, value] : attributes) xml_.PushAttribute(key, value.c_str());
}

void MjcfText::leaf(const char* name, const Attributes& attributes) {
  open(name, attributes);
  close();
}

std::string MjcfText::number(double value) { return fmt::format("{:.9g}", value); }

std::string MjcfText::point(double x_m, double y_m) {
  return number(x_m) + " " + number(y_m) + " 0";
}

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
    case Mover::own_end:
      return "end_" + leg.name;
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
