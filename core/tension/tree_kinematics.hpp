// Computes the closing of fingers and the travel of blocks if blocks tie tendons together.
//
// The carriage travels D = 1, those of several motors as the grasp says, and an end on a spool of
// its own as the hardware says. A block that moves by z
// towards its tails takes up z on each strand of a pass and on a becket, and gives z to a tail. The
// closing fingers of a tree share one dl, by their closing weights; for every tendon
//
//   motor sides + 2 z of each pass + z of each becket = closings + z of each tail
//
// A bar turns freely, so that its arms' take-ups are bound only by a z_l + b z_r = (a + b) z, a : b
// the ratio of the tensions; behind a bar the tendon's equation goes on with weight b / a.
//
// In a tree of two tendons a block these are as many equations as unknowns (dl and each z). Where a
// block ties more tendons together they can ask for different closings. As a tendon can only pull,
// some may then be slack: the right side is greater than the left one. Taut are those that the
// least common dl needs (least_motion.hpp), and those that its motion would leave too short.
// Fingers on slack tendons alone do not close. The closings of the others are as equal as the
// taut tendons let them, minimising Σ_f (dl_f − w_f dl)² / w_f. If no dl leaves every tendon long
// enough, or nothing yields (no finger closes, and no carriage lets out), the tree jams. A held
// branch is no jam: its block stands still.
#pragma once

#include <vector>

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/tension_fault.hpp"

namespace reeve::core {

struct TreeState {
  bool jams = false;
  TensionFault fault = TensionFault::none;  // that of one tree
  std::vector<char> slack = {};             // one for each tendon of the network; empty if none is

  bool moves() const { return !jams && fault == TensionFault::none; }
};

// The weight behind a bar over that before it.
inline double behind_bar(const Network& network, const Contact& bar) {
  const ArmRatio& arms = network.blocks[bar.block].arms;
  return static_cast<double>(arms.right) / arms.left;
}

// The weight of each segment's length in its tendon's equation: 1 but behind unequal bars. Calls
// visit(segment, weight) from the first segment to the last.
template <typename Visit>
void for_each_weighted_segment(const Network& network, const TendonSpan& tendon, Visit visit) {
  double weight = 1;
  for (std::size_t i = 0; i < tendon.segments; ++i) {
    visit(tendon.first_segment + i, weight);
    if (i >= tendon.contacts) continue;
    const Contact& contact = network.contacts[tendon.first_contact + i];
    if (contact.kind == ContactKind::bar) weight *= behind_bar(network, contact);
  }
}

// Calls visit(segment, block, sign, weight) wherever a block pulls at a tendon: sign +1 at passes,
// arms and beckets, −1 at tails; the weight is the segment's.
template <typename Visit>
void for_each_pull(const Network& network, const TendonSpan& tendon, Visit visit) {
  const auto at_end = [&](const TendonEnd& end, std::size_t segment, double weight) {
    if (end.tie == EndTie::none) return;
    visit(segment, end.block, end.tie == EndTie::tail ? -1.0 : 1.0, weight);
  };
  double weight = 1;
  at_end(tendon.left, tendon.first_segment, weight);
  for (std::size_t k = 0; k < tendon.contacts; ++k) {
    const Contact& contact = network.contacts[tendon.first_contact + k];
    if (contact.block == no_block) continue;
    const auto [left, right] = ends_of(tendon, k);
    visit(left, contact.block, 1.0, weight);
    if (contact.kind == ContactKind::bar) weight *= behind_bar(network, contact);
    visit(right, contact.block, 1.0, weight);
  }
  at_end(tendon.right, tendon.first_segment + tendon.segments - 1, weight);
}

inline bool closes(const Segment& segment, const Grasp& grasp) {
  return segment.kind == SegmentKind::strand && !grasp.holds(segment.finger);
}

// Travel of the end of a motor-side segment over D; 0 if it is locked.
inline double end_travel(const Network& network, const Mechanics& mechanics, const Grasp& grasp,
                         std::size_t segment) {
  const Segment& side = network.segments[segment];
  if (grasp.locks(side.number)) return 0;
  return grasp.travel(side.carriage) * mechanics.spool(segment);
}

// The terms of a tendon's equation: calls on_motor(length), on_closing(finger, factor) for what a
// dl of that finger gives up, and on_block(block, factor) for what a z of that block takes up.
template <typename OnMotor, typename OnClosing, typename OnBlock>
void for_each_term(const Network& network, const Mechanics& mechanics, const TendonSpan& tendon,
                   const Grasp& grasp, OnMotor on_motor, OnClosing on_closing, OnBlock on_block) {
  for_each_weighted_segment(network, tendon, [&](std::size_t i, double weight) {
    const Segment& segment = network.segments[i];
    if (segment.kind == SegmentKind::motor_side) {
      on_motor(weight * end_travel(network, mechanics, grasp, i));
    }
    if (closes(segment, grasp)) on_closing(segment.finger, weight * segment.way());
  });
  for_each_pull(network, tendon, [&](std::size_t, std::size_t block, double sign, double weight) {
    on_block(block, sign * weight);
  });
}

// Writes the travel ratios r_f of fingers 1 … n, 0 for those of other trees. Returns false if the
// tendons do not settle every block's motion for themselves, or if some λ or r_f < 0. Tendons
// settle it if there is one block less than tendons, all independent. They are then in balance
// without friction at tensions λ alone. A common dl follows from the work of these: dl = 1 / Σ_f
// r_f over the fingers that close, r_f = w_f λ·c_f / λ·m. Here c_f and m are a dl of finger f and
// the motor sides in each tendon's equation.
bool travel_ratios(const Network& network, const Mechanics& mechanics, std::size_t tree,
                   std::vector<double>& ratios);

// Writes the tree's part of `closing` (of fingers 1 … n) and of `block_travel` (of the network's
// blocks), both for a pull. In a shared network the fingers close by `given` through other trees,
// `closing` is beyond that, and a tree whose strands on a finger are extensors opens it.
TreeState solve_tree_kinematics(const Network& network, const Mechanics& mechanics, Grasp grasp,
                                std::size_t tree, std::vector<double>& closing,
                                std::vector<double>& block_travel,
                                const std::vector<double>& given = {});

}  // namespace reeve::core
