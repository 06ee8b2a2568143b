#include "diagnosis/verdict/partial_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "diagnosis/fit/fit.hpp"
#include "numerics/matrices.hpp"
#include "numerics/random.hpp"
#include "numerics/student_t.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double covered_by_band = 0.95;
constexpr std::size_t curve_points = 41;
// The limit is in units of the middle deviation.
constexpr double most_deviation = 6;
constexpr std::size_t most_points = 500;
constexpr std::uint32_t thinning_stream = 0x9a7;
// The step is a part of the range of a size, or of a law's own unit: small beside what bends
// forecasts, and great beside what rounding leaves of a difference.
constexpr double small_step = 1e-4;

// One part of the readings, as the extended model sees it.
struct PartView {
  const Dataset& dataset;
  bool held_out;
  Forecast with;
  Forecast without;
  RowContacts contacts;
  VectorXd left_N;       // T − m
  VectorXd deviation_N;  // noise of each reading by itself
  VectorXd by_law;       // S
};

Model with_levers(Model model, const std::vector<Term>& levers, double step) {
  for (const Term& lever : levers) add_effect(model, {&causes::law(lever), {}, {step}});
  return model;
}

Model with_size(Model model, std::size_t effect, double step) {
  model.effects[effect].values.front() += step;
  return model;
}

// A term without size gives ones: what it does is asked for in newton.
std::optional<VectorXd> slope_of(const Dataset& dataset, const Model& model, std::size_t effect,
                                 const TermAxes& axes) {
  if (axes.over == DrawnOver::change) {
    return VectorXd::Ones(static_cast<Index>(dataset.cells.size()));
  }
  if (!axes.levers.empty()) {
    return reading_slope(dataset, with_levers(model, axes.levers, -small_step),
                         with_levers(model, axes.levers, small_step), 2 * small_step);
  }
  const Cause& cause = *model.effects[effect].cause;
  const Range range = cause.parameters(model.hardware).front().range;
  const double step = small_step * (range.high - range.low);
  return reading_slope(dataset, with_size(model, effect, -step), with_size(model, effect, step),
                       2 * step);
}

std::optional<PartView> view(const Dataset& dataset, bool held_out, const Model& model,
                             const Scatter& scatter, std::size_t effect, const TermAxes& axes,
                             Workers& workers) {
  const auto with = try_forecast(dataset, model);
  const auto other = try_forecast(dataset, without(model, effect));
  const auto by_law = slope_of(dataset, model, effect, axes);
  if (!with || !other || !by_law) return std::nullopt;
  const Problem seen = problem(dataset, scatter, model, workers);
  return PartView{dataset,
                  held_out,
                  *with,
                  *other,
                  contacts_of_rows(dataset, model),
                  seen.measured_N - expected_readings(seen, *with),
                  seen.deviation_N,
                  *by_law};
}

// Cells that make a point together.
struct PointCells {
  std::size_t first = 0;
  std::size_t last = 0;
};

bool acts_on_channel(const TermAxes& axes, const Segment& segment) {
  const Site& site = axes.sites.front();
  return site.place == SitePlace::channels || site.channel == segment;
}

std::vector<PointCells> cells_of_points(const TermAxes& axes, const Dataset& dataset) {
  const bool one_by_one = axes.is_of_sensors() || axes.over == DrawnOver::change;
  std::vector<PointCells> result;
  for (const DatasetRow& row : dataset.rows) {
    if (!one_by_one) {
      result.push_back({row.first, row.last});
      continue;
    }
    for (std::size_t i = row.first; i < row.last; ++i) {
      const Segment& segment = dataset.data->channels[dataset.cells[i].channel].segment;
      if (axes.over != DrawnOver::change && !acts_on_channel(axes, segment)) continue;
      result.push_back({i, i + 1});
    }
  }
  return result;
}

