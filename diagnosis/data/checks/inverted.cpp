#include "diagnosis/data/checks/inverted.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>

namespace reeve::diagnosis {
namespace {

constexpr std::size_t enough_to_tell_a_sign = 5;
constexpr double nearly_all_below = 0.8;
// With the load; noise and friction leave far more, a drifting zero far less.
constexpr double falls_with_load = -0.5;

// What pulls: the motor, or all that is read beside the channel.
double load_N(const Reading& reading, std::size_t channel) {
  if (reading.motor_tension_N) return *reading.motor_tension_N;
  double sum = 0;
  for (std::size_t c = 0; c < reading.tension_N.size(); ++c) {
    if (c != channel) sum += std::abs(reading.tension_N[c].value_or(0));
  }
  return sum;
}

// Of rows alike but for the load, about their own means: what arrives of a load depends on all
// else.
struct Alike {
  double rows = 0;
  double mean_load = 0, mean_reading = 0;
  double square_load = 0, square_reading = 0;
  double product = 0;

  void add(double load, double reading) {
    ++rows;
    const double load_off = load - mean_load;
    const double reading_off = reading - mean_reading;
    mean_load += load_off / rows;
    mean_reading += reading_off / rows;
    square_load += load_off * (load - mean_load);
    square_reading += reading_off * (reading - mean_reading);
    product += load_off * (reading - mean_reading);
  }
};

using AlikeRows = std::map<std::tuple<std::size_t, std::uint64_t, Direction>, Alike>;

// The mean over the groups, of which each has a size of its own; of two rows it would be ±1.
double correlation(const AlikeRows& groups) {
  double sum = 0;
  double weights = 0;
  for (const auto& [key, alike] : groups) {
    const double scale = std::sqrt(alike.square_load * alike.square_reading);
    if (alike.rows < 3 || !(scale > 0)) continue;
    sum += (alike.rows - 1) * alike.product / scale;
    weights += alike.rows - 1;
  }
  return weights > 0 ? sum / weights : 0;
}

bool is_inverted(const MeasuredData& data, std::size_t channel) {
  AlikeRows rows;
  std::size_t given = 0;
  std::size_t below = 0;
  for (const Reading& reading : data.readings) {
    const auto& tension = reading.tension_N[channel];
    if (!tension) continue;
    ++given;
    below += *tension < 0 ? 1 : 0;
    rows[{reading.routing, reading.grasp.held, reading.direction}].add(load_N(reading, channel),
                                                                       *tension);
  }
  return given >= enough_to_tell_a_sign &&
         static_cast<double>(below) >= nearly_all_below * static_cast<double>(given) &&
         correlation(rows) < falls_with_load;
}

}  // namespace

std::vector<DataNote> notes_inverted(const MeasuredData& data) {
  std::string names;
  std::size_t count = 0;
  for (std::size_t c = 0; c < data.channels.size(); ++c) {
    if (!is_inverted(data, c)) continue;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", data.channels[c].name);
    ++count;
  }
  if (count == 0) return {};
  return {{NoteKind::inverted,
           fmt::format("{} {} below zero, the more so the more is pulled, which no tendon does: "
                       "exchange the sign in the file if {} mounted or wired the other way round",
                       names, count == 1 ? "reads" : "read",
                       count == 1 ? "the sensor is" : "the sensors are"),
           {}}};
}

}  // namespace reeve::diagnosis
