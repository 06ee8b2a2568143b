#include "readings/inverted.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "numerics/robust.hpp"

namespace reeve::readings {

namespace {

// What pulls: the motor, or all that is read beside the channel.
double load_N(const Reading& reading, std::size_t channel) {
  if (reading.motor_tension_N) return *reading.motor_tension_N;
  double sum = 0;
  for (std::size_t c = 0; c < reading.tension_N.size(); ++c) {
    if (c != channel) sum += std::abs(reading.tension_N[c].value_or(0));
  }
  return sum;
}

// By routing, grasp and direction.
using RowsAlike = std::tuple<std::size_t, std::uint64_t, Direction>;

bool is_inverted(const MeasuredData& data, std::size_t channel) {
  std::map<RowsAlike, LoadedRows> rows;
  SignCount signs;
  for (const Reading& reading : data.readings) {
    const auto& tension = reading.tension_N[channel];
    if (!tension) continue;
    signs.add(*tension);
    rows[{reading.routing, reading.grasp.held, reading.direction}].add(load_N(reading, channel),
                                                                       *tension);
  }
  if (!signs.nearly_all_below()) return false;
  std::vector<LoadedRows> groups;
  for (const auto& [alike, group] : rows) groups.push_back(group);
  return falls_with_load(groups);
}

}  // namespace

std::optional<DataNote> note_on_inverted(const std::vector<std::string>& channels) {
  if (channels.empty()) return std::nullopt;
  const bool one = channels.size() == 1;
  return DataNote{
      NoteKind::inverted,
      fmt::format("{} {} below zero, the more so the more is pulled, which no tendon does: "
                  "exchange the sign in the file if {} mounted or wired the other way round",
                  fmt::join(channels, ", "), one ? "reads" : "read",
                  one ? "the sensor is" : "the sensors are"),
      {}};
}

std::optional<DataNote> note_inverted(const MeasuredData& data) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < data.channels.size(); ++c) {
    if (is_inverted(data, c)) names.push_back(data.channels[c].name);
  }
  return note_on_inverted(names);
}

namespace {

double size_of(double tension_N) { return std::isnan(tension_N) ? 0 : std::abs(tension_N); }

// Of each sample, over the tensions but the one that is left out.
std::vector<double> sums_without(const LoggedSeries& series, const LoggedSignal& left_out) {
  std::vector<double> sums_N(series.size(), 0);
  for (const LoggedSignal& tension : series.tensions_N) {
    if (&tension == &left_out) continue;
    for (std::size_t i = 0; i < sums_N.size(); ++i) sums_N[i] += size_of(tension.values[i]);
  }
  return sums_N;
}

std::vector<double> what_pulls(const LoggedSeries& series, const LoggedSignal& signal) {
  const LoggedSignal& motor = series.motor_tension_N;
  if (!motor.is_logged() || &signal == &motor) return sums_without(series, signal);
  std::vector<double> sizes_N;
  for (const double tension_N : motor.values) sizes_N.push_back(size_of(tension_N));
  return sizes_N;
}

bool is_below_zero_under_load(const LoggedSignal& signal, const std::vector<double>& loads_N) {
  const double half_N = median(loads_N);
  SignCount signs;
  for (std::size_t i = 0; i < loads_N.size(); ++i) {
    if (loads_N[i] >= half_N && !std::isnan(signal.values[i])) signs.add(signal.values[i]);
  }
  return signs.nearly_all_below();
}

bool is_inverted_signal(const LoggedSeries& series, const LoggedSignal& signal) {
  if (!signal.is_logged()) return false;
  const std::vector<double> loads_N = what_pulls(series, signal);
  if (!is_below_zero_under_load(signal, loads_N)) return false;
  std::vector<LoadedRows> by_label(series.labels.size());
  for (std::size_t i = 0; i < loads_N.size(); ++i) {
    if (!std::isnan(signal.values[i])) by_label[series.label[i]].add(loads_N[i], signal.values[i]);
  }
  return falls_with_load(by_label);
}

}  // namespace

std::optional<DataNote> inverted_signals(const LoggedSeries& series) {
  std::vector<std::string> names;
  if (is_inverted_signal(series, series.motor_tension_N))
    names.push_back(series.motor_tension_N.name);
  for (const LoggedSignal& tension : series.tensions_N) {
    if (is_inverted_signal(series, tension)) names.push_back(tension.name);
  }
  return note_on_inverted(names);
}

}  // namespace reeve::readings
