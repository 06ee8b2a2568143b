// Finds the designs that can give the fingers a wanted ratio of pulls, and says by what.
//
//   by statics    without friction the pulls are in that ratio: forks of tendons, blocks and bars
//                 set it, and friction only disturbs it
//   on friction   only friction on the way to a finger makes the ratio, so that it moves with μ
//
// A pull is the sum of a finger's strands; the miss is that of sizing/goal.hpp, over the target's
// grasps. Two passes: all routings at zero friction, of which the first are kept, and those sized
// at the nominal coefficients (sizing/size.hpp). The order of the first pass: the miss at zero
// friction, then the miss as it is, where they are over met_miss; whether unlike contacts miss;
// motor force, or efficiency without a hand; fewer parts; the word. The second pass has the same
// order, with the sized misses.
// Tendons of several trees on one carriage share its pull by their stiffness, which is no statics:
// such a design counts as one that misses.
// How far a ratio hangs on friction: the sized design with all μ at half and at one and a half of
// their values.
// Unlike contacts: no two contacts of a kind are alike (ContactScatter of core/hardware.hpp), so
// that a ratio by statics may hang on two sheaths being equal. The miss is its 95 % quantile over
// draws of the contacts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "catalog/catalogue.hpp"
#include "search/explore.hpp"
#include "studies/sizing_study.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::studies {

// The number of best routings that are sized, to say how near they can come.
inline constexpr std::size_t most_targeted = 20;
inline constexpr std::array<double, 2> friction_factors{0.5, 1.5};

struct UnlikeContacts {
  double miss = 0;             // 95 % quantile
  std::vector<double> shares;  // of the fingers in all pull, in the draw with that miss
};

struct TargetedDesign {
  SizedRouting sized;
  double static_miss = 0;  // at zero friction; infinite of several trees
  // Shares of the fingers in all pull, of the sized design with all μ times a friction factor.
  std::array<std::vector<double>, friction_factors.size()> moved_shares;
  UnlikeContacts unlike;  // of the sized design

  bool is_by_statics() const { return static_miss <= met_miss; }
  bool is_met() const { return sized.design.after.nominal <= met_miss; }
  bool hangs_on_friction() const { return is_met() && !is_by_statics(); }
};

struct TargetReport {
  SizingOptions sizing;  // with the target
  std::vector<TargetedDesign> designs;
  // routings that meet the target by statics, among all that meet the constraints
  std::uint64_t by_statics = 0;
  bool partial = false;
};

// True if there is a target that no design meets.
bool misses_target(const std::optional<TargetReport>& report);

// All friction coefficients times a factor, effects of a model on the hardware among them.
Model with_friction_times(const Model& model, double factor);

// `sizing` has the target; `explored` the routings and their constraints.
TargetReport target_study(const ExploreOptions& explored, const SizingOptions& sizing,
                          const Catalogue& catalogue, const StudySupervision& supervision = {});

}  // namespace reeve::studies
