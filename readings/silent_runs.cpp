#include "readings/silent_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "numerics/robust.hpp"
#include "readings/csv.hpp"

namespace reeve::readings {

bool has_tension(const Reading& reading) {
  return std::any_of(reading.tension_N.begin(), reading.tension_N.end(),
                     [](const auto& tension) { return tension.has_value(); });
}

namespace {

bool reads_something(const Reading& reading) {
  return std::any_of(reading.tension_N.begin(), reading.tension_N.end(),
                     [](const auto& tension) { return tension.value_or(0) != 0; });
}

std::vector<bool> runs_with(const MeasuredData& data, bool (*is)(const Reading&)) {
  std::vector<bool> result(data.runs.size(), false);
  for (const Reading& reading : data.readings) {
    if (is(reading)) result[reading.run] = true;
  }
  return result;
}

// One whose strands are slack reads 0, too, at the loads of its rows.
double greatest_load(const MeasuredData& data, std::size_t run) {
  double greatest_N = 0;
  for (const Reading& reading : data.readings) {
    if (reading.run != run) continue;
    greatest_N = std::max(greatest_N, reading.motor_tension_N.value_or(0));
  }
  return greatest_N;
}

double usual_load(const MeasuredData& data) {
  std::vector<double> loads_N;
  for (const Reading& reading : data.readings) {
    if (reads_something(reading)) loads_N.push_back(reading.motor_tension_N.value_or(0));
  }
  return median(loads_N);
}

void take_out(MeasuredData& data, const std::vector<bool>& silent) {
  std::erase_if(data.readings, [&](const Reading& reading) { return silent[reading.run]; });
  std::vector<std::size_t> places;
  std::vector<std::string> names;
  for (std::size_t run = 0; run < silent.size(); ++run) {
    places.push_back(names.size());
    if (!silent[run]) names.push_back(std::move(data.runs[run]));
  }
  for (Reading& reading : data.readings) reading.run = places[reading.run];
  data.runs = std::move(names);
}

}  // namespace

void leave_out_silent_runs(MeasuredData& data) {
  if (data.runs.size() < 2) return;
  const std::vector<bool> tells = runs_with(data, reads_something);
  if (std::find(tells.begin(), tells.end(), true) == tells.end()) return;
  const std::vector<bool> has = runs_with(data, has_tension);
  const double usual_N = usual_load(data);
  std::vector<bool> silent(data.runs.size(), false);
  std::vector<DataNote> notes;
  for (std::size_t run = 0; run < silent.size(); ++run) {
    if (tells[run] || (has[run] && greatest_load(data, run) < usual_N)) continue;
    silent[run] = true;
    notes.push_back(
        {NoteKind::silent_run,
         fmt::format("run '{}' has {}: it is left out", for_message(data.runs[run]),
                     has[run] ? "tensions of 0 alone, at loads at which others read more"
                              : "no tension in any of its rows"),
         lines_where(data, [&](const Reading& reading) { return reading.run == run; })});
  }
  if (notes.empty()) return;
  take_out(data, silent);
  std::move(notes.begin(), notes.end(), std::back_inserter(data.notes));
}

}  // namespace reeve::readings
