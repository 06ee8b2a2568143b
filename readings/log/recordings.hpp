// A log falls into recordings: stretches of samples over which the clock runs forward, and labels
// and zeros stay. A logger that is started anew sets its clock back, a new mounting changes the
// run, and new zeros make other tensions of what a sensor reads; no reading reaches over any of
// these.
//
// A clock that goes back all the time is no clock: where it does so more than once in twenty
// samples, that is an InputError which names the first line.
//
// Each is looked at in short blocks, in which every signal is its median, so that single wild
// samples do not matter, and the time of the search is linear in the size of the log. A block lasts
// a fifth of the least time that a reading shall last, and at least three steps of the clock.
// Blocks without a sample are left out: neighbours in the list need not be so in time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/grasp.hpp"
#include "numerics/robust.hpp"
#include "readings/log/logged_series.hpp"

namespace reeve::readings {

struct Recording {
  std::size_t begin = 0;  // samples [begin, end)
  std::size_t end = 0;
  std::size_t label = 0;  // index into LoggedSeries::labels
};

struct Recordings {
  std::vector<Recording> parts;             // sorted by sample; none is empty
  std::vector<std::size_t> clock_set_back;  // lines at which the clock is behind the line before
};

Recordings recordings(const LoggedSeries& series);

// Median of the steps of the clock that are not 0; 0 if there is none.
double usual_step(const LoggedSeries& series, const std::vector<Recording>& parts);

inline constexpr std::size_t blocks_per_min_duration = 5;

struct SeriesBlock {
  std::size_t begin = 0;  // samples [begin, end)
  std::size_t end = 0;
  double time_s = 0;       // mean
  double position_mm = 0;  // NaN: not logged, as for the others
  double speed_mm_s = 0;
  double load_N = 0;               // motor tension, or the sum of the tensions
  std::vector<double> tensions_N;  // parallel to the series' tensions
};

// Successive blocks of a recording that may give readings.
struct BlockStretch {
  std::size_t begin = 0;  // blocks [begin, end)
  std::size_t end = 0;
  std::optional<Direction> direction;  // nothing if the log does not say
};

// The median of a signal over the first and over the last third of blocks [begin, end).
struct EndLevels {
  double first = 0;
  double last = 0;
};
template <typename Signal>
EndLevels end_levels(std::size_t begin, std::size_t end, Signal signal) {
  std::vector<double> first;
  std::vector<double> last;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, (end - begin) / 3); ++i) {
    first.push_back(signal(begin + i));
    last.push_back(signal(end - 1 - i));
  }
  return {median(std::move(first)), median(std::move(last))};
}

double block_width(double min_duration_s, double usual_step_s);

std::vector<SeriesBlock> series_blocks(const LoggedSeries& series, const Recording& part,
                                       double width_s);

// True if samples are missing between a block and the next: more than two widths.
bool is_gap(const SeriesBlock& block, const SeriesBlock& next, double width_s);

}  // namespace reeve::readings
