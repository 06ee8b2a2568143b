#include "readings/log/log_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numerics/robust.hpp"

namespace reeve::readings {
namespace {

constexpr double standard_errors = 3;
constexpr double of_a_median = 1.5707963267948966;  // π/2: its variance over that of a mean

struct MedianLoad {
  std::size_t readings = 0;
  double median_N = 0;
  double variance = 0;  // variance of the median, N²
};

MedianLoad median_load(const std::vector<SteadyReading>& readings, Direction direction) {
  std::vector<double> loads_N;
  std::vector<double> variances;  // variance of each load
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

// Returns a note on the readings that lack a channel which some of their samples have.
template <typename HasMean>
std::optional<DataNote> sparse_channel(const LoggedSeries& series, const LoggedSignal& signal,
                                       const std::vector<SteadyReading>& readings,
                                       HasMean has_mean) {
  DataNote note{NoteKind::sparse, ""};
  std::size_t samples = 0;
  std::size_t missing = 0;
  for (const SteadyReading& reading : readings) {
    if (has_mean(reading)) continue;
    const std::size_t all = reading.end - reading.begin;
    std::size_t none = 0;
    for (std::size_t i = reading.begin; i < reading.end; ++i) {
      none += std::isnan(signal.values[i]) ? 1 : 0;
    }
    if (none == all) continue;
    samples += all;
    missing += none;
    note.lines.push_back(series.lines[reading.begin]);
  }
  if (note.lines.empty()) return std::nullopt;
  const double share = static_cast<double>(missing) / static_cast<double>(samples);
  note.text = fmt::format(
      "{} is missing in {:.0f} % of the samples of {} of the readings, which therefore do not have "
      "it: of a sensor that is logged more seldom than the others keep the rows that have it",
      signal.name, 100 * share, note.lines.size());
  return note;
}

}  // namespace

void SaidDirections::add(const std::string& run, std::optional<Direction> said,
                         std::optional<Direction> moved, std::size_t line) {
  if (!said || !moved) return;
  Lines& lines = lines_[{run, *said}];
  (*said == *moved ? lines.as_said : lines.otherwise).push_back(line);
}

std::optional<DataNote> SaidDirections::note() const {
  DataNote result{NoteKind::against_motion,
                  "the column 'direction' says one direction while the carriage moves one way and "
                  "the other, in one run: readings have what the column says, and where it is not "
                  "the motion it is wrong here, or, if the position counts the other way, "
                  "everywhere else"};
  for (const auto& [key, lines] : lines_) {
    if (lines.as_said.empty()) continue;
    result.lines.insert(result.lines.end(), lines.otherwise.begin(), lines.otherwise.end());
  }
  if (result.lines.empty()) return std::nullopt;
  std::sort(result.lines.begin(), result.lines.end());
  return result;
}

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
                  pull.median_N, release.median_N)};
}

std::vector<DataNote> sparse_channels(const LoggedSeries& series,
                                      const std::vector<SteadyReading>& readings) {
  std::vector<DataNote> notes;
  const auto add = [&](std::optional<DataNote> note) {
    if (note) notes.push_back(std::move(*note));
  };
  if (series.motor_tension_N.is_logged()) {
    add(sparse_channel(series, series.motor_tension_N, readings, [](const SteadyReading& reading) {
      return reading.motor_tension_N.has_value();
    }));
  }
  for (std::size_t i = 0; i < series.tensions_N.size(); ++i) {
    add(sparse_channel(series, series.tensions_N[i], readings, [i](const SteadyReading& reading) {
      return reading.tensions_N[i].has_value();
    }));
  }
  return notes;
}

}  // namespace reeve::readings
