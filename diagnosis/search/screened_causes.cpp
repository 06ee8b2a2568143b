#include "diagnosis/search/screened_causes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/search/calibration.hpp"

namespace reeve::diagnosis {
namespace {

bool is_law_of_friction(const Candidate& candidate) {
  const Reach reach = candidate.effect.cause->reach();
  return reach == Reach::hardware || reach == Reach::conditions || reach == Reach::load;
}

std::vector<Candidate> not_in(const Model& model, const std::vector<Candidate>& candidates) {
  std::vector<Candidate> result;
  for (const Candidate& candidate : candidates) {
    const bool taken =
        std::any_of(model.effects.begin(), model.effects.end(),
                    [&](const Effect& effect) { return effect_name(effect) == candidate.name; });
    if (!taken) result.push_back(candidate);
  }
  return result;
}

// What no reading could show stands for something else.
bool shows(const Effect& effect, const Dataset& dataset) {
  if (!effect.subject.channel) return true;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const Cell& cell : dataset.cells) {
    if (dataset.data->channels[cell.channel].segment != *effect.subject.channel) continue;
    least = std::min(least, cell.measured_N);
    greatest = std::max(greatest, cell.measured_N);
  }
  return effect.cause->shows_between(least, greatest, effect);
}

}  // namespace

double gain_from_misfits(double before, double after, double degrees_of_freedom) {
  constexpr double least_remainder = 1e-300;
  if (!(before > 0) || after >= before) return 0;
  return degrees_of_freedom / 2 * std::log(before / std::max(after, least_remainder * before));
}

Screening::Screening(const Problem& problem, const Model& model, const Forecast& at,
                     const Projection& projection, const std::vector<Candidate>& candidates,
                     Workers& workers)
    : candidates_(candidates), degrees_(projection.degrees_of_freedom()) {
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    for (const std::vector<double>& values : shapes(candidates[c])) {
      Probe probe{c, values, candidates[c].has_size(), 0, {}};
      if (probe.has_size) {
        probe.nominal = values.front();
        probe.range = candidates[c].parameters.front().range;
      }
      probes_.push_back(std::move(probe));
    }
  }
  columns_.setZero(problem.measured_N.size(), static_cast<Eigen::Index>(probes_.size()));
  workers.for_each_block(probes_.size(), 1, [&](const IndexBlock& block) {
    const Probe& probe = probes_[block.begin];
    auto column = columns_.col(static_cast<Eigen::Index>(block.begin));
    Effect effect = candidates[probe.candidate].effect;
    effect.values = probe.values;
    const Extended with = extended(model, effect);
    if (probe.has_size) {
      column = sensitivity(problem, with.model, at, with.effect).col(0);
    } else if (const auto there = try_forecast(*problem.dataset, with.model)) {
      column = difference(problem, at, *there);
    } else {
      column.setZero();  // nothing can be said: the model has no tensions there
    }
  });
  projection.take_out(columns_);
  squares_ = columns_.colwise().squaredNorm();
}

double Screening::raw_gain(std::size_t probe, double along) const {
  const double square = squares_[static_cast<Eigen::Index>(probe)];
  if (square == 0) return 0;
  if (!probes_[probe].has_size) return std::max(0.0, along - square / 2);
  const bool possible = along > 0 ? probes_[probe].range.high > probes_[probe].nominal
                                  : probes_[probe].range.low < probes_[probe].nominal;
  return possible ? along * along / (2 * square) : 0;
}

std::vector<double> Screening::gains_along(const Eigen::VectorXd& along, double before) const {
  std::vector<double> result(candidates_.size(), 0.0);
  for (std::size_t p = 0; p < probes_.size(); ++p) {
    const double raw = raw_gain(p, along[static_cast<Eigen::Index>(p)]);
    const double gain = gain_from_misfits(before, before - 2 * raw, degrees_);
    result[probes_[p].candidate] = std::max(result[probes_[p].candidate], gain);
  }
  return result;
}

std::vector<double> Screening::gains(const Eigen::VectorXd& residuals) const {
  return gains_along(columns_.transpose() * residuals, residuals.squaredNorm());
}

double Screening::greatest_gain(const Eigen::VectorXd& residuals) const {
  const std::vector<double> all = gains(residuals);
  return all.empty() ? 0 : *std::max_element(all.begin(), all.end());
}

