#include "readings/inverted.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "readings/load_sign.hpp"

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

}  // namespace reeve::readings
