// How much a diagnosis hangs on readings whose stretch stands apart (losses.hpp): the named causes
// fitted again to all readings without them.
//
// Of the two readings beside such a stretch the one goes that the extended model meets less well.
#pragma once

#include <optional>
#include <vector>

#include "diagnosis/fit/intervals.hpp"
#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/verdict/compared_cell.hpp"
#include "diagnosis/verdict/losses.hpp"

namespace reeve::diagnosis {

struct WithoutApart {
  std::vector<Cell> left_out;
  Model model;
  std::vector<std::vector<ParameterInterval>> intervals;  // as of parameter_intervals
  // Mean over the routings, of all readings (share_error.hpp); none where none has all strands, or
  // the model no tensions at one that is left out.
  std::optional<double> share_error;
};

// Nothing if no stretch stands apart, or the model has no parameter. `scatter.noise` is estimated
// anew if it is what the model leaves.
std::optional<WithoutApart> without_apart(const MeasuredData& data, const Model& model,
                                          Scatter scatter, const std::vector<ComparedCell>& cells,
                                          const std::vector<Loss>& losses, Workers& workers);

}  // namespace reeve::diagnosis
