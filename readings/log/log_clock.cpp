#include "readings/log/log_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "numerics/robust.hpp"
#include "readings/log/recordings.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t samples_per_repeat = 20;
constexpr double gap = 2;  // usual steps

// Samples [begin, end) that show the same time.
struct ClockStamp {
  std::size_t begin = 0;
  std::size_t end = 0;

  double count() const { return static_cast<double>(end - begin); }
};

std::vector<ClockStamp> stamps_of(const std::vector<double>& time_s) {
  std::vector<ClockStamp> stamps;
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    if (i == 0 || time_s[i] != time_s[i - 1]) stamps.push_back({i, i});
    stamps.back().end = i + 1;
  }
  return stamps;
}

// Returns the step of one sample for each stamp, up to the next stamp. It is not above 0 if the
// clock is set back.
std::vector<double> steps_of(const std::vector<ClockStamp>& stamps,
                             const std::vector<double>& time_s) {
  std::vector<double> steps;
  for (std::size_t k = 0; k + 1 < stamps.size(); ++k) {
    steps.push_back((time_s[stamps[k + 1].begin] - time_s[stamps[k].begin]) / stamps[k].count());
  }
  return steps;
}

void spread_repeated_times(LoggedSeries& series) {
  std::vector<double>& time_s = series.time_s;
  const std::vector<ClockStamp> stamps = stamps_of(time_s);
  const std::size_t repeats = time_s.size() - stamps.size();
  if (repeats * samples_per_repeat < time_s.size() || stamps.size() < 2) return;
  std::vector<double> steps = steps_of(stamps, time_s);
  const double usual = median(steps);
  if (!(usual > 0)) return;
  steps.push_back(usual);
  for (std::size_t k = 0; k < stamps.size(); ++k) {
    const double step = steps[k] > 0 && steps[k] <= gap * usual ? steps[k] : usual;
    for (std::size_t i = stamps[k].begin + 1; i < stamps[k].end; ++i)
      time_s[i] = time_s[i - 1] + step;
  }
  series.notes.push_back(
      {NoteKind::clock,
       fmt::format(
           "{} of {} samples show the time of the one before: the clock is coarser than the "
           "samples, which are spread evenly between its steps",
           repeats, time_s.size())});
}

// Year of a clock that counts seconds since 1970, as most clocks with a date do.
double year_at(double time_s) { return 1970 + time_s / (365.2425 * 86400); }

void doubt_of_seconds(LoggedSeries& series, const std::string& clock, double step_s,
                      const std::string& map_option) {
  constexpr double long_step_s = 1;  // twice as long as a reading lasts at least
  constexpr double last_year = 2100;
  const double year = year_at(*std::max_element(series.time_s.begin(), series.time_s.end()));
  if (step_s < long_step_s && year <= last_year) return;
  std::string text =
      fmt::format("the clock '{}' has no unit: in seconds its samples are mostly {:.3g} s apart",
                  clock, step_s);
  if (year > last_year) text += fmt::format(", and it shows the year {:.0f}", year);
  text += ". If it counts milliseconds, it is time_ms";
  if (!map_option.empty()) {
    text += fmt::format(", and {} '{}=time_ms' says so", map_option, clock);
  }
  series.notes.push_back({NoteKind::clock, text});
}

// The advice depends on the unit of the clock.
std::string advice_on_unit(const DataColumn& clock, const ReadingOptions& options) {
  if (clock.unit.factor >= 1) {
    return "If it counts days, as spreadsheets do, multiply it by 86400, which makes seconds";
  }
  std::string text = "If it counts seconds, it is time_s";
  if (!options.unit_option.empty()) {
    text += fmt::format(", and {} '{}=s' says so", options.unit_option, for_message(clock.name));
  }
  return text;
}

void doubt_of_fast_clock(LoggedSeries& series, const DataColumn& clock, double step_s,
                         const ReadingOptions& options) {
  constexpr double short_step_s = 1.0 / 5000;
  if (!(step_s > 0) || step_s >= short_step_s) return;
  const auto [first, last] = std::minmax_element(series.time_s.begin(), series.time_s.end());
  series.notes.push_back(
      {NoteKind::clock,
       fmt::format("by the clock '{}', in {}, samples are mostly {:.3g} s apart and the log lasts "
                   "{:.3g} s, which is fast for a carriage. {}",
                   for_message(clock.name), clock.unit.name, step_s, *last - *first,
                   advice_on_unit(clock, options))});
}

}  // namespace

void check_clock(LoggedSeries& series, const DataColumn& clock, const ReadingOptions& options) {
  spread_repeated_times(series);
  const double step_s = usual_step(series, {{0, series.size(), 0}});
  if (clock.unit_is_assumed) {
    doubt_of_seconds(series, for_message(clock.name), step_s, options.map_option);
  }
  doubt_of_fast_clock(series, clock, step_s, options);
}

}  // namespace reeve::readings
