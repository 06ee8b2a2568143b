#include "readings/stuck_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "numerics/robust.hpp"
#include "readings/csv.hpp"
#include "readings/silent_runs.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t least_readings = 5;
constexpr std::size_t least_values = 10;
constexpr double stuck_share = 0.02;
constexpr double moved_share = 0.5;
constexpr double same_share = 0.1;

struct Values {
  std::vector<double> channel_N;
  std::vector<double> motor_N;
};

// Without the least and the greatest: one bad cell is no span.
double inner_span(std::vector<double> values) {
  if (values.size() < least_readings) return 0;
  std::ranges::sort(values);
  return values[values.size() - 2] - values[1];
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

// The greatest spans of all runs of a routing.
struct GreatestSpans {
  double channel_N = 0;
  double motor_N = 0;
};

GreatestSpans greatest_spans(const RunValues& runs) {
  GreatestSpans greatest;
  for (const auto& [run, values] : runs) {
    greatest.channel_N = std::max(greatest.channel_N, inner_span(values.channel_N));
    greatest.motor_N = std::max(greatest.motor_N, inner_span(values.motor_N));
  }
  return greatest;
}

bool have_different_values(const RunValues& runs, std::size_t beside) {
  std::set<double> different;
  for (const auto& [run, values] : runs) {
    if (run == beside) continue;
    for (const double value : values.channel_N) {
      different.insert(value);
      if (different.size() >= least_values) return true;
    }
  }
  return false;
}

bool is_stuck(const Values& own, const GreatestSpans& greatest) {
  if (own.channel_N.size() < least_readings) return false;
  const double span_N = inner_span(own.channel_N);
  return span_N < same_share * std::abs(median(own.channel_N)) &&
         span_N < stuck_share * greatest.channel_N &&
         inner_span(own.motor_N) > moved_share * greatest.motor_N;
}

// Whole runs without one are left out later (silent_runs.hpp).
void take_out_rows_without_tension(MeasuredData& data) {
  std::vector<bool> tells(data.runs.size(), false);
  for (const Reading& reading : data.readings) {
    if (has_tension(reading)) tells[reading.run] = true;
  }
  std::erase_if(data.readings, [&](const Reading& reading) {
    return tells[reading.run] && !has_tension(reading);
  });
}

}  // namespace

void leave_out_stuck_channels(MeasuredData& data) {
  for (std::size_t channel = 0; channel < data.channels.size(); ++channel) {
    std::set<std::pair<std::size_t, std::size_t>> stuck;  // routing and run
    for (const auto& [routing, runs] : by_routing(data, channel)) {
      const GreatestSpans greatest = greatest_spans(runs);
      for (const auto& [run, values] : runs) {
        if (is_stuck(values, greatest) && have_different_values(runs, run)) {
          stuck.insert({routing, run});
        }
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
  take_out_rows_without_tension(data);
}

}  // namespace reeve::readings
