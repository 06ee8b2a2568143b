#include "diagnosis/fit/scatter_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "numerics/chi_squared.hpp"
#include "numerics/minimise.hpp"

namespace reeve::diagnosis {
namespace {

constexpr double floor_share = 1e-3;  // times the median reading
constexpr double least_relative = 1e-5;
constexpr double surely = 0.999;
// Effective readings of a group that determine its scatter to 18 %.
constexpr double enough_of_group = 15;

// The square is that of a residual in units of its scatter.
double surprise(double square) {
  constexpr double far = outlying * outlying;
  return square <= far ? square : far * (1 + std::log(square / far));
}

// Twice the negative restricted log-likelihood, but for a constant.
double misfit(const std::vector<ScatterSample>& samples, double absolute, double relative) {
  double sum = 0;
  for (const ScatterSample& sample : samples) {
    if (sample.kept <= 0) continue;
    const double scatter = relative * sample.level_N;
    const double own = absolute * absolute + scatter * scatter;
    const double variance = sample.scale * sample.scale * own + sample.motor_variance_N2;
    const double square = sample.residual_N * sample.residual_N / variance;
    sum += sample.kept * std::log(variance) + sample.kept * surprise(square / sample.kept);
  }
  return sum;
}

struct Trial {
  Noise noise;
  double misfit = 0;
};

Trial trial(const Dataset& dataset, const std::vector<ScatterSample>& samples) {
  constexpr int evaluations = 150;
  const double level = median_reading(dataset);
  const std::vector<Interval> box{{std::log(least_absolute(dataset)), std::log(10 * level)},
                                  {std::log(least_relative), std::log(2.0)}};
  const auto penalty = [](const std::vector<double>& x) { return 2 * (x[0] + x[1]); };
  const auto at = [&](const std::vector<double>& x) {
    return misfit(samples, std::exp(x[0]), std::exp(x[1]));
  };
  const Minimum best =
      minimise([&](const std::vector<double>& x) { return at(x) - penalty(x); }, box, evaluations);
  Noise noise;
  noise.absolute_N = std::exp(best.at[0]);
  noise.relative = std::exp(best.at[1]);
  noise.degrees_of_freedom = degrees(samples);
  return {std::move(noise), best.value + penalty(best.at)};
}

std::vector<ScatterSample> mostly_free(std::vector<ScatterSample> samples) {
  constexpr double most = 0.5;
  std::erase_if(samples, [](const ScatterSample& sample) { return sample.kept < most; });
  return samples;
}

std::optional<std::size_t> group_of(const Dataset& dataset, const ScatterSample& sample) {
  return dataset.data->readings[dataset.rows[sample.row].reading].group;
}

std::vector<ScatterSample> scaled(const Dataset& dataset, std::vector<ScatterSample> samples,
                                  const std::vector<double>& of_group) {
  if (of_group.empty()) return samples;
  for (ScatterSample& sample : samples) {
    if (const auto group = group_of(dataset, sample)) sample.scale = of_group[*group];
  }
  return samples;
}

// The samples of each group that has enough of them; of others none.
std::vector<std::vector<ScatterSample>> by_group(const Dataset& dataset,
                                                 const std::vector<ScatterSample>& samples) {
  std::vector<std::vector<ScatterSample>> result(dataset.data->groups.size());
  for (const ScatterSample& sample : samples) {
    if (const auto group = group_of(dataset, sample)) result[*group].push_back(sample);
  }
  for (auto& own : result) {
    if (degrees(own) < enough_of_group) own.clear();
  }
  return result;
}

// The likeliest f of these samples beside a scatter of all.
double scale_beside(std::vector<ScatterSample> own, const Noise& all) {
  constexpr int evaluations = 60;
  const double most = std::log(30.0);
  const Minimum best = refine(
      [&](const std::vector<double>& x) {
        for (ScatterSample& sample : own) sample.scale = std::exp(x[0]);
        return misfit(own, all.absolute_N, all.relative);
      },
      {{-most, most}}, {0}, evaluations);
  return std::exp(best.at[0]);
}

std::vector<double> scales_beside(const std::vector<std::vector<ScatterSample>>& groups,
                                  const Noise& all) {
  std::vector<double> scales(groups.size(), 1);
  double logarithms = 0;
  double weights = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (groups[g].empty()) continue;
    scales[g] = scale_beside(groups[g], all);
    logarithms += degrees(groups[g]) * std::log(scales[g]);
    weights += degrees(groups[g]);
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!groups[g].empty()) scales[g] /= std::exp(logarithms / weights);
  }
  return scales;
}

// Nothing if fewer than two groups have enough samples.
std::optional<Trial> trial_by_group(const Dataset& dataset,
                                    const std::vector<ScatterSample>& samples) {
  constexpr int rounds = 2;  // the scatter of all, and that of groups beside it
  const auto groups = by_group(dataset, samples);
  const auto own = std::ranges::count_if(groups, [](const auto& group) { return !group.empty(); });
  if (own < 2) return std::nullopt;
  Trial best = trial(dataset, samples);
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> scales = scales_beside(groups, best.noise);
    best = trial(dataset, scaled(dataset, samples, scales));
    best.noise.of_group = std::move(scales);
  }
  best.misfit += chi_squared_quantile(surely, static_cast<double>(own - 1));
  return best;
}

}  // namespace

double degrees(const std::vector<ScatterSample>& samples) {
  double sum = 0;
  for (const ScatterSample& sample : samples) sum += sample.kept;
  return sum;
}

double least_absolute(const Dataset& dataset) { return floor_share * median_reading(dataset); }

Noise scatter_of_all(const Dataset& dataset, const std::vector<ScatterSample>& samples) {
  return trial(dataset, samples).noise;
}

Noise likeliest_scatter(const Dataset& dataset, const std::vector<ScatterSample>& samples) {
  if (dataset.data->groups.size() < 2) return scatter_of_all(dataset, samples);
  const std::vector<ScatterSample> free = mostly_free(samples);
  const auto by_itself = trial_by_group(dataset, free);
  if (!by_itself || by_itself->misfit >= trial(dataset, free).misfit) {
    return scatter_of_all(dataset, samples);
  }
  Noise result = scatter_of_all(dataset, scaled(dataset, samples, by_itself->noise.of_group));
  result.of_group = by_itself->noise.of_group;
  return result;
}

}  // namespace reeve::diagnosis
