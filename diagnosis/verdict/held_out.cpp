#include "diagnosis/verdict/held_out.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "numerics/chi_squared.hpp"
#include "numerics/random.hpp"
#include "numerics/streams.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;

constexpr std::size_t draws = 1000;
// With fewer runs there are too few different samples: three runs have ten.
constexpr std::size_t enough_held_out_runs = 5;

// The contribution of one run, or of one reading.
struct Contribution {
  double before = 0;  // Σ of squared residuals, N²
  double after = 0;
  double cells = 0;
  double gain = 0;  // in log-likelihood
};

void add(Contribution& sum, const Contribution& unit, double weight = 1) {
  sum.before += weight * unit.before;
  sum.after += weight * unit.after;
  sum.cells += weight * unit.cells;
  sum.gain += weight * unit.gain;
}

double reduction(const Contribution& sum) {
  return sum.before > 0 ? 1 - std::sqrt(sum.after / sum.before) : 0;
}

// Errors in newton are what the model leaves; the likelihood knows what readings share.
std::vector<Contribution> units(const Problem& problem, const Forecast& first,
                                const Forecast& second) {
  const Eigen::VectorXd before = newton_residuals(problem, first);
  const Eigen::VectorXd after = newton_residuals(problem, second);
  const Eigen::VectorXd likely_before = residuals(problem, first);
  const Eigen::VectorXd likely_after = residuals(problem, second);
  const Dataset& dataset = *problem.dataset;
  std::map<std::size_t, Contribution> by_run;
  std::vector<Contribution> by_row;
  for (const DatasetRow& row : dataset.rows) {
    Contribution unit;
    for (std::size_t i = row.first; i < row.last; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      unit.before += before[k] * before[k];
      unit.after += after[k] * after[k];
      unit.cells += 1;
      unit.gain += (std::pow(likely_before[k], 2) - std::pow(likely_after[k], 2)) / 2;
    }
    by_row.push_back(unit);
    add(by_run[dataset.data->readings[row.reading].run], unit);
  }
  if (by_run.size() < enough_held_out_runs) return by_row;
  std::vector<Contribution> result;
  for (const auto& [run, unit] : by_run) result.push_back(unit);
  return result;
}

double quantile(std::vector<double>& values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

HeldOut held_out_gain(const Problem& held_out, const Forecast& before, const Forecast& after,
                      std::uint64_t seed) {
  const std::vector<Contribution> all = units(held_out, before, after);
  Contribution sum;
  for (const Contribution& unit : all) add(sum, unit);
  HeldOut result;
  result.rms_before_N = std::sqrt(sum.before / sum.cells);
  result.rms_after_N = std::sqrt(sum.after / sum.cells);
  result.reduction = reduction(sum);
  result.log_likelihood_gain = sum.gain;
  result.expected_gain = difference(held_out, after, before).squaredNorm() / 2;
  std::vector<double> reductions, gains;
  for (std::size_t d = 0; d < draws; ++d) {
    Contribution drawn;
    double weights = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double weight = -std::log1p(-uniform(seed, streams::resampling, d * all.size() + i));
      add(drawn, all[i], weight);
      weights += weight;
    }
    reductions.push_back(reduction(drawn));
    gains.push_back(drawn.gain * static_cast<double>(all.size()) / weights);
  }
  result.low = quantile(reductions, 0.025);
  result.high = quantile(reductions, 0.975);
  result.gain_low = quantile(gains, 0.025);
  result.gain_high = quantile(gains, 0.975);
  return result;
}

NoiseLimit noise_limit(const Problem& held_out, const Forecast& before) {
  const double misfit = residuals(held_out, before).squaredNorm();
  const double degrees = held_out.dataset->degrees_of_freedom();
  NoiseLimit limit;
  limit.log_likelihood_gain = (misfit - degrees) / 2;
  limit.low = (misfit - chi_squared_quantile(0.975, degrees)) / 2;
  limit.high = (misfit - chi_squared_quantile(0.025, degrees)) / 2;
  const auto cells = static_cast<double>(held_out.deviation_N.size());
  limit.rms_N = std::sqrt(noise_variance(held_out, before).sum() / cells);
  return limit;
}

std::vector<RunGain> run_gains(const Problem& held_out, const Forecast& before,
                               const Forecast& after) {
  const Dataset& dataset = *held_out.dataset;
  const Eigen::VectorXd first = newton_residuals(held_out, before);
  const Eigen::VectorXd second = newton_residuals(held_out, after);
  const Eigen::VectorXd noise = noise_variance(held_out, after);
  std::map<std::size_t, RunGain> by_run;
  for (std::size_t i = 0; i < dataset.cells.size(); ++i) {
    const auto k = static_cast<Index>(i);
    RunGain& sum = by_run[dataset.data->readings[dataset.cells[i].reading].run];
    sum.cells += 1;
    sum.rms_before_N += std::pow(first[k], 2);
    sum.rms_after_N += std::pow(second[k], 2);
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
