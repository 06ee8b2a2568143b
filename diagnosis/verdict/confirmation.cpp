#include "diagnosis/verdict/confirmation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/fit/problem.hpp"
#include "diagnosis/search/rivals.hpp"
#include "numerics/chi_squared.hpp"

namespace reeve::diagnosis {
namespace {

// The models that a diagnosis weighs against each other: that of the named causes, and with each
// rival in the place of the cause that it would stand for.
struct WeighedModel {
  std::vector<std::string> causes;
  Model model;
  double gain = 0;  // in log-likelihood on the training runs, over the nominal model
};

// `rivals` is parallel to the causes, whose names these are. Of several models of the same causes
// only the first. Empty without causes.
std::vector<WeighedModel> weighed_models(const Problem& problem, const Model& nominal,
                                         const Model& extended,
                                         const std::vector<std::string>& causes,
                                         const std::vector<std::vector<Rival>>& rivals) {
  std::vector<WeighedModel> weighed;
  if (causes.empty()) return weighed;
  const double nothing = misfit(problem, nominal);
  const auto add = [&](std::vector<std::string> names, const Model& model, double misfit) {
    const bool known = std::any_of(weighed.begin(), weighed.end(), [&](const WeighedModel& other) {
      return other.causes == names;
    });
    if (!known) weighed.push_back({std::move(names), model, (nothing - misfit) / 2});
  };
  add(causes, extended, misfit(problem, extended));
  for (std::size_t c = 0; c < causes.size(); ++c) {
    for (const Rival& other : rivals[c]) {
      std::vector<std::string> names = causes;
      names.erase(names.begin() + static_cast<std::ptrdiff_t>(c));
      names.insert(names.begin(), other.name);
      add(std::move(names), other.fit.model, other.fit.misfit);
    }
  }
  return weighed;
}

}  // namespace

NoiseLimit noise_limit(const Problem& held_out, const Model& before) {
  const Forecast at = forecast(*held_out.dataset, before);
  const double misfit = residuals(held_out, at).squaredNorm();
  const double degrees = held_out.dataset->degrees_of_freedom();
  NoiseLimit limit;
  limit.log_likelihood_gain = (misfit - degrees) / 2;
  limit.low = (misfit - chi_squared_quantile(0.975, degrees)) / 2;
  limit.high = (misfit - chi_squared_quantile(0.025, degrees)) / 2;
  const auto cells = static_cast<double>(held_out.deviation_N.size());
  limit.rms_N = std::sqrt(noise_variance(held_out, at).sum() / cells);
  return limit;
}

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

Confirmation confirmation(const Problem& training, const Scatter& scatter, const Model& nominal,
                          const Model& extended, const std::vector<AppliedCause>& causes,
                          const std::vector<std::vector<Rival>>& rivals, const Dataset& held_out,
                          std::uint64_t seed, Workers& workers) {
  std::vector<std::string> names;
  for (const AppliedCause& cause : causes) names.push_back(cause.name);
  const auto weighed = weighed_models(training, nominal, extended, names, rivals);
  Confirmation result;
  result.of_causes.resize(causes.size());
  for (const WeighedModel& model : weighed) {
    result.weighed.push_back({model.causes, model.gain, std::nullopt});
  }
  if (held_out.cells.empty()) return result;
  const Problem unseen = problem(held_out, scatter, extended, workers);
  for (std::size_t c = 0; c < causes.size(); ++c) {
    const Fit before = fit(training, without(extended, place(extended, causes[c].effect)));
    result.of_causes[c] = held_out_gain(unseen, before.model, extended, seed + c);
  }
  for (std::size_t i = 0; i < weighed.size(); ++i) {
    // In some held-out row it may have no tensions: nothing to weigh it by.
    if (!try_forecast(held_out, weighed[i].model)) continue;
    result.weighed[i].held_out = held_out_gain(unseen, nominal, weighed[i].model, seed);
  }
  result.noise_limit = noise_limit(unseen, nominal);
  result.run_gains = run_gains(unseen, nominal, extended);
  if (!causes.empty()) result.together = held_out_gain(unseen, nominal, extended, seed);
  return result;
}

}  // namespace reeve::diagnosis
