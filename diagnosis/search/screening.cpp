#include "diagnosis/search/screening.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/fit/fit.hpp"

namespace reeve::diagnosis {

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

}  // namespace reeve::diagnosis
