#include "diagnosis/fit/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/fit/problem.hpp"
#include "diagnosis/fit/scatter_fit.hpp"
#include "diagnosis/fit/scatter_samples.hpp"
#include "numerics/robust.hpp"

namespace reeve::diagnosis {
namespace {

// The standard deviation is then known to 13 %.
constexpr double enough_noise_degrees = 30;
// To 18 %: rather that than noise with what differs between mountings in it.
constexpr double enough_within_runs = 15;

Noise fit(const Dataset& dataset, const std::vector<ScatterSample>& samples, NoiseSource source) {
  if (samples.empty()) return {0, 0, NoiseSource::known, 0, true, {}};
  // Residuals of a model that is wrong are of many sizes, too.
  Noise noise = source == NoiseSource::residuals ? scatter_of_all(dataset, samples)
                                                 : likeliest_scatter(dataset, samples);
  noise.source = source;
  return noise;
}

// Nothing if too few readings tell.
std::optional<Noise> noise_told_by(const Dataset& dataset, Runs runs) {
  std::vector<char> used(dataset.cells.size(), 0);
  std::vector<ScatterSample> samples = repeats(dataset, runs, used);
  const bool repeated = !samples.empty();
  const std::vector<ScatterSample> smoothed = smoothing(dataset, runs, used);
  samples.insert(samples.end(), smoothed.begin(), smoothed.end());
  take_out_motor(dataset, samples);
  const double enough = runs == Runs::alike ? enough_noise_degrees : enough_within_runs;
  if (degrees(samples) < enough) return std::nullopt;
  Noise noise = fit(dataset, samples,
                    !repeated          ? NoiseSource::smoothing
                    : smoothed.empty() ? NoiseSource::repeats
                                       : NoiseSource::repeats_and_smoothing);
  noise.within_mountings = runs == Runs::by_themselves;
  return noise;
}

// Returns the reading's error as the file gives it, N; 0 if it gives none.
double own_error(const Dataset& dataset, const Cell& cell) {
  const auto& errors = dataset.data->readings[cell.reading].error_N;
  return cell.channel < errors.size() ? errors[cell.channel].value_or(0) : 0;
}

// A reading beyond so many standard deviations scatters as one at what it reads does. Those of
// channels whose noise is known never do.
Eigen::VectorXd deviations_within(double far, const Dataset& dataset, const Noise& noise,
                                  const Eigen::VectorXd& expected_N) {
  const double least = least_absolute(dataset);
  Eigen::VectorXd result(expected_N.size());
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const Cell& cell = dataset.cells[static_cast<std::size_t>(i)];
    if (const auto known = known_noise(*dataset.data, cell.channel)) {
      result[i] = std::max(known->deviation(expected_N[i]), least);
    } else {
      const double scale = noise.scale_of(dataset.data->readings[cell.reading]);
      const double near = scale * noise.deviation(expected_N[i]);
      const bool is_far = std::abs((cell.measured_N - expected_N[i]) / near) > far;
      result[i] = is_far ? scale * noise.deviation(std::max(cell.measured_N, 0.0)) : near;
    }
    result[i] = std::max(result[i], own_error(dataset, cell));
  }
  return result;
}

// In newton, and so sure that no reading is near what a sensor cannot read below.
constexpr double sure_N = 1e-6;

// N, what a model leaves of the readings.
Eigen::VectorXd left_N(const Dataset& dataset, const Forecast& at) {
  Problem plain = problem(dataset, Eigen::VectorXd::Constant(at.reading_N.size(), sure_N));
  plain.motor_deviation_N.resize(0);  // the residuals include this scatter
  return sure_N * own_residuals(plain, at);
}

// The weight of a reading beside the others before its noise is known.
double weight(double reading_N, double middle_N) {
  return 1 / (std::abs(reading_N) + 0.1 * middle_N);
}

// Effect of a scattering motor tension on the readings of one row, weighed and of length 1.
struct MotorAxis {
  std::vector<Eigen::Index> places;  // indices among the cells of a mounting
  Eigen::VectorXd axis;
};

// Returns the axes of a mounting's rows with more than one reading. Nothing is known of these
// readings beside their axes.
std::vector<MotorAxis> motor_axes(const Dataset& dataset, const std::vector<Eigen::Index>& cells,
                                  const Eigen::VectorXd& weighted_by_scale,
                                  Eigen::VectorXd& known) {
  std::map<std::size_t, MotorAxis> rows;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t row = dataset.cells[static_cast<std::size_t>(cells[i])].row;
    if (known[cells[i]] > 0) rows[row].places.push_back(static_cast<Eigen::Index>(i));
  }
  std::vector<MotorAxis> axes;
  for (auto& [row, of] : rows) {
    if (of.places.size() < 2) continue;
    of.axis = weighted_by_scale(of.places).normalized();
    for (const Eigen::Index place : of.places) known[cells[static_cast<std::size_t>(place)]] = 0;
    axes.push_back(std::move(of));
  }
  return axes;
}

