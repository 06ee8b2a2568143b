// How far the first place is from changing hands.
//
// The lead of a design over another is the difference of their products mean uniformity × mean
// efficiency, by which designs of one front are ordered. Its least value over all coefficients in
// their ranges says whether the order is safe (positive) or where it would turn (negative), and the
// coefficients at which it is least are the ones to measure. Where uncertainty.hpp samples, this
// looks for the worst case: over the whole box, and from the least of its corners and the nominal
// coefficients. Leads have kinks, and what is found is the least that was seen.
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
  int evaluations = 1000;  // for each challenger and each of three stages
  int threads = 0;
};

// Of the first design over each of the others, in the order of their ranks. Nothing if stopped. The
// front must be that of the two means: then the first has the greatest product.
std::optional<std::vector<Margin>> margins(const std::vector<Routing>& ranked,
                                           const MarginOptions& options,
                                           const Supervision& supervision = {});

}  // namespace reeve::search