// Returns nothing where these cells do not depend on the term.
std::optional<PartialPoint> point(const PartView& part, const TermAxes& axes, const Effect& effect,
                                  const PointCells& of) {
  const PlaceOnAxes place = place_on(
      axes, effect.values, {part.dataset, part.contacts, part.with, part.without, of.first});
  // A factor (1 + a) beside the law's own: p follows f by as much less.
  const double by_factor = axes.multiplies ? 1 + place.y : 1;
  if (!(by_factor > 0)) return std::nullopt;
  double along = 0;
  double square = 0;
  for (std::size_t i = of.first; i < of.last; ++i) {
    const auto k = static_cast<Index>(i);
    const double slope = part.by_law[k] / by_factor;
    const double weight = 1 / (part.deviation_N[k] * part.deviation_N[k]);
    along += weight * slope * part.left_N[k];
    square += weight * slope * slope;
  }
  const double y = place.y + along / square;
  if (!std::isfinite(place.x) || !std::isfinite(y) || !(square > 0)) return std::nullopt;
  return PartialPoint{place.x, y, 1 / std::sqrt(square), part.dataset.cells[of.first].reading,
                      part.held_out};
}

// A reading that a term without size leaves as it is says nothing of it.
bool is_changed(const PartialPoint& point, const TermAxes& axes) {
  constexpr double noticeable = 0.1;  // times its noise
  return axes.over != DrawnOver::change || std::abs(point.x) > noticeable * point.deviation;
}

// Half of what the points know together comes from those that are known better than this.
double middle_deviation(const std::vector<PartialPoint>& points) {
  std::vector<double> deviations;
  for (const PartialPoint& point : points) deviations.push_back(point.deviation);
  std::ranges::sort(deviations);
  double all = 0;
  for (const double deviation : deviations) all += 1 / (deviation * deviation);
  double known = 0;
  for (const double deviation : deviations) {
    known += 1 / (deviation * deviation);
    if (known >= all / 2) return deviation;
  }
  return deviations.back();
}

void leave_out_faint(PartialResiduals& partial) {
  if (partial.points.empty()) return;
  const double most = most_deviation * middle_deviation(partial.points);
  partial.left_out += std::erase_if(
      partial.points, [&](const PartialPoint& point) { return point.deviation > most; });
}

// The same number of points always gives the same places: strides would meet one sensor only.
void thin_out(PartialResiduals& partial) {
  std::vector<PartialPoint>& points = partial.points;
  if (points.size() <= most_points) return;
  std::vector<std::pair<double, std::size_t>> drawn;
  for (std::size_t i = 0; i < points.size(); ++i) {
    drawn.emplace_back(uniform(1, thinning_stream, i), i);
  }
  std::ranges::sort(drawn);
  std::vector<bool> kept(points.size());
  for (std::size_t k = 0; k < most_points; ++k) kept[drawn[k].second] = true;
  std::size_t at = 0;
  partial.thinned = std::erase_if(points, [&](const PartialPoint&) { return !kept[at++]; });
}

