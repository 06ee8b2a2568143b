// Contribution of each run: the parameters of a model are fitted again to all runs but one, and
// that run is forecast by them.
//
// Which causes the model has was chosen with all training runs; only their sizes are fitted anew. A
// parameter that the other runs say nothing about goes back to its nominal value.
#pragma once

#include <cstddef>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/dataset.hpp"
#include "diagnosis/fit/mounting_scatter.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

// With more runs none of them matters much, and fitting so often takes long.
inline constexpr std::size_t most_runs_left_out = 40;
inline constexpr std::size_t fewest_runs_left_out = 3;

struct LeftOutRun {
  std::size_t run = 0;  // in MeasuredData::runs
  Model model;          // fitted to the others
  std::vector<Cell> cells;
  std::vector<double> forecast_N;  // parallel to the cells
};

// In the order in which the data name the runs. Empty for a model without parameters, and outside
// the numbers of runs above. `readings` (ascending) are those that take part.
std::vector<LeftOutRun> left_out_runs(const MeasuredData& data,
                                      const std::vector<std::size_t>& readings, const Model& model,
                                      const Scatter& scatter, Workers& workers);

}  // namespace reeve::diagnosis
