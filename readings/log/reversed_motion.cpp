#include "readings/log/reversed_motion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <utility>

#include "numerics/robust.hpp"

namespace reeve::readings {
namespace {

constexpr double standard_errors = 3;
constexpr double of_a_median = 1.5707963267948966;  // π/2: its variance over that of a mean

struct MedianLoad {
  std::size_t readings = 0;
  double median_N = 0;
  double variance = 0;  // of the median, N²
};

MedianLoad median_load(const std::vector<SteadyReading>& readings, Direction direction) {
  std::vector<double> loads_N;
  std::vector<double> variances;  // of each
  for (const SteadyReading& reading : readings) {
    const auto& load = reading.motor_tension_N;
    if (reading.direction != direction || !load) continue;
    loads_N.push_back(load->mean_N);
    variances.push_back(load->deviation_N * load->deviation_N /
                        static_cast<double>(reading.readings));
  }
  MedianLoad result{loads_N.size(), median(loads_N), 0};
  for (double& load_N : loads_N) load_N -= result.median_N;
  const double scatter_N = mad_about_zero(std::move(loads_N));
  const double variance = scatter_N * scatter_N + median(std::move(variances));
  result.variance = of_a_median * variance / static_cast<double>(result.readings);
  return result;
}

}  // namespace

std::optional<DataNote> reversed_motion(const std::vector<SteadyReading>& readings,
                                        double tolerance) {
  const MedianLoad pull = median_load(readings, Direction::pull);
  const MedianLoad release = median_load(readings, Direction::release);
  if (pull.readings == 0 || release.readings == 0) return std::nullopt;
  const double by_chance_N = standard_errors * std::sqrt(pull.variance + release.variance);
  const double allowed_N = by_chance_N + tolerance * std::abs(release.median_N);
  if (release.median_N - pull.median_N <= allowed_N) return std::nullopt;
  return DataNote{
      NoteKind::reversed,
      fmt::format("the motor tension is less while pulling (median {:.3g} N) than while releasing "
                  "({:.3g} N), and friction makes it more: does the position or speed count the "
                  "other way?",
                  pull.median_N, release.median_N),
      {}};
}

}  // namespace reeve::readings