std::vector<double> Screening::greatest_gains(const Eigen::MatrixXd& residuals) const {
  const Eigen::MatrixXd along = columns_.transpose() * residuals;
  std::vector<double> result;
  for (Eigen::Index b = 0; b < residuals.cols(); ++b) {
    const std::vector<double> all = gains_along(along.col(b), residuals.col(b).squaredNorm());
    result.push_back(all.empty() ? 0 : *std::max_element(all.begin(), all.end()));
  }
  return result;
}

std::vector<std::vector<double>> Screening::starts(std::size_t candidate,
                                                   const Eigen::VectorXd& residuals) const {
  std::vector<std::vector<double>> result;
  for (std::size_t p = 0; p < probes_.size(); ++p) {
    const Probe& probe = probes_[p];
    if (probe.candidate != candidate) continue;
    if (!probe.has_size) return {probe.values};
    const auto column = static_cast<Eigen::Index>(p);
    const double square = squares_[column];
    const double size = square > 0 ? columns_.col(column).dot(residuals) / square : 0;
    const Range range = probe.range;
    for (const double value : {probe.nominal + size, range.low + 0.25 * (range.high - range.low),
                               range.low + 0.7 * (range.high - range.low)}) {
      result.push_back(probe.values);
      result.back().front() = std::clamp(value, range.low, range.high);
    }
  }
  return result;
}

ScreenedCauses::ScreenedCauses(const Problem& problem, const Model& model,
                               const std::vector<Candidate>& candidates, Workers& workers)
    : problem_(problem),
      model_(model),
      workers_(workers),
      candidates_(not_in(model, candidates)),
      at_(forecast(*problem.dataset, model)),
      projection_(problem, model, at_),
      residuals_(projection_.taken_out(diagnosis::residuals(problem, at_))),
      screening_(problem, model, at_, projection_, candidates_, workers) {}

std::vector<std::size_t> ScreenedCauses::likeliest_without_size() const {
  constexpr std::size_t few = 3;
  const Model start = with_hardware_coefficients(model_);
  std::vector<std::pair<double, std::size_t>> by_misfit;
  for (std::size_t c = 0; c < candidates_.size(); ++c) {
    if (!candidates_[c].has_size()) by_misfit.emplace_back(0, c);
  }
  workers_.for_each_block(by_misfit.size(), 1, [&](const IndexBlock& block) {
    auto& [misfit_of, c] = by_misfit[block.begin];
    misfit_of = misfit(problem_, extended(start, candidates_[c].effect).model);
  });
  std::sort(by_misfit.begin(), by_misfit.end());
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < std::min(few, by_misfit.size()); ++i) {
    result.push_back(by_misfit[i].second);
  }
  return result;
}

std::vector<std::size_t> ScreenedCauses::contenders(std::size_t most, Laws laws) const {
  const std::vector<double> gains = screening_.gains(residuals_);
  std::vector<std::size_t> order(candidates_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return gains[a] > gains[b]; });
  const std::vector<std::size_t> there_or_not = likeliest_without_size();
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t c = order[i];
    const bool promising = i < most && gains[c] > 0;
    const bool always =
        (laws == Laws::always && is_law_of_friction(candidates_[c])) ||
        std::find(there_or_not.begin(), there_or_not.end(), c) != there_or_not.end();
    if (promising || always) result.push_back(c);
  }
  return result;
}

std::vector<Fit> ScreenedCauses::fit_each(const std::vector<std::size_t>& which) const {
  std::vector<Fit> fits(which.size());
  workers_.for_each_block(which.size(), 1, [&](const IndexBlock& block) {
    const std::size_t c = which[block.begin];
    const Extended with = extended(model_, candidates_[c].effect);
    Fit& best = fits[block.begin];
    best = fit(problem_, with.model, with.effect, screening_.starts(c, residuals_));
    if (!shows(best.model.effects[with.effect], *problem_.dataset)) {
      best.misfit = std::numeric_limits<double>::infinity();
    }
    if (candidates_[c].has_size() || parameter_count(model_) == 0) return;
    Fit other = fit(problem_, with_hardware_coefficients(with.model));
    if (other.misfit < best.misfit) best = std::move(other);
  });
  return fits;
}

std::size_t likeliest(const Problem& problem, const std::vector<Fit>& fits) {
  const double degrees = problem.dataset->degrees_of_freedom();
  const auto surprise = [&](const Fit& fit) {
    return degrees * std::log(fit.misfit) +
           static_cast<double>(parameter_count(fit.model)) * std::log(degrees);
  };
  const auto best = std::min_element(fits.begin(), fits.end(), [&](const Fit& a, const Fit& b) {
    return surprise(a) < surprise(b);
  });
  return static_cast<std::size_t>(best - fits.begin());
}

}  // namespace reeve::diagnosis
