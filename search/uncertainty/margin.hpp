// Margin by which the first design keeps its place.
//
// The lead of a design over another is the difference of their products mean uniformity × mean
// efficiency, by which designs of one front are ordered. If its least value over all coefficients
// in their ranges is positive, the order is safe. If it is negative, the order can turn, and the
// coefficients at that point are the ones to measure.
//
// uncertainty.hpp samples; this file searches the whole box for the worst case, starting from the
// least of the corners and the nominal coefficients. Leads have kinks, and the result is the least
// lead found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/hardware.hpp"
#include "core/routing.hpp"
#include "core/uncertainty_ranges.hpp"
#include "search/explore.hpp"

namespace reeve::search {

struct Margin {
  std::string challenger;  // word of the other design
  double nominal_lead = 0;
  double least_lead = 0;
  Hardware at;  // the coefficients of the least lead, effects on them included
};

struct MarginOptions {
  Model nominal;
  UncertaintyRanges ranges;
  GraspSet grasps;
  int evaluations = 1000;  // limit for each challenger and each of three stages
  int threads = 0;
};

// Returns the margins of the first design over each other one, in the order of the ranks. Returns
// nothing if stopped. The front must be that of the two means: the first design then has the
// greatest product.
std::optional<std::vector<Margin>> margins(const std::vector<Routing>& ranked,
                                           const MarginOptions& options,
                                           const Supervision& supervision = {});

}  // namespace reeve::search
