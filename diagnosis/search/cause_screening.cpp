#include "diagnosis/search/cause_screening.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/fit/evidence.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The slope by the size, in N; it is 0 where the model has no tensions beside it.
VectorXd by_size(const Dataset& dataset, const Model& model, std::size_t effect,
                 const Parameter& parameter) {
  constexpr double small = 1e-4;
  const double step = small * (parameter.range.high - parameter.range.low);
  const double value = model.effects[effect].values.front();
  const auto moved = [&](double to) {
    Model there = model;
    there.effects[effect].values.front() = to;
    return there;
  };
  const double up = std::min(value + step, parameter.range.high);
  const double down = std::max(value - step, parameter.range.low);
  return reading_slope(dataset, moved(down), moved(up), up - down)
      .value_or(VectorXd::Zero(static_cast<Index>(dataset.cells.size())));
}

}  // namespace

double gain_from_misfits(double before, double after, double degrees_of_freedom) {
  constexpr double least_remainder = 1e-300;
  if (!(before > 0) || after >= before) return 0;
  return degrees_of_freedom / 2 * std::log(before / std::max(after, least_remainder * before));
}

CauseScreening::CauseScreening(const Dataset& dataset, const Model& model, const Forecast& at,
                               const std::vector<Candidate>& candidates, Workers& workers)
    : all_(dataset), candidates_(candidates) {
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    for (const std::vector<double>& values : shapes(candidates[c])) probes_.push_back({c, values});
  }
  columns_N_.setZero(at.reading_N.size(), static_cast<Index>(probes_.size()));
  workers.for_each_block(probes_.size(), 1, [&](const IndexBlock& block) {
    const Probe& probe = probes_[block.begin];
    Effect effect = candidates[probe.candidate].effect;
    effect.values = probe.values;
    const Extended with = extended(model, effect);
    auto column = columns_N_.col(static_cast<Index>(block.begin));
    if (has_size(probe)) {
      column =
          by_size(dataset, with.model, with.effect, candidates[probe.candidate].parameters.front());
    } else if (const auto there = try_forecast(dataset, with.model)) {
      column = there->reading_N - at.reading_N;
    }
  });
}

double CauseScreening::raw_gain(const Probe& probe, double along, double square) const {
  if (square == 0) return 0;
  if (!has_size(probe)) return std::max(0.0, along - square / 2);
  const Range range = candidates_[probe.candidate].parameters.front().range;
  const double nominal = probe.values.front();
  const bool possible = along > 0 ? range.high > nominal : range.low < nominal;
  return possible ? along * along / (2 * square) : 0;
}

void CauseScreening::add_starts(const Probe& probe, double size, ScreenedCause& to) const {
  if (!has_size(probe)) {
    to.starts = {probe.values};
    return;
  }
  const Range range = candidates_[probe.candidate].parameters.front().range;
  for (const double value :
       {probe.values.front() + size, range.low + 0.25 * (range.high - range.low)}) {
    to.starts.push_back(probe.values);
    to.starts.back().front() = std::clamp(value, range.low, range.high);
  }
}

std::vector<ScreenedCause> CauseScreening::run(const Problem& problem, const Forecast& at,
                                               const Projection& projection,
                                               const VectorXd& residuals) const {
  MatrixXd columns = columns_N_(cells_of_part(all_, *problem.dataset), Eigen::all);
  columns.array().colwise() /= problem.deviation_N.array();
  take_out_scales(problem, at, columns);
  whiten(problem.shared, columns);
  projection.take_out(columns);
  const VectorXd along = columns.transpose() * residuals;
  const VectorXd squares = columns.colwise().squaredNorm().transpose();
  const double before = residuals.squaredNorm();
  std::map<std::size_t, ScreenedCause> found;
  for (std::size_t p = 0; p < probes_.size(); ++p) {
    const auto k = static_cast<Index>(p);
    const double raw = raw_gain(probes_[p], along[k], squares[k]);
    const double gain =
        gain_from_misfits(before, before - 2 * raw, projection.degrees_of_freedom());
    if (!(gain > 0)) continue;
    ScreenedCause& cause = found[probes_[p].candidate];
    cause.candidate = probes_[p].candidate;
    cause.gain = std::max(cause.gain, gain);
    add_starts(probes_[p], along[k] / squares[k], cause);
  }
  std::vector<ScreenedCause> result;
  for (auto& [candidate, cause] : found) result.push_back(std::move(cause));
  std::ranges::stable_sort(result, [](const auto& a, const auto& b) { return a.gain > b.gain; });
  return result;
}

}  // namespace reeve::diagnosis
