#include "readings/log/coarse_clock.hpp"

#include <fmt/format.h>

#include <vector>

#include "numerics/robust.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t samples_per_repeat = 20;
constexpr double gap = 2;  // usual steps

// Samples [begin, end) that show the same time.
struct Stamp {
  std::size_t begin = 0;
  std::size_t end = 0;

  double count() const { return static_cast<double>(end - begin); }
};

std::vector<Stamp> stamps_of(const std::vector<double>& time_s) {
  std::vector<Stamp> stamps;
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    if (i == 0 || time_s[i] != time_s[i - 1]) stamps.push_back({i, i});
    stamps.back().end = i + 1;
  }
  return stamps;
}

// Of a sample, up to the next stamp; not above 0 where the clock is set back.
std::vector<double> steps_of(const std::vector<Stamp>& stamps, const std::vector<double>& time_s) {
  std::vector<double> steps;
  for (std::size_t k = 0; k + 1 < stamps.size(); ++k) {
    steps.push_back((time_s[stamps[k + 1].begin] - time_s[stamps[k].begin]) / stamps[k].count());
  }
  return steps;
}

}  // namespace

std::optional<DataNote> spread_repeated_times(LoggedSeries& series) {
  std::vector<double>& time_s = series.time_s;
  const std::vector<Stamp> stamps = stamps_of(time_s);
  const std::size_t repeats = time_s.size() - stamps.size();
  if (repeats * samples_per_repeat < time_s.size() || stamps.size() < 2) return std::nullopt;
  std::vector<double> steps = steps_of(stamps, time_s);
  const double usual = median(steps);
  if (!(usual > 0)) return std::nullopt;
  steps.push_back(usual);
  for (std::size_t k = 0; k < stamps.size(); ++k) {
    const double step = steps[k] > 0 && steps[k] <= gap * usual ? steps[k] : usual;
    for (std::size_t i = stamps[k].begin + 1; i < stamps[k].end; ++i)
      time_s[i] = time_s[i - 1] + step;
  }
  return DataNote{NoteKind::clock,
                  fmt::format("{} of {} samples show the time of the one before: the clock is "
                              "coarser than the samples, which are spread evenly between its steps",
                              repeats, time_s.size()),
                  {}};
}

}  // namespace reeve::readings
