// A log falls into recordings: stretches of samples over which the clock runs forward, and labels
// and zeros stay. A logger that is started anew sets its clock back, a new mounting changes the
// run, and new zeros make other tensions of what a sensor reads; no reading reaches over any of
// these.
//
// A clock that goes back all the time is no clock: where it does so more than once in twenty
// samples, that is an InputError which names the first line.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "readings/log/logged_series.hpp"

namespace reeve::readings {

struct Recording {
  std::size_t begin = 0;  // samples [begin, end)
  std::size_t end = 0;
  std::size_t label = 0;  // in LoggedSeries::labels
};

struct Recordings {
  std::vector<Recording> parts;             // in the order of the samples; none is empty
  std::vector<std::size_t> clock_set_back;  // lines at which the clock is behind the line before
};

Recordings recordings(const LoggedSeries& series);

// Median of the steps of the clock that are not 0; 0 if there is none.
double usual_step(const LoggedSeries& series, const std::vector<Recording>& parts);

// If the unit of the clock is assumed, and makes steps that are long for a log of a carriage, or
// dates to come: most loggers whose clock has no unit count milliseconds. `map_option` as in
// ReadingOptions.
std::optional<DataNote> doubt_of_seconds(const LoggedSeries& series, const std::string& clock,
                                         const std::string& map_option);

}  // namespace reeve::readings