// If a column lies along the axes altogether, its remainder is rounding and is set to 0.
void take_out(const std::vector<MotorAxis>& axes, Eigen::MatrixXd& columns) {
  constexpr double of_rounding = 1e-6;
  const Eigen::RowVectorXd before = columns.colwise().norm();
  for (const MotorAxis& of : axes) {
    const Eigen::RowVectorXd along = of.axis.transpose() * columns(of.places, Eigen::all);
    columns(of.places, Eigen::all) -= of.axis * along;
  }
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    if (columns.col(c).norm() <= of_rounding * before[c]) columns.col(c).setZero();
  }
}

// The residuals of one mounting, and what its mounting and its motor tensions could explain.
struct MountedResiduals {
  std::vector<Eigen::Index> cells;
  Eigen::VectorXd weights;
  Eigen::VectorXd weighted;
  std::vector<MotorAxis> axes;
  Eigen::MatrixXd basis;

  Eigen::VectorXd left() const { return beside(weighted); }

  // A reading that is far off would stand in all others: what these say is taken for it.
  Eigen::VectorXd left(double far) const {
    constexpr int rounds = 10;
    Eigen::VectorXd seen = weighted;
    Eigen::VectorXd own = beside(seen);
    for (int round = 0; round < rounds; ++round) {
      const Eigen::VectorXd expected = seen - own;
      for (Eigen::Index i = 0; i < own.size(); ++i) {
        const bool is_far = std::abs(weighted[i] - expected[i]) > far;
        seen[i] = is_far ? expected[i] : weighted[i];
      }
      own = beside(seen);
    }
    return weighted - (seen - own);
  }

  // The share of each reading that is not explained, whatever it is.
  Eigen::VectorXd kept() const {
    Eigen::VectorXd result = (1 - basis.rowwise().squaredNorm().array()).matrix();
    for (const MotorAxis& of : axes) result(of.places) -= of.axis.cwiseAbs2();
    return result;
  }

 private:
  Eigen::VectorXd beside(Eigen::MatrixXd residuals) const {
    take_out(axes, residuals);
    return residuals - basis * (basis.transpose() * residuals);
  }
};

// Readings that are wrong by accident are some ten times the usual away.
double far_off(const std::vector<MountedResiduals>& mounted) {
  constexpr double usual = 10;
  std::vector<double> sizes;
  for (const MountedResiduals& of : mounted) {
    for (const double own : of.left()) sizes.push_back(std::abs(own));
  }
  return usual * median(std::move(sizes));
}

}  // namespace

const char* noise_source_name(NoiseSource source) {
  constexpr std::array names{"repeats", "smoothing", "repeats and smoothing", "residuals", "known"};
  return names[static_cast<std::size_t>(source)];
}

double Noise::deviation(double tension_N) const {
  return std::hypot(absolute_N, relative * tension_N);
}

double Noise::scale_of(const Reading& reading) const {
  return of_group.empty() || !reading.group ? 1 : of_group[*reading.group];
}

Eigen::VectorXd deviations(const Dataset& dataset, const Noise& noise,
                           const Eigen::VectorXd& expected_N) {
  // So far out chance brings less than one reading in a million.
  return deviations_within(5, dataset, noise, expected_N);
}

Eigen::VectorXd deviations_if_near(const Dataset& dataset, const Noise& noise,
                                   const Eigen::VectorXd& expected_N) {
  return deviations_within(std::numeric_limits<double>::infinity(), dataset, noise, expected_N);
}

