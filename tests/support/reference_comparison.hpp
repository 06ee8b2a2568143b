// A solver's answer beside the reference model's, and what holds for either.
#pragma once

#include <string>

#include "tests/support/reference_model.hpp"

namespace reeve::testing {

struct ComparisonTolerance {
  double tension = 1e-6;   // relative
  double slack = 1e-15;    // of T_M: what counts as no tension
  double movement = 1e-9;  // of slips and closings, at D = 1
};

// The first disagreement in words, or nothing. `observed` is to be filled in as the reference model
// does: tensions by the names of the segments, contacts by those of their left and right one in the
// order of the walk, the closings of all fingers. Slips in a loop of which more than one turn has
// the least sum phi |slip| are not compared.
std::string disagreement(const std::string& word, const ReferenceResult& expected,
                         const ReferenceResult& observed,
                         const ComparisonTolerance& tolerance = {});

// Sum of T dl over the strands: what arrives at the fingers of the work T_M D = 1.
double work_on_fingers(const ReferenceResult& result);

}  // namespace reeve::testing
