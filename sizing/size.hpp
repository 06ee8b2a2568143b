// The dimensions of a routing's parts that make the most of a goal (sizing_problem.hpp).
//
// Each variable has bounds. Globally the box is divided (DIRECT-L), locally several starts descend
// (Subplex): the hardware as it is, and points drawn from the box. From the best of all it descends
// once more, finely. Then what costs nothing is put right: variables that do not matter, alone or
// together, stay as they are, one that all but stands at a bound stands there. The result is the
// same for any number of threads: it is the best that was seen, which for a goal with many narrow
// valleys need not be the best there is.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/hardware.hpp"
#include "core/routing.hpp"
#include "search/explore.hpp"
#include "sizing/joint_tolerance.hpp"
#include "sizing/sizing_problem.hpp"
#include "sizing/tolerance.hpp"

namespace reeve::sizing {

struct SizedVariable {
  SizeVariable variable;
  double value = 0;
  AtBound at = AtBound::no;
  Sensitivity sensitivity;
};

// Goal and objectives with the nominal dimensions or with the sized ones.
struct SizedGoal {
  double goal = 0;     // goal of the search, over the draws of a result
  double nominal = 0;  // the same at the nominal coefficients
  ObjectiveValues values{};
  std::optional<MotorForce> motor{};  // set for a hand
  std::vector<double> shares;         // finger shares of all pull, mean over the grasps
  std::uint64_t unconverged = 0;
};

struct SizedDesign {
  Routing routing;
  std::vector<SizedVariable> variables;  // none: it has none of the dimensions that are varied
  std::vector<FlatDirection> flat;
  std::optional<JointTolerance> together;  // for the variables; nothing if the search was stopped
  SizedGoal before;
  SizedGoal after;
  // For a target: the least miss of the shares within the bounds, at the nominal coefficients, and
  // the shares there.
  std::optional<double> least_miss;
  std::vector<double> nearest_shares;
  Hardware hardware;  // sized hardware, without the effects of the model
};

// A target is met where shares can miss it by no more: a hundredth of all pull, as much as
// tolerances grant.
inline constexpr double met_miss = tolerated_loss;
bool is_met(const SizedDesign& design);

struct SizingResult {
  std::vector<SizedDesign> designs;  // parallel to the routings
  bool partial = false;              // stopped: the best so far, without sensitivities
  std::uint64_t unconverged = 0;     // tension solves behind the values before and after
};

// Throws InputError and OutOfRange of the hardware as it is, for each routing before any is sized.
SizingResult size(const std::vector<Routing>& routings, const SizingOptions& options,
                  const Supervision& supervision = {});

}  // namespace reeve::sizing
