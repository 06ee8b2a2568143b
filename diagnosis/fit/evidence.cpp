#include "diagnosis/fit/evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "diagnosis/fit/scatter_fit.hpp"
#include "diagnosis/fit/set_readings.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double least_fitted_scale = 1e-9;
constexpr std::array mounting_levels{3.0, 1.0, 0.3, 0.05};
// The scatter of mountings is estimated as if each reading had all noise for itself. Where much of
// it is the motor's, and common to a row, they scatter more.
constexpr double beside_motor = 10;
constexpr std::array motor_levels{0.0, 1.0, 5.0};

double median_size(VectorXd values) {
  if (values.size() == 0) return 0;
  values = values.cwiseAbs();
  const Index middle = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + middle, values.end());
  return values[middle];
}

// Only rows with several readings tell a motor tension's scatter from that of readings.
bool tells_of_motor(const Dataset& dataset) {
  const auto tells = [](const DatasetRow& row) {
    return row.has_motor_tension && row.motor_deviation_N == 0 && row.last - row.first > 1;
  };
  return std::ranges::any_of(dataset.rows, tells);
}

// Greatest number of which both are multiples; 0 if there is none above `least`.
double common_step(double a, double b, double least) {
  while (b > least) {
    const double rest = std::fmod(a, b);
    a = b;
    b = std::min(rest, a - rest);
  }
  return a > least ? a : 0;
}

// A motor tension that is known to a step q scatters by q / sqrt(12), if it was not set to these
// values. 0 where the step is small beside the greatest tension.
double deviation_of_rounding(const Dataset& dataset) {
  constexpr double fine = 1e-3;
  double greatest_N = 0;
  for (const DatasetRow& row : dataset.rows) {
    greatest_N = std::max(greatest_N, row.conditions.motor_tension_N);
  }
  double step_N = 0;
  for (const DatasetRow& row : dataset.rows) {
    if (!row.has_motor_tension) continue;
    const double motor_N = row.conditions.motor_tension_N;
    step_N = step_N == 0 ? motor_N
                         : common_step(std::max(motor_N, step_N), std::min(motor_N, step_N),
                                       fine * greatest_N);
    if (step_N == 0) return 0;
  }
  return step_N / std::sqrt(12.0);
}

void set_motor_scatter(Problem& problem, double relative, double absolute_N) {
  const auto& rows = problem.dataset->rows;
  if (problem.motor_deviation_N.size() == 0) {
    problem.motor_deviation_N = VectorXd::Zero(static_cast<Index>(rows.size()));
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (!rows[r].has_motor_tension || rows[r].motor_deviation_N > 0) continue;
    problem.motor_deviation_N[static_cast<Index>(r)] =
        std::hypot(relative * rows[r].conditions.motor_tension_N, absolute_N);
  }
}

// All scatter is the motor tension's.
void set_motor_as_response(Problem& problem, double motor_deviation_N, const Forecast& reference) {
  constexpr double left_to_readings = 0.05;
  const auto& rows = problem.dataset->rows;
  problem.motor_deviation_N =
      VectorXd::Constant(static_cast<Index>(rows.size()), motor_deviation_N);
  const double least_N = least_absolute(*problem.dataset) * left_to_readings;
  problem.deviation_N =
      (left_to_readings * motor_deviation_N * reference.by_scale.cwiseAbs()).cwiseMax(least_N);
}

// ln det of what motor tensions share, by the forecasts of the reference: a model does not become
// likelier by making its readings depend less on the motor.
double motor_log_determinant(const Problem& problem, const Forecast& reference) {
  double sum = 0;
  if (problem.motor_deviation_N.size() == 0) return 0;
  for (std::size_t r = 0; r < problem.dataset->rows.size(); ++r) {
    const DatasetRow& row = problem.dataset->rows[r];
    const double deviation_N = problem.motor_deviation_N[static_cast<Index>(r)];
    if (!row.has_motor_tension || deviation_N == 0) continue;
    const auto first = static_cast<Index>(row.first);
    const auto size = static_cast<Index>(row.last - row.first);
    const VectorXd along = reference.by_scale.segment(first, size)
                               .cwiseQuotient(problem.deviation_N.segment(first, size));
    sum += std::log1p(deviation_N * deviation_N * along.squaredNorm());
  }
  return sum;
}

bool is_fitted(const MountingScatter& mounting, std::size_t kind) {
  return !mounting.given && is_told(mounting, static_cast<Mounted>(kind));
}

bool is_fitted_in_all(const MountingScatter& mounting) {
  for (std::size_t k = 0; k < mounted_kinds; ++k) {
    if (mounting.present[k] && !is_fitted(mounting, k)) return false;
  }
  return true;
}

// A scatter is at most what is believed of mountings. It is in units of s0: what somebody said, and
// what is assumed since no readings tell it, does not grow with s0.
MountedScatter scatter_at(const ScatterShape& shape, const ScatterLevel& level, double scale) {
  const MountingScatter& mounting = shape.scatter.mounting;
  MountedScatter scatter = mounting.relative;
  for (std::size_t k = 0; k < mounted_kinds; ++k) {
    if (!is_fitted(mounting, k)) {
      scatter[k] /= scale;
      continue;
    }
    scatter[k] *= level.mounting * (k == shape.widest ? level.widest : 1);
    scatter[k] = std::min(scatter[k], most_believed_scatter[k]);
  }
  return scatter;
}

