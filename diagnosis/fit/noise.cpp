#include "diagnosis/fit/noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "diagnosis/fit/scatter_fit.hpp"

namespace reeve::diagnosis {
namespace {

// The standard deviation is then known to 13 %.
constexpr double enough_noise_degrees = 30;
// To 18 %: rather that than noise with what differs between mountings in it.
constexpr double enough_within_runs = 15;

Noise fit(const Dataset& dataset, const std::vector<ScatterSample>& samples, NoiseSource source) {
  if (samples.empty()) return {0, 0, NoiseSource::known, 0, true, {}};
  // Residuals of a model that is wrong are of many sizes, too.
  ScatterFit found = source == NoiseSource::residuals ? scatter_of_all(dataset, samples)
                                                      : likeliest_scatter(dataset, samples);
  return {found.relative, found.absolute_N,         source, degrees(samples),
          true,           std::move(found.of_group)};
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

// `least` for channels whose noise is known.
double deviation_if_near(const Dataset& dataset, const Noise& noise, const Cell& cell,
                         double expected_N, double least) {
  if (const auto known = known_noise(*dataset.data, cell.channel)) {
    return std::max(known->deviation(expected_N), least);
  }
  return noise.scale_of(dataset.data->readings[cell.reading]) * noise.deviation(expected_N);
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
  constexpr double far = 5;
  const double least = least_absolute(dataset);
  Eigen::VectorXd result(expected_N.size());
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const Cell& cell = dataset.cells[static_cast<std::size_t>(i)];
    const double near = deviation_if_near(dataset, noise, cell, expected_N[i], least);
    const double measured = cell.measured_N;
    const double z = (measured - expected_N[i]) / near;
    if (known_noise(*dataset.data, cell.channel)) {
      result[i] = near;
    } else {
      const double scale = noise.scale_of(dataset.data->readings[cell.reading]);
      result[i] = std::abs(z) <= far ? near : scale * noise.deviation(std::max(measured, 0.0));
    }
    result[i] = std::max(result[i], own_error(dataset, cell));
  }
  return result;
}

Eigen::VectorXd deviations_if_near(const Dataset& dataset, const Noise& noise,
                                   const Eigen::VectorXd& expected_N) {
  const double least = least_absolute(dataset);
  Eigen::VectorXd result(expected_N.size());
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const Cell& cell = dataset.cells[static_cast<std::size_t>(i)];
    result[i] = std::max(deviation_if_near(dataset, noise, cell, expected_N[i], least),
                         own_error(dataset, cell));
  }
  return result;
}

std::optional<Noise> noise_without_model(const Dataset& dataset) {
  for (const Runs runs : {Runs::by_themselves, Runs::alike}) {
    if (auto noise = noise_told_by(dataset, runs)) return noise;
  }
  return std::nullopt;
}

std::optional<Noise> noise_of_samples(const Dataset& dataset, std::vector<ScatterSample> samples) {
  take_out_motor(dataset, samples);
  if (degrees(samples) < enough_within_runs) return std::nullopt;
  return fit(dataset, samples, NoiseSource::residuals);
}

Noise noise_of_residuals(const Dataset& dataset, const Forecast& at,
                         const Eigen::VectorXd& residual_N, double parameters) {
  const double kept = std::max(0.1, 1 - (parameters + static_cast<double>(dataset.cells.size()) -
                                         dataset.degrees_of_freedom()) /
                                            static_cast<double>(dataset.cells.size()));
  const std::vector<bool> tells = tell_of_noise(dataset);
  std::vector<ScatterSample> samples;
  for (std::size_t r = 0; r < dataset.rows.size(); ++r) {
    const DatasetRow& row = dataset.rows[r];
    for (std::size_t i = row.first; i < row.last; ++i) {
      if (!tells[dataset.cells[i].channel]) continue;
      const auto cell = static_cast<Eigen::Index>(i);
      samples.push_back({dataset.cells[i].measured_N, residual_N[cell], kept,
                         motor_variance(row, at.by_scale[cell]), r});
    }
  }
  take_out_motor(dataset, samples);
  return fit(dataset, samples, NoiseSource::residuals);
}

}  // namespace reeve::diagnosis
