#include "diagnosis/verdict/run_gain.hpp"

#include <cmath>
#include <map>

namespace reeve::diagnosis {

std::vector<RunGain> run_gains(const Problem& held_out, const Model& before, const Model& after) {
  const Dataset& dataset = *held_out.dataset;
  const Eigen::VectorXd first = own_residuals(held_out, forecast(dataset, before));
  const Forecast extended = forecast(dataset, after);
  const Eigen::VectorXd second = own_residuals(held_out, extended);
  const Eigen::VectorXd noise = noise_variance(held_out, extended);
  std::map<std::size_t, RunGain> by_run;
  for (std::size_t i = 0; i < dataset.cells.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const double sd = held_out.deviation_N[k];
    RunGain& sum = by_run[dataset.data->readings[dataset.cells[i].reading].run];
    sum.cells += 1;
    sum.rms_before_N += std::pow(first[k] * sd, 2);
    sum.rms_after_N += std::pow(second[k] * sd, 2);
    sum.rms_noise_N += noise[k];
  }
  std::vector<RunGain> gains;
  for (auto& [run, sum] : by_run) {
    const auto cells = static_cast<double>(sum.cells);
    gains.push_back({run, sum.cells, std::sqrt(sum.rms_before_N / cells),
                     std::sqrt(sum.rms_after_N / cells), std::sqrt(sum.rms_noise_N / cells)});
  }
  return gains;
}

}  // namespace reeve::diagnosis