double log_prior(const MountingScatter& mounting, const MountedScatter& scatter) {
  if (mounting.given) return 0;
  double sum = 0;
  for (std::size_t k = 0; k < mounted_kinds; ++k) {
    if (!mounting.present[k] || !(scatter[k] > 0)) continue;
    const double ratio = scatter[k] / assumed_scatter[k];
    sum += std::log(ratio) + 1 - ratio;
  }
  return sum;
}

std::optional<std::size_t> widest_kind(const MountingScatter& mounting) {
  std::optional<std::size_t> widest;
  double most = 0;
  for (const Mounted kind : {Mounted::sheath, Mounted::tube, Mounted::bearing}) {
    const auto k = static_cast<std::size_t>(kind);
    const double ratio = mounting.relative[k] / assumed_scatter[k];
    if (!mounting.present[k] || !is_fitted(mounting, k) || ratio <= most) continue;
    most = ratio;
    widest = k;
  }
  return widest;
}

// The rows of set readings have one reading each.
void spread_motor(Problem& problem, const VectorXd& beyond) {
  for (std::size_t r = 0; r < problem.dataset->rows.size(); ++r) {
    const auto cell = static_cast<Index>(problem.dataset->rows[r].first);
    problem.motor_deviation_N[static_cast<Index>(r)] *= beyond[cell];
    problem.deviation_N[cell] *= beyond[cell];
  }
}

}  // namespace

ScatterShape scatter_shape(const Dataset& dataset, const Model& reference,
                           std::optional<double> given, Workers& workers) {
  // The noise of repeats is known to some 10 %.
  constexpr double surely = 0.8;
  constexpr std::size_t few_mountings = 4;
  ScatterShape shape;
  const Forecast at = forecast(dataset, reference);
  shape.modes = mounting_modes(dataset, reference, workers);
  const auto measured = noise_without_model(dataset);
  const auto within = noise_left_within_mountings(dataset, reference, shape.modes);
  Noise& noise = shape.scatter.noise;
  if (within) {
    noise = *within;
  } else if (measured) {
    noise = *measured;
  } else {
    noise = noise_left_by(dataset, reference);
  }
  shape.knows_mountings = within || (measured && measured->within_mountings) ||
                          mountings(dataset).size() < few_mountings;
  const VectorXd deviation_N = deviations_if_near(dataset, noise, at.reading_N);
  if (measured && measured->source == NoiseSource::repeats) {
    const VectorXd repeated_N = deviations_if_near(dataset, *measured, at.reading_N);
    shape.least_scale = surely * median_size(repeated_N.cwiseQuotient(deviation_N));
  }
  if (noise.source == NoiseSource::known) shape.least_scale = shape.most_scale = 1;
  Problem plain = problem(dataset, deviation_N);
  settle_motor_deviations(plain, at);
  const std::optional<SetReadings> set = set_readings(dataset);
  if (set) shape.set_motor_N = set->motor_N;
  if (set && set->one_of_each_run) shape.knows_mountings = false;
  if (shape.knows_mountings) {
    shape.scatter.mounting = believed(mounting_scatter(plain, at, shape.modes, given));
  }
  shape.reference = at;
  shape.motor_relative =
      median_size(deviation_N.cwiseQuotient(at.reading_N.cwiseAbs().cwiseMax(deviation_N)));
  shape.rounded_N = deviation_of_rounding(dataset);
  const bool has_mountings =
      shape.knows_mountings && !given && shape.scatter.mounting.mounted_again > 0;
  const bool tells = tells_of_motor(dataset);
  if (has_mountings) shape.widest = widest_kind(shape.scatter.mounting);
  if (has_mountings && tells) {
    for (const double motor : motor_levels) {
      if (motor > 0) shape.levels.push_back({beside_motor, motor});
    }
  }
  for (const double mounting : mounting_levels) {
    if (mounting != 1 && !has_mountings) continue;
    for (const double motor : motor_levels) {
      if (motor == 0 || tells) shape.levels.push_back({mounting, motor});
    }
    if (tells && shape.rounded_N > 0) shape.levels.push_back({mounting, 0, true});
  }
  return shape;
}

