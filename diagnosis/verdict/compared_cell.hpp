// One measured tension beside what the models say of it.
#pragma once

#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/chosen_readings.hpp"
#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/verdict/left_out.hpp"

namespace reeve::diagnosis {

struct ComparedCell {
  Cell cell;
  bool held_out = false;
  double before_N = 0;     // forecast of the model as it was
  double after_N = 0;      // forecast of the extended model
  double deviation_N = 0;  // with what the reading shares with its mounting
  // In standard deviations, as the diagnosis takes them (problem.hpp): measured less what a sensor
  // would read on average that cannot read below 0, without what a free scale explains.
  double residual_before = 0;
  double residual_after = 0;
  std::optional<double> left_out_N;  // forecast of the causes fitted without its run (left_out.hpp)
};

// All cells of the sample, in the order of the lines.
std::vector<ComparedCell> compared_cells(const Sample& sample, const Model& before,
                                         const Model& after, const Scatter& scatter,
                                         const std::vector<LeftOutRun>& left_out, Workers& workers);

}  // namespace reeve::diagnosis