// Half the band's width at x.
double half_width(const TermAxes& axes, const std::vector<double>& values,
                  const EffectSpread& spread, double x) {
  if (!spread.covariance.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  VectorXd gradient(static_cast<Index>(values.size()));
  for (std::size_t p = 0; p < values.size(); ++p) {
    const auto k = static_cast<Index>(p);
    const double step = 1e-3 * std::sqrt(spread.covariance(k, k));
    std::vector<double> more = values;
    std::vector<double> less = values;
    more[p] += step;
    less[p] -= step;
    gradient[k] = step > 0 ? (axes.law(more, x) - axes.law(less, x)) / (2 * step) : 0;
  }
  return spread.t * std::sqrt(std::max(0.0, gradient.dot(spread.covariance * gradient)));
}

// For a term without size the slope is that of the points themselves, which should be 1.
double half_width_of_slope(const std::vector<PartialPoint>& points, double x) {
  double square = 0;
  double left = 0;
  for (const PartialPoint& point : points) {
    const double weight = 1 / (point.deviation * point.deviation);
    square += weight * point.x * point.x;
    left += weight * std::pow(point.y - point.x, 2);
  }
  const double degrees = std::max(1.0, static_cast<double>(points.size()) - 1);
  const double scatter = std::sqrt(std::max(1.0, left / degrees));
  return student_t_quantile(0.5 + covered_by_band / 2, degrees) * scatter * std::abs(x) /
         std::sqrt(square);
}

std::vector<CurvePoint> curve(const TermAxes& axes, const Effect& effect,
                              const EffectSpread& spread, const std::vector<PartialPoint>& points) {
  const auto [least, greatest] = std::ranges::minmax_element(points, {}, &PartialPoint::x);
  // Points that all stand at one place get a short piece of curve.
  constexpr double short_piece = 0.05;
  const double beyond = least->x == greatest->x ? short_piece * std::abs(least->x) : 0;
  const double low = least->x - beyond;
  const double high = greatest->x + beyond;
  std::vector<CurvePoint> result;
  for (std::size_t i = 0; i < curve_points; ++i) {
    const double x =
        low + (high - low) * static_cast<double>(i) / static_cast<double>(curve_points - 1);
    const double y = axes.law(effect.values, x);
    const double half = axes.over == DrawnOver::change ? half_width_of_slope(points, x)
                                                       : half_width(axes, effect.values, spread, x);
    result.push_back({x, y, y - half, y + half});
    if (low == high) break;
  }
  return result;
}

bool has_motor_tension(const Dataset& dataset) {
  return std::ranges::any_of(dataset.rows, &DatasetRow::has_motor_tension);
}

}  // namespace

std::vector<EffectSpread> effect_spreads(
    const Problem& problem, const Model& model,
    const std::vector<std::vector<ParameterInterval>>& intervals) {
  const MatrixXd jacobian = sensitivities(problem, model, forecast(*problem.dataset, model));
  const MatrixXd inverse =
      jacobian.cols() > 0 ? inverse_of_symmetric(jacobian.transpose() * jacobian) : MatrixXd();
  std::vector<EffectSpread> result;
  Index first = 0;
  for (const std::vector<ParameterInterval>& own : intervals) {
    const auto count = static_cast<Index>(own.size());
    EffectSpread spread{MatrixXd::Zero(count, count), 0};
    for (Index i = 0; i < count; ++i) {
      for (Index j = 0; j < count; ++j) {
        const double scale =
            std::sqrt(inverse(first + i, first + i)) * std::sqrt(inverse(first + j, first + j));
        const double both =
            own[static_cast<std::size_t>(i)].deviation * own[static_cast<std::size_t>(j)].deviation;
        spread.covariance(i, j) = inverse(first + i, first + j) / scale * both;
      }
      spread.t = std::max(spread.t, student_t_quantile(0.5 + covered_by_band / 2,
                                                       own[static_cast<std::size_t>(i)].degrees));
    }
    first += count;
    result.push_back(std::move(spread));
  }
  return result;
}

std::optional<PartialResiduals> partial_residuals(const Sample& sample, const Model& model,
                                                  const Scatter& scatter, std::size_t effect,
                                                  const EffectSpread& spread, Workers& workers) {
  const Effect& own = model.effects[effect];
  const TermAxes axes = term_axes(own, model.hardware, has_motor_tension(sample.training));
  PartialResiduals result;
  result.x = axes.x;
  result.y = axes.y;
  for (const bool held_out : {false, true}) {
    const Dataset& dataset = held_out ? sample.held_out : sample.training;
    if (dataset.cells.empty()) continue;
    const auto part = view(dataset, held_out, model, scatter, effect, axes, workers);
    if (!part) continue;
    for (const PointCells& of : cells_of_points(axes, dataset)) {
      std::optional<PartialPoint> at = point(*part, axes, own, of);
      if (!at || !is_changed(*at, axes)) continue;
      result.points.push_back(*at);
    }
  }
  leave_out_faint(result);
  thin_out(result);
  if (result.points.empty()) return std::nullopt;
  result.curve = curve(axes, own, spread, result.points);
  return result;
}

}  // namespace reeve::diagnosis
