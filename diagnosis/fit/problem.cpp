#include "diagnosis/fit/problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace reeve::diagnosis {
namespace {

using Eigen::Index;

double rectified(double reading_N, double deviation_N) {
  constexpr double far = 4;  // the part cut off there is below 1e-5 of the noise
  const double z = reading_N / deviation_N;
  if (z > far) return reading_N;
  const double below = 0.5 * std::erfc(-z * std::numbers::sqrt2 / 2);
  const double density = std::exp(-z * z / 2) * std::numbers::inv_sqrtpi * std::numbers::sqrt2 / 2;
  return reading_N * below + deviation_N * density;
}

// A step that is small beside the range and large beside the accuracy of a forecast.
constexpr double step_share = 1e-4;

std::optional<Forecast> moved(const Problem& problem, Model model, std::size_t effect,
                              std::size_t parameter, double value) {
  model.effects[effect].values[parameter] = value;
  return try_forecast(problem, model);
}

// Effect of a change of one row's scale on its cells, in units of the noise and of length 1.
// `share` of it is taken out of the residuals.
struct ScaleAxis {
  Index first = 0;
  Index size = 0;
  Eigen::VectorXd axis;
  double share = 1;
};

template <typename Use>
void for_each_scale(const Problem& problem, const Forecast& at, Use use) {
  const bool scatters = problem.motor_deviation_N.size() > 0;
  for (std::size_t r = 0; r < problem.dataset->rows.size(); ++r) {
    const DatasetRow& row = problem.dataset->rows[r];
    if (row.has_motor_tension && !scatters) continue;
    ScaleAxis scale{static_cast<Index>(row.first), static_cast<Index>(row.last - row.first), {}, 1};
    scale.axis = at.by_scale.segment(scale.first, scale.size)
                     .cwiseQuotient(problem.deviation_N.segment(scale.first, scale.size));
    const double length = scale.axis.norm();
    if (!(length > 0)) continue;
    scale.axis /= length;
    if (row.has_motor_tension) {
      const double deviation_N = problem.motor_deviation_N[static_cast<Index>(r)];
      scale.share = 1 - 1 / std::hypot(1, deviation_N * length);
    }
    use(scale);
  }
}

// N², of each cell: what it shares with the others of its mounting.
Eigen::VectorXd shared_variance(const Problem& problem) {
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(problem.deviation_N.size());
  for (const SharedScatter& shared : problem.shared) {
    const Eigen::ArrayXd square = (1 - shared.shrunk.array()).square().inverse() - 1;  // S²
    const Eigen::VectorXd own = shared.axes.array().square().matrix() * square.matrix();
    for (std::size_t i = 0; i < shared.cells.size(); ++i) {
      const Index k = shared.cells[i];
      variance[k] = own[static_cast<Index>(i)] * std::pow(problem.deviation_N[k], 2);
    }
  }
  return variance;
}

// Returns the effect of one standard deviation of each thing, in units of the readings' own noise.
Eigen::MatrixXd loadings_of(const Problem& problem, const MountingModes& modes,
                            const MountedScatter& scatter) {
  // Norm over all readings, in units of the noise. A smaller effect cannot be seen.
  constexpr double least = 0.3;
  const auto tau = [&](Mounted kind) { return scatter[static_cast<std::size_t>(kind)]; };
  const Eigen::VectorXd per_noise = problem.deviation_N.cwiseInverse();
  std::vector<Eigen::VectorXd> columns;
  for (std::size_t k = 0; k < modes.kind.size(); ++k) {
    columns.emplace_back(tau(modes.kind[k]) *
                         per_noise.cwiseProduct(modes.by_share_N.col(static_cast<Index>(k))));
  }
  for (const MountingModes::Pair& pair : modes.pairs) {
    Eigen::VectorXd column =
        tau(pair.first) * tau(pair.second) * per_noise.cwiseProduct(pair.by_shares_N);
    if (column.norm() > least) columns.push_back(std::move(column));
  }
  Eigen::MatrixXd loadings(per_noise.size(), static_cast<Index>(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    loadings.col(static_cast<Index>(c)) = columns[c];
  }
  return loadings;
}

}  // namespace

void take_out_scales(const Problem& problem, const Forecast& at,
                     Eigen::Ref<Eigen::MatrixXd> whitened) {
  for_each_scale(problem, at, [&](const ScaleAxis& scale) {
    auto rows = whitened.middleRows(scale.first, scale.size);
    const Eigen::RowVectorXd along = scale.share * (scale.axis.transpose() * rows);
    rows.noalias() -= scale.axis * along;
  });
}

std::optional<Forecast> try_forecast(const Problem& problem, const Model& model) {
  return try_forecast(
      *problem.dataset, model,
      problem.motor_deviation_N.size() > 0 ? MotorSlopes::solved : MotorSlopes::left_out);
}

Eigen::VectorXd expected_readings(const Problem& problem, const Forecast& forecast) {
  Eigen::VectorXd expected = forecast.reading_N;
  for (Index i = 0; i < expected.size(); ++i) {
    if (!problem.clips[static_cast<std::size_t>(i)]) continue;
    expected[i] = rectified(expected[i], problem.deviation_N[i]);
  }
  return expected;
}

std::vector<Parameter> searched_parameters(const Cause& cause, const Hardware& hardware,
                                           double force_scale) {
  std::vector<Parameter> parameters = cause.parameters(hardware);
  for (Parameter& parameter : parameters) {
    if (!is_force(parameter)) continue;
    parameter.range.low *= force_scale;
    parameter.range.high *= force_scale;
  }
  return parameters;
}

Problem problem(const Dataset& dataset, const Eigen::VectorXd& deviation_N) {
  const auto cells = static_cast<Index>(dataset.cells.size());
  Problem result;
  result.dataset = &dataset;
  result.measured_N = Eigen::VectorXd(cells);
  result.deviation_N = deviation_N;
  result.force_scale = force_scale(*dataset.data);
  const std::vector<bool> below_zero = reads_below_zero(*dataset.data);
  const std::vector<bool> dead = reads_zero_alone(*dataset.data);
  for (std::size_t i = 0; i < dataset.cells.size(); ++i) {
    result.measured_N[static_cast<Index>(i)] = dataset.cells[i].measured_N;
    const std::size_t channel = dataset.cells[i].channel;
    result.clips.push_back(!below_zero[channel] && !dead[channel]);
  }
  const auto scatters = [](const DatasetRow& row) { return row.motor_deviation_N > 0; };
  if (std::ranges::any_of(dataset.rows, scatters)) {
    result.motor_deviation_N.resize(static_cast<Index>(dataset.rows.size()));
    for (std::size_t r = 0; r < dataset.rows.size(); ++r) {
      result.motor_deviation_N[static_cast<Index>(r)] = dataset.rows[r].motor_deviation_N;
    }
  }
  return result;
}

void settle_motor_deviations(Problem& problem, const Forecast& at) {
  if (problem.motor_deviation_N.size() == 0) return;
  const MeasuredData& data = *problem.dataset->data;
  const Eigen::VectorXd expected = expected_readings(problem, at);
  for (std::size_t r = 0; r < problem.dataset->rows.size(); ++r) {
    const DatasetRow& row = problem.dataset->rows[r];
    if (!row.has_motor_tension || !(row.motor_deviation_N > 0)) continue;
    double told = 0;  // by the row's other readings, in units of 1/N²
    double along = 0;
    for (auto i = static_cast<Index>(row.first); i < static_cast<Index>(row.last); ++i) {
      const double weight = at.by_scale[i] / std::pow(problem.deviation_N[i], 2);
      told += weight * at.by_scale[i];
      along += weight * (problem.measured_N[i] - expected[i]);
    }
    Reading reading = data.readings[row.reading];
    const double own = std::pow(row.motor_deviation_N, -2);
    reading.motor_tension_N = std::max(0.0, *reading.motor_tension_N + along / (own + told));
    problem.motor_deviation_N[static_cast<Index>(r)] = motor_deviation(data, reading);
  }
}

void share_scatter(Problem& problem, const MountingModes& modes, const MountedScatter& scatter,
                   const Forecast& at) {
  problem.shared.clear();
  const Eigen::MatrixXd loadings = loadings_of(problem, modes, scatter);
  if (loadings.squaredNorm() == 0) return;
  Eigen::MatrixXd seen = loadings;
  take_out_scales(problem, at, seen);
  for (Mounting& mounting : mountings(*problem.dataset)) {
    const Eigen::MatrixXd own = loadings(mounting.cells, Eigen::all);
    const Eigen::MatrixXd own_seen = seen(mounting.cells, Eigen::all);
    problem.shared.push_back(shared_scatter(std::move(mounting.cells), own, own_seen));
  }
}

Problem part_of(const Problem& whole, const Dataset& dataset) {
  const std::vector<Index> cells = cells_of_part(*whole.dataset, dataset);
  Problem part = problem(dataset, whole.deviation_N(cells));
  if (whole.motor_deviation_N.size() > 0) {
    part.motor_deviation_N = whole.motor_deviation_N(rows_of_part(*whole.dataset, dataset));
  }
  std::map<Index, Index> place;  // index in the part, by that in the whole
  for (std::size_t k = 0; k < cells.size(); ++k) place[cells[k]] = static_cast<Index>(k);
  for (SharedScatter shared : whole.shared) {
    if (!place.contains(shared.cells.front())) continue;
    for (Index& cell : shared.cells) cell = place.at(cell);
    part.shared.push_back(std::move(shared));
  }
  return part;
}

Eigen::VectorXd newton_residuals(const Problem& problem, const Forecast& forecast) {
  return problem.measured_N - expected_readings(problem, forecast);
}

Eigen::VectorXd own_residuals(const Problem& problem, const Forecast& forecast) {
  Eigen::VectorXd result = newton_residuals(problem, forecast).cwiseQuotient(problem.deviation_N);
  take_out_scales(problem, forecast, result);
  return result;
}

Eigen::VectorXd residuals(const Problem& problem, const Forecast& forecast) {
  Eigen::VectorXd result = own_residuals(problem, forecast);
  whiten(problem.shared, result);
  return result;
}

Eigen::VectorXd noise_variance(const Problem& problem, const Forecast& at) {
  Eigen::VectorXd variance = problem.deviation_N.cwiseAbs2();
  for_each_scale(problem, at, [&](const ScaleAxis& scale) {
    auto own = variance.segment(scale.first, scale.size).array();
    if (scale.share < 1) {
      own *= 1 + (std::pow(1 - scale.share, -2) - 1) * scale.axis.array().square();
      return;
    }
    // A free scale makes the forecasts add up to the readings.
    const auto deviation_N = problem.deviation_N.segment(scale.first, scale.size).array();
    Eigen::ArrayXd part = scale.axis.array() * deviation_N;
    part /= part.sum();
    own = own * (1 - 2 * part) + own.sum() * part.square();
  });
  variance += shared_variance(problem);
  return variance;
}

Eigen::VectorXd total_deviations(const Problem& problem) {
  return (problem.deviation_N.cwiseAbs2() + shared_variance(problem)).cwiseSqrt();
}

double misfit(const Problem& problem, const Model& model) {
  const std::optional<Forecast> at = try_forecast(problem, model);
  return at ? residuals(problem, *at).squaredNorm() : std::numeric_limits<double>::infinity();
}

double log_determinant(const Problem& problem) {
  double half = problem.deviation_N.array().log().sum();
  for (const SharedScatter& shared : problem.shared) half -= (-shared.shrunk).array().log1p().sum();
  return 2 * half;
}

Eigen::VectorXd difference(const Problem& problem, const Forecast& at, const Forecast& other) {
  Eigen::VectorXd result = (expected_readings(problem, other) - expected_readings(problem, at))
                               .cwiseQuotient(problem.deviation_N);
  take_out_scales(problem, at, result);
  whiten(problem.shared, result);
  return result;
}

Eigen::MatrixXd sensitivity(const Problem& problem, const Model& model, const Forecast& at,
                            std::size_t effect) {
  const Effect& here = model.effects[effect];
  const std::vector<Parameter> parameters =
      searched_parameters(*here.cause, model.hardware, problem.force_scale);
  Eigen::MatrixXd result(problem.measured_N.size(), static_cast<Index>(parameters.size()));
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const Range range = parameters[p].range;
    const double step = step_share * (range.high - range.low);
    const double value = here.values[p];
    const double up = std::min(value + step, range.high);
    const double down = std::max(value - step, range.low);
    auto column = result.col(static_cast<Index>(p));
    const std::optional<Forecast> above = moved(problem, model, effect, p, up);
    const std::optional<Forecast> below = moved(problem, model, effect, p, down);
    if (above && below) {
      column = (difference(problem, at, *above) - difference(problem, at, *below)) / (up - down);
    } else {
      column.setZero();  // at the edge of what has tensions
    }
  }
  return result;
}

Eigen::MatrixXd sensitivities(const Problem& problem, const Model& model, const Forecast& at) {
  Eigen::MatrixXd result(problem.measured_N.size(), static_cast<Index>(parameter_count(model)));
  Index column = 0;
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const Eigen::MatrixXd part = sensitivity(problem, model, at, e);
    result.middleCols(column, part.cols()) = part;
    column += part.cols();
  }
  return result;
}

std::size_t parameter_count(const Model& model) {
  std::size_t count = 0;
  for (const Effect& effect : model.effects) count += effect.values.size();
  return count;
}

}  // namespace reeve::diagnosis
