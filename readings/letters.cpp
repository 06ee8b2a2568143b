#include "readings/letters.hpp"

#include <fmt/format.h>

#include <string>

#include "core/motor_sides.hpp"

namespace reeve::readings {

namespace {

// By channel, whether a reading of that routing has it.
std::vector<bool> measured_channels(const MeasuredData& data, std::size_t routing) {
  std::vector<bool> measured(data.channels.size());
  for (const Reading& reading : data.readings) {
    if (reading.routing != routing) continue;
    for (std::size_t c = 0; c < measured.size(); ++c) {
      measured[c] = measured[c] || reading.tension_N[c].has_value();
    }
  }
  return measured;
}

// "a is beside T4", of the letters that are measured.
std::string key_of(const MeasuredData& data, std::size_t index) {
  const MeasuredRouting& routing = data.routings[index];
  const std::vector<bool> measured = measured_channels(data, index);
  std::string key;
  for (const MotorSide& side : motor_sides(routing.network)) {
    for (std::size_t c = 0; c < measured.size(); ++c) {
      if (!measured[c] || routing.segments[c] != side.motor_side) continue;
      key += fmt::format("{}{} is beside {}", key.empty() ? "" : ", ", data.channels[c].name,
                         segment_name(routing.network.segments[side.hand]));
    }
  }
  return key;
}

}  // namespace

std::vector<DataNote> notes_on_letters(const MeasuredData& data, bool lettered) {
  std::vector<DataNote> notes;
  if (!lettered) return notes;
  for (std::size_t i = 0; i < data.routings.size(); ++i) {
    const MeasuredRouting& routing = data.routings[i];
    if (letters_match_strands(routing.network)) continue;
    const std::string key = key_of(data, i);
    if (key.empty()) continue;
    notes.push_back({NoteKind::letters,
                     fmt::format("letters run in walk order: in {} {}. Where a, b, c, d were meant "
                                 "beside T1, T2, T3, T4, name the columns at_T1_N and so on",
                                 routing.word, key),
                     {}});
  }
  return notes;
}

}  // namespace reeve::readings