namespace {

// The scale s0 is expected about `scale`.
Likelihood seen_at(const Dataset& dataset, const ScatterShape& shape, const Forecast& at,
                   const ScatterLevel& level, double scale) {
  constexpr double of_normal = 0.6745;
  constexpr int most_rounds = 5;
  constexpr double settled = 1.1;
  constexpr double by_far = 3;  // times the distance from which readings weigh less
  VectorXd deviation_N = deviations_if_near(dataset, shape.scatter.noise, at.reading_N);
  const MountedScatter scatter = scatter_at(shape, level, scale);
  const auto seen = [&] {
    Problem result = problem(dataset, deviation_N);
    if (level.motor_scatters()) {
      set_motor_scatter(result, level.motor * shape.motor_relative,
                        level.rounded ? shape.rounded_N / scale : 0);
    }
    if (shape.set_motor_N) set_motor_as_response(result, *shape.set_motor_N, shape.reference);
    settle_motor_deviations(result, at);
    share_scatter(result, shape.modes, scatter, at);
    return result;
  };
  Likelihood result;
  result.level = level;
  result.problem = seen();
  VectorXd left = residuals(result.problem, at);
  // A reading that is far by far draws its mounting towards it, so that others of that seem far,
  // too, until it weighs less.
  VectorXd beyond = VectorXd::Ones(left.size());
  for (int round = 0; round < most_rounds; ++round) {
    const VectorXd before = beyond;
    const double middle = std::max(median_size(left) / of_normal, least_fitted_scale);
    beyond = (left.cwiseAbs().cwiseProduct(before) / (outlying * middle)).cwiseMax(1);
    const VectorXd change = beyond.cwiseQuotient(before);
    if (change.maxCoeff() < settled && change.minCoeff() > 1 / settled) break;
    if (round > 0 && before.maxCoeff() < by_far) break;
    deviation_N = deviation_N.cwiseProduct(change);
    result.problem = seen();
    if (shape.set_motor_N) spread_motor(result.problem, beyond);
    left = residuals(result.problem, at);
  }
  const double degrees = std::max(dataset.degrees_of_freedom(), 1.0);
  result.scale = std::sqrt(left.squaredNorm() / degrees);
  result.scale = std::max({result.scale, shape.least_scale, least_fitted_scale});
  if (shape.most_scale > 0) result.scale = std::min(result.scale, shape.most_scale);
  const double determinant =
      log_determinant(result.problem) + motor_log_determinant(result.problem, shape.reference);
  result.value = -degrees * std::log(result.scale) -
                 left.squaredNorm() / (2 * result.scale * result.scale) - determinant / 2 +
                 log_prior(shape.scatter.mounting, scatter);
  result.problem.deviation_N *= result.scale;
  result.problem.motor_deviation_N *= result.scale;
  return result;
}

}  // namespace

Likelihood likelihood(const Dataset& dataset, const ScatterShape& shape, const Forecast& at,
                      const ScatterLevel& level) {
  constexpr int settling = 5;
  Likelihood seen = seen_at(dataset, shape, at, level, 1);
  if (is_fitted_in_all(shape.scatter.mounting) && !level.rounded) return seen;
  for (int i = 0; i < (level.rounded ? settling : 1); ++i) {
    seen = seen_at(dataset, shape, at, level, seen.scale);
  }
  return seen;
}

Likelihood likelihood(const Dataset& dataset, const ScatterShape& shape, const Forecast& at) {
  const auto at_widest = [&](Likelihood best) {
    if (!shape.widest) return best;
    for (const double widest : {0.3, 0.1}) {
      ScatterLevel level = best.level;
      level.widest = widest;
      Likelihood here = likelihood(dataset, shape, at, level);
      here.value -= std::log1p(shape.scatter.mounting.told_by[*shape.widest]) / 2;
      if (here.value > best.value) best = std::move(here);
    }
    return best;
  };
  Likelihood best;
  best.value = -std::numeric_limits<double>::infinity();
  const auto see = [&](const ScatterLevel& level) {
    Likelihood here = likelihood(dataset, shape, at, level);
    if (here.value > best.value || best.problem.dataset == nullptr) best = std::move(here);
  };
  // First the mountings, then the motor beside what is likeliest of them, and mountings beside it.
  for (const ScatterLevel& level : shape.levels) {
    if (!level.motor_scatters()) see(level);
  }
  const double mounting = best.level.mounting;
  const double without_motor = best.value;
  for (const ScatterLevel& level : shape.levels) {
    if (level.motor_scatters() && level.mounting == mounting) see(level);
  }
  constexpr double clearly = 10;
  if (!(best.value > without_motor + clearly)) return at_widest(std::move(best));
  const ScatterLevel with_motor = best.level;
  for (const ScatterLevel& level : shape.levels) {
    if (level.mounting != mounting && level.motor == with_motor.motor &&
        level.rounded == with_motor.rounded) {
      see(level);
    }
  }
  return at_widest(std::move(best));
}

double robust_misfit(const VectorXd& residuals) {
  double sum = 0;
  for (const double e : residuals) {
    const double beyond = std::max(std::abs(e) / outlying, 1.0);
    sum += std::pow(e / beyond, 2) + 2 * outlying * outlying * std::log(beyond);
  }
  return sum;
}

Scatter fitted_scatter(const ScatterShape& shape, const Likelihood& likelihood) {
  Scatter scatter = shape.scatter;
  scatter.noise.relative *= likelihood.scale;
  scatter.noise.absolute_N *= likelihood.scale;
  scatter.mounting.relative = scatter_at(shape, likelihood.level, likelihood.scale);
  for (double& tau : scatter.mounting.relative) tau *= likelihood.scale;
  return scatter;
}

}  // namespace reeve::diagnosis
