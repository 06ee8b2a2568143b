#include "diagnosis/model/noise.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/minimise.hpp"

namespace reeve::diagnosis {
namespace {

// The standard deviation is then known to 13 %.
constexpr double enough_noise_degrees = 30;
// To 18 %: rather that than noise with what differs between mountings in it.
constexpr double enough_within_runs = 15;
constexpr double floor_share = 1e-3;  // of the median reading
constexpr double least_relative = 1e-5;

double least_absolute(const Dataset& dataset) { return floor_share * median_reading(dataset); }

double degrees(const std::vector<ScatterSample>& samples) {
  double sum = 0;
  for (const ScatterSample& sample : samples) sum += sample.kept;
  return sum;
}

// Twice the negative restricted log-likelihood, but for a constant; of normal residuals, or of
// Student's t.
double misfit(const std::vector<ScatterSample>& samples, double absolute, double relative,
              double tail) {
  double sum = 0;
  for (const ScatterSample& sample : samples) {
    if (sample.kept <= 0) continue;
    const double scatter = relative * sample.level_N;
    const double variance = absolute * absolute + scatter * scatter + sample.motor_variance_N2;
    const double square = sample.residual_N * sample.residual_N / variance;
    sum += sample.kept * std::log(variance);
    sum += tail == 0 ? square : sample.kept * (tail + 1) * std::log1p(square / sample.kept / tail);
  }
  return sum;
}

// Of a density of Student's t over that of a normal one at 0, twice the logarithm.
double height(double tail) {
  return 2 * (std::lgamma((tail + 1) / 2) - std::lgamma(tail / 2)) - std::log(tail / 2);
}

struct ScatterFit {
  double tail = 0;
  double misfit = 0;
  std::vector<double> at;  // logarithms of the absolute and the relative part
};

ScatterFit fit_with(const Dataset& dataset, const std::vector<ScatterSample>& samples,
                    double tail) {
  constexpr int evaluations = 150;
  const double level = median_reading(dataset);
  const std::vector<Interval> box{{std::log(least_absolute(dataset)), std::log(10 * level)},
                                  {std::log(least_relative), std::log(2.0)}};
  const Minimum best = minimise(
      [&](const std::vector<double>& x) {
        return misfit(samples, std::exp(x[0]), std::exp(x[1]), tail);
      },
      box, evaluations);
  return {tail, best.value - (tail == 0 ? 0 : degrees(samples) * height(tail)), best.at};
}

// Those of which the estimate leaves most: the others are mixtures of several readings' scatter.
std::vector<ScatterSample> mostly_free(std::vector<ScatterSample> samples) {
  constexpr double most = 0.5;
  std::erase_if(samples, [](const ScatterSample& sample) { return sample.kept < most; });
  return samples;
}

Noise noise_of(const ScatterFit& best, const std::vector<ScatterSample>& samples,
               NoiseSource source) {
  return {std::exp(best.at[1]), std::exp(best.at[0]), source, degrees(samples), best.tail, true};
}

Noise fit(const Dataset& dataset, const std::vector<ScatterSample>& samples, NoiseSource source) {
  constexpr double heavy_tails[] = {3, 6};
  // Twice the log-likelihood by which heavier tails have to be the likelier: chance brings that in
  // 1 of 1000 normal samples (chi-squared of one degree of freedom, on its edge).
  constexpr double clearly = 9.5;
  if (samples.empty()) return {0, 0, NoiseSource::known, 0, 0, true};
  ScatterFit all = fit_with(dataset, samples, 0);
  // Residuals of a model that is wrong are of many sizes, too.
  if (source == NoiseSource::residuals) return noise_of(all, samples, source);
  const std::vector<ScatterSample> free = mostly_free(samples);
  double least = fit_with(dataset, free, 0).misfit - clearly;
  for (const double tail : heavy_tails) {
    const double misfit = fit_with(dataset, free, tail).misfit;
    if (misfit >= least) continue;
    least = misfit;
    all = fit_with(dataset, samples, tail);
  }
  return noise_of(all, samples, source);
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

// What the file says of the reading, N; 0 if nothing.
double own_error(const Dataset& dataset, const Cell& cell) {
  const auto& errors = dataset.data->readings[cell.reading].error_N;
  return cell.channel < errors.size() ? errors[cell.channel].value_or(0) : 0;
}

}  // namespace

const char* noise_source_name(NoiseSource source) {
  switch (source) {
    case NoiseSource::repeats:
      return "repeats";
    case NoiseSource::smoothing:
      return "smoothing";
    case NoiseSource::repeats_and_smoothing:
      return "repeats and smoothing";
    case NoiseSource::residuals:
      return "residuals";
    case NoiseSource::known:
      return "known";
  }
  return "";
}

double Noise::deviation(double tension_N) const {
  return std::hypot(absolute_N, relative * tension_N);
}

Eigen::VectorXd deviations(const Dataset& dataset, const Noise& noise,
                           const Eigen::VectorXd& expected_N) {
  // So far out chance brings less than one reading in a million.
  constexpr double far = 5;
  const double least = least_absolute(dataset);
  Eigen::VectorXd result(expected_N.size());
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const Cell& cell = dataset.cells[static_cast<std::size_t>(i)];
    if (const auto known = known_noise(*dataset.data, cell.channel)) {
      result[i] = std::max({known->deviation(expected_N[i]), least, own_error(dataset, cell)});
      continue;
    }
    const double measured = cell.measured_N;
    const double at_expected = noise.deviation(expected_N[i]);
    const double z = (measured - expected_N[i]) / at_expected;
    if (noise.tail_degrees > 0) {
      const double tail = noise.tail_degrees;
      result[i] = at_expected * std::sqrt((tail + z * z) / (tail + 1));
    } else {
      result[i] = std::abs(z) <= far ? at_expected : noise.deviation(std::max(measured, 0.0));
    }
    result[i] = std::max(result[i], own_error(dataset, cell));
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
  std::vector<ScatterSample> samples;
  for (std::size_t r = 0; r < dataset.rows.size(); ++r) {
    const DatasetRow& row = dataset.rows[r];
    for (std::size_t i = row.first; i < row.last; ++i) {
      if (has_known_noise(dataset, i)) continue;
      const auto cell = static_cast<Eigen::Index>(i);
      samples.push_back({dataset.cells[i].measured_N, residual_N[cell], kept,
                         motor_variance(row, at.by_scale[cell]), r});
    }
  }
  take_out_motor(dataset, samples);
  return fit(dataset, samples, NoiseSource::residuals);
}

}  // namespace reeve::diagnosis
