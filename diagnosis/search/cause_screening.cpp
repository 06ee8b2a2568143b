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
                 const Range& range) {
  constexpr double small = 1e-4;
  const double step = small * (range.high - range.low);
  const double value = model.effects[effect].values.front();
  const auto moved = [&](double to) {
    Model there = model;
    there.effects[effect].values.front() = to;
    return there;
  };
  const double up = std::min(value + step, range.high);
  const double down = std::max(value - step, range.low);
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
                               const std::vector<Effect>& candidates, Workers& workers)
    : all_(dataset) {
  const double scale = force_scale(*dataset.data);
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const auto parameters = searched_parameters(*candidates[c].cause, model.hardware, scale);
    const Range size = parameters.empty() ? Range{} : parameters.front().range;
    for (const std::vector<double>& values : shapes(candidates[c], parameters)) {
      probes_.push_back({c, values, size});
    }
  }
  columns_N_.setZero(at.reading_N.size(), static_cast<Index>(probes_.size()));
  workers.for_each_block(probes_.size(), 1, [&](const IndexBlock& block) {
    const Probe& probe = probes_[block.begin];
    Effect effect = candidates[probe.candidate];
    effect.values = probe.values;
    const Extended with = extended(model, effect);
    auto column = columns_N_.col(static_cast<Index>(block.begin));
    if (probe.has_size()) {
      column = by_size(dataset, with.model, with.effect, probe.size);
    } else if (const auto there = try_forecast(dataset, with.model)) {
      column = there->reading_N - at.reading_N;
    }
  });
}

double CauseScreening::Probe::raw_gain(double along, double square) const {
  if (square == 0) return 0;
  if (!has_size()) return std::max(0.0, along - square / 2);
  const bool possible = along > 0 ? size.high > values.front() : size.low < values.front();
  return possible ? along * along / (2 * square) : 0;
}

void CauseScreening::Probe::add_starts(double first_order, ScreenedCause& to) const {
  if (!has_size()) {
    to.starts = {values};
    return;
  }
  for (const double value :
       {values.front() + first_order, size.low + 0.25 * (size.high - size.low)}) {
    to.starts.push_back(values);
    to.starts.back().front() = std::clamp(value, size.low, size.high);
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
    const double raw = probes_[p].raw_gain(along[k], squares[k]);
    const double gain =
        gain_from_misfits(before, before - 2 * raw, projection.degrees_of_freedom());
    if (!(gain > 0)) continue;
    ScreenedCause& cause = found[probes_[p].candidate];
    cause.candidate = probes_[p].candidate;
    cause.gain = std::max(cause.gain, gain);
    probes_[p].add_starts(along[k] / squares[k], cause);
  }
  std::vector<ScreenedCause> result;
  for (auto& [candidate, cause] : found) result.push_back(std::move(cause));
  std::ranges::stable_sort(result, [](const auto& a, const auto& b) { return a.gain > b.gain; });
  return result;
}

}  // namespace reeve::diagnosis
