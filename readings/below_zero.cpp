#include "readings/below_zero.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace reeve::readings {

std::vector<DataNote> leave_out_negative_motor_tensions(MeasuredData& data) {
  const auto is_negative = [](const Reading& reading) {
    return reading.motor_tension_N.value_or(0) < 0;
  };
  DataNote note{NoteKind::not_compared,
                "motor_tension_N is below zero, which is no scale for the model's tensions: these "
                "rows are left out. If the sensor's zero has drifted, a tare row takes it off",
                {}};
  for (const Reading& reading : data.readings) {
    if (is_negative(reading)) note.lines.push_back(reading.line);
  }
  if (note.lines.empty()) return {};
  std::erase_if(data.readings, is_negative);
  return {std::move(note)};
}

std::vector<DataNote> notes_below_zero(const MeasuredData& data) {
  DataNote note{NoteKind::below_zero, "", {}};
  std::string counts;
  for (std::size_t c = 0; c < data.channels.size(); ++c) {
    std::size_t below = 0;
    std::size_t given = 0;
    for (const Reading& reading : data.readings) {
      if (!reading.tension_N[c]) continue;
      ++given;
      if (*reading.tension_N[c] >= 0) continue;
      ++below;
      note.lines.push_back(reading.line);
    }
    if (below == 0) continue;
    counts += fmt::format("{}{} of {} of {}", counts.empty() ? "" : ", ", below, given,
                          data.channels[c].name);
  }
  if (note.lines.empty()) return {};
  std::sort(note.lines.begin(), note.lines.end());
  note.lines.erase(std::unique(note.lines.begin(), note.lines.end()), note.lines.end());
  note.text = "readings below zero (" + counts +
              ") are used as they are: a zero that drifts gives them. A tare row takes it off";
  return {std::move(note)};
}

}  // namespace reeve::readings