std::optional<Noise> noise_without_model(const Dataset& dataset) {
  for (const Runs runs : {Runs::by_themselves, Runs::alike}) {
    if (auto noise = noise_told_by(dataset, runs)) return noise;
  }
  return std::nullopt;
}

Noise noise_left_by(const Dataset& dataset, const Model& model) {
  const Forecast at = forecast(dataset, model);
  const Eigen::VectorXd residual_N = left_N(dataset, at);
  const auto parameters = static_cast<double>(parameter_count(model));
  const double kept = std::max(0.1, 1 - (parameters + static_cast<double>(dataset.cells.size()) -
                                         dataset.degrees_of_freedom()) /
                                            static_cast<double>(dataset.cells.size()));
  const std::vector<bool> tells = tell_of_noise(dataset);
  std::vector<ScatterSample> samples;
  for (std::size_t i = 0; i < dataset.cells.size(); ++i) {
    const Cell& cell = dataset.cells[i];
    if (!tells[cell.channel]) continue;
    const auto k = static_cast<Eigen::Index>(i);
    samples.push_back({cell.measured_N, residual_N[k], kept,
                       motor_variance(dataset.rows[cell.row], at.by_scale[k]), cell.row});
  }
  take_out_motor(dataset, samples);
  return fit(dataset, samples, NoiseSource::residuals);
}

std::optional<Noise> noise_left_within_mountings(const Dataset& dataset, const Model& model,
                                                 const MountingModes& modes) {
  const auto cells = static_cast<Eigen::Index>(dataset.cells.size());
  const Forecast at = forecast(dataset, model);
  const Eigen::VectorXd left = left_N(dataset, at);
  const double scaled = dataset.degrees_of_freedom() / static_cast<double>(cells);
  // A seized contact may leave a model in which nothing is pulled.
  const double middle = std::max(at.reading_N.mean(), least_absolute(dataset));
  Eigen::VectorXd known = Eigen::VectorXd::Zero(cells);
  for (Eigen::Index i = 0; i < cells; ++i) {
    const Cell& cell = dataset.cells[static_cast<std::size_t>(i)];
    known[i] = motor_variance(dataset.rows[cell.row], at.by_scale[i]);
  }
  std::vector<MountedResiduals> mounted;
  for (const Mounting& mounting : mountings(dataset)) {
    Eigen::VectorXd weights = at.reading_N(mounting.cells);
    for (double& of : weights) of = weight(of, middle);
    std::vector<MotorAxis> axes =
        motor_axes(dataset, mounting.cells,
                   weights.cwiseProduct(Eigen::VectorXd(at.by_scale(mounting.cells))), known);
    // Out of both: what mountings could explain of scattering motor tensions is no row's axis.
    Eigen::MatrixXd columns =
        weights.asDiagonal() * Eigen::MatrixXd(modes.by_share_N(mounting.cells, Eigen::all));
    take_out(axes, columns);
    const Eigen::VectorXd weighted = weights.cwiseProduct(Eigen::VectorXd(left(mounting.cells)));
    mounted.push_back(
        {mounting.cells, weights, weighted, std::move(axes), orthonormal_basis(columns)});
  }
  const double far = far_off(mounted);
  const std::vector<bool> tells = tell_of_noise(dataset);
  std::vector<ScatterSample> samples;
  for (const MountedResiduals& of : mounted) {
    const Eigen::VectorXd own = of.left(far);
    const Eigen::VectorXd kept = of.kept();
    for (Eigen::Index i = 0; i < own.size(); ++i) {
      const Eigen::Index k = of.cells[static_cast<std::size_t>(i)];
      const Cell& cell = dataset.cells[static_cast<std::size_t>(k)];
      if (!tells[cell.channel]) continue;
      samples.push_back({std::max(at.reading_N[k], 0.0), own[i] / of.weights[i], scaled * kept[i],
                         known[k], cell.row});
    }
  }
  take_out_motor(dataset, samples);
  if (degrees(samples) < enough_within_runs) return std::nullopt;
  return fit(dataset, samples, NoiseSource::residuals);
}

}  // namespace reeve::diagnosis
