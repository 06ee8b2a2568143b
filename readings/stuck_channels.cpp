#include "readings/stuck_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "readings/csv.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t least_readings = 5;
constexpr std::size_t least_values = 10;
constexpr double stuck_share = 0.02;
constexpr double moved_share = 0.5;

struct Values {
  std::vector<double> channel_N;
  std::vector<double> motor_N;
};

double span(const std::vector<double>& values) {
  const auto [least, greatest] = std::ranges::minmax(values);
  return greatest - least;
}

// By run, of one routing.
using RunValues = std::map<std::size_t, Values>;

std::map<std::size_t, RunValues> by_routing(const MeasuredData& data, std::size_t channel) {
  std::map<std::size_t, RunValues> result;
  for (const Reading& reading : data.readings) {
    if (!reading.tension_N[channel] || !reading.motor_tension_N) continue;
    Values& values = result[reading.routing][reading.run];
    values.channel_N.push_back(*reading.tension_N[channel]);
    values.motor_N.push_back(*reading.motor_tension_N);
  }
  return result;
}

bool is_stuck(const RunValues& runs, std::size_t run) {
  const Values& own = runs.at(run);
  if (own.channel_N.size() < least_readings) return false;
  double channel_span = 0;
  double motor_span = 0;
  std::set<double> different;
  for (const auto& [other, values] : runs) {
    if (other == run) continue;
    channel_span = std::max(channel_span, span(values.channel_N));
    motor_span = std::max(motor_span, span(values.motor_N));
    different.insert(values.channel_N.begin(), values.channel_N.end());
  }
  if (different.size() < least_values) return false;
  const bool reads = std::ranges::any_of(own.channel_N, [](double value) { return value != 0; });
  return reads && span(own.channel_N) < stuck_share * channel_span &&
         span(own.motor_N) > moved_share * motor_span;
}

}  // namespace

void leave_out_stuck_channels(MeasuredData& data) {
  for (std::size_t channel = 0; channel < data.channels.size(); ++channel) {
    std::set<std::pair<std::size_t, std::size_t>> stuck;  // routing and run
    for (const auto& [routing, runs] : by_routing(data, channel)) {
      for (const auto& [run, values] : runs) {
        if (is_stuck(runs, run)) stuck.insert({routing, run});
      }
    }
    for (const auto& [routing, run] : stuck) {
      const auto is_it = [&, of = routing, in = run](const Reading& reading) {
        return reading.routing == of && reading.run == in && reading.tension_N[channel];
      };
      const auto first = std::ranges::find_if(data.readings, is_it);
      data.notes.push_back(
          {NoteKind::stuck_channel,
           fmt::format("{}_N reads {:.4g} N in run '{}', whatever pulls: these readings are left "
                       "out",
                       data.channels[channel].name, *first->tension_N[channel],
                       for_message(data.runs[run])),
           lines_where(data, is_it)});
      for (Reading& reading : data.readings) {
        if (is_it(reading)) reading.tension_N[channel].reset();
      }
    }
  }
}

}  // namespace reeve::readings
