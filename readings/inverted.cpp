#include "readings/inverted.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "numerics/robust.hpp"
#include "readings/polished_levels.hpp"

namespace reeve::readings {
namespace {

class SignCount {
 public:
  void add(double tension_N) {
    ++given_;
    below_ += tension_N < 0 ? 1 : 0;
  }
  // Four of five, and enough to tell.
  bool nearly_all_below() const {
    return given_ >= 5 && static_cast<double>(below_) >= 0.8 * static_cast<double>(given_);
  }

 private:
  std::size_t given_ = 0;
  std::size_t below_ = 0;
};

// Statistics of rows that differ only in the load, about their own means. The share of the load
// that arrives depends on everything else.
struct LoadedRows {
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

// Uses the mean correlation over the groups, weighted by their sizes; two rows would give ±1. Noise
// and friction leave far more than -0.5 of it, a drifting zero far less.
bool falls_with_load(const std::vector<LoadedRows>& groups) {
  double sum = 0;
  double weights = 0;
  for (const LoadedRows& alike : groups) {
    const double scale = std::sqrt(alike.square_load * alike.square_reading);
    if (alike.rows < 3 || !(scale > 0)) continue;
    sum += (alike.rows - 1) * alike.product / scale;
    weights += alike.rows - 1;
  }
  return weights > 0 && sum / weights < -0.5;
}

std::optional<DataNote> note_on(const std::vector<std::string>& inverted) {
  if (inverted.empty()) return std::nullopt;
  const bool one = inverted.size() == 1;
  return DataNote{
      NoteKind::inverted,
      fmt::format("{} {} below zero, the more so the more is pulled, which no tendon does: "
                  "exchange the sign in the file if {} mounted or wired the other way round",
                  fmt::join(inverted, ", "), one ? "reads" : "read",
                  one ? "the sensor is" : "the sensors are")};
}

double what_pulls(const Reading& reading, std::size_t channel) {
  if (reading.motor_tension_N) return *reading.motor_tension_N;
  double sum = 0;
  for (std::size_t c = 0; c < reading.tension_N.size(); ++c) {
    if (c != channel) sum += std::abs(reading.tension_N[c].value_or(0));
  }
  return sum;
}

bool is_inverted(const MeasuredData& data, const std::vector<KindCells>& kinds,
                 std::size_t channel) {
  std::vector<LoadedRows> groups;
  SignCount signs;
  for (const KindCells& cells : kinds) {
    LoadedRows& rows = groups.emplace_back();
    for (const KindCell& cell : cells) {
      if (cell.channel != channel) continue;
      signs.add(cell.value_N);
      rows.add(what_pulls(data.readings[cell.reading], channel), cell.value_N);
    }
  }
  return signs.nearly_all_below() && falls_with_load(groups);
}

double size_of(double tension_N) { return std::isnan(tension_N) ? 0 : std::abs(tension_N); }

// Returns the load of each sample.
std::vector<double> what_pulls(const LoggedSeries& series, const LoggedSignal& signal) {
  const LoggedSignal& motor = series.motor_tension_N;
  std::vector<double> loads_N(series.size(), 0);
  const auto add = [&](const LoggedSignal& other) {
    for (std::size_t i = 0; i < loads_N.size(); ++i) loads_N[i] += size_of(other.values[i]);
  };
  if (motor.is_logged() && &signal != &motor) {
    add(motor);
    return loads_N;
  }
  for (const LoggedSignal& tension : series.tensions_N) {
    if (&tension != &signal) add(tension);
  }
  return loads_N;
}

bool is_inverted(const LoggedSeries& series, const LoggedSignal& signal) {
  const std::vector<double> loads_N = what_pulls(series, signal);
  const double half_N = median(loads_N);
  SignCount signs;
  std::vector<LoadedRows> by_label(series.labels.size());
  for (std::size_t i = 0; i < loads_N.size(); ++i) {
    if (std::isnan(signal.values[i])) continue;
    if (loads_N[i] >= half_N) signs.add(signal.values[i]);
    by_label[series.label[i]].add(loads_N[i], signal.values[i]);
  }
  return signs.nearly_all_below() && falls_with_load(by_label);
}

// Whether it falls with the load does not show where pulling and releasing are mixed.
bool is_below_zero(const LoggedSignal& signal) {
  const auto below =
      std::ranges::count_if(signal.values, [](double value_N) { return value_N < 0; });
  return 10 * static_cast<std::size_t>(below) > 9 * signal.values.size();
}

}  // namespace

std::optional<DataNote> inverted_channels(const MeasuredData& data) {
  const std::vector<KindCells> kinds = cells_by_kind(data);
  std::vector<std::string> names;
  for (std::size_t c = 0; c < data.channels.size(); ++c) {
    if (is_inverted(data, kinds, c)) names.push_back(data.channels[c].name);
  }
  return note_on(names);
}

std::optional<DataNote> inverted_signals(const LoggedSeries& series) {
  std::vector<std::string> names;
  for (const LoggedSignal* sensor : series.sensors()) {
    if (is_inverted(series, *sensor)) names.push_back(sensor->name);
  }
  if (names.empty() && std::ranges::all_of(series.tensions_N, is_below_zero)) {
    return DataNote{NoteKind::inverted,
                    "all tensions are below zero, which no tendon does: exchange their sign in the "
                    "file, and that of the motor tension if it is below zero too"};
  }
  return note_on(names);
}

}  // namespace reeve::readings
