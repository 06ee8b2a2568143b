#include "readings/data_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/motor_sides.hpp"
#include "numerics/robust.hpp"
#include "readings/column_name.hpp"
#include "readings/copies.hpp"
#include "readings/directions.hpp"
#include "readings/inverted.hpp"
#include "readings/recognise_series.hpp"
#include "readings/row_order.hpp"

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

namespace {

void add_motor_side(const MeasuredData& data, std::vector<DataNote>& notes) {
  DataNote note{NoteKind::motor_side_above_motor, "", {}};
  for (const Reading& reading : data.readings) {
    if (!reading.motor_tension_N) continue;
    bool above = false;
    for (std::size_t i = 0; i < data.channels.size(); ++i) {
      above |=
          data.channels[i].segment.kind == SegmentKind::motor_side &&
          reading.tension_N[i].value_or(0) > (1 + motor_side_tolerance) * *reading.motor_tension_N;
    }
    if (above) note.lines.push_back(reading.line);
  }
  if (note.lines.empty()) return;
  note.text = fmt::format(
      "a motor-side segment carries over {:.0f} % more than motor_tension_N, which is the sum of all "
      "of them: check the units and the zeros of the sensors",
      100 * motor_side_tolerance);
  notes.push_back(std::move(note));
}

void add_units(const std::string& what, double median, double low, double high,
               const std::string& unit, std::vector<DataNote>& notes) {
  if (std::isnan(median) || (median >= low && median <= high)) return;
  notes.push_back(
      {NoteKind::units,
       fmt::format("the median of {} is {:.3g}{}, and from {} to {} is plausible: is it "
                   "in another unit than newton?",
                   what, median, unit, low, high),
       {}});
}

// A third below zero: what is above it is noise about nothing, too, and has no unit.
bool reads_nothing(std::size_t above_zero, std::size_t below_zero) {
  return below_zero > 0 && 2 * below_zero >= above_zero;
}

// Zeros are left out: a slack strand says nothing about units.
void add_units(const MeasuredData& data, std::vector<DataNote>& notes) {
  const auto add_tension = [&](const std::string& what, const std::vector<double>& tensions) {
    add_units(what, median(tensions), least_plausible_tension_N, greatest_plausible_tension_N, " N",
              notes);
  };
  std::vector<double> motor;
  for (const Reading& reading : data.readings) {
    if (reading.motor_tension_N.value_or(0) > 0) motor.push_back(*reading.motor_tension_N);
  }
  add_tension("motor_tension_N", motor);
  for (std::size_t i = 0; i < data.channels.size(); ++i) {
    const std::string column =
        plain_name({DataRole::tension, {data.channels[i].segment, false}, {}, false});
    std::vector<double> tensions, ratios;
    std::size_t below_zero = 0;
    for (const Reading& reading : data.readings) {
      const double tension = reading.tension_N[i].value_or(0);
      below_zero += tension < 0 ? 1 : 0;
      if (tension > 0) tensions.push_back(tension);
      if (tension > 0 && reading.motor_tension_N.value_or(0) > 0) {
        ratios.push_back(tension / *reading.motor_tension_N);
      }
    }
    if (reads_nothing(tensions.size(), below_zero)) continue;
    add_tension(column, tensions);
    add_units(column + " over motor_tension_N", median(ratios), least_plausible_ratio,
              greatest_plausible_ratio, "", notes);
  }
}

// The clock gives rows their order, and is no news to whoever logged it.
void add_covariates(const MeasuredData& data, std::vector<DataNote>& notes) {
  const std::optional<std::size_t> clock = clock_of(data);
  for (std::size_t c = 0; c < data.covariates.size(); ++c) {
    if (c == clock) continue;
    notes.push_back(
        {NoteKind::covariate,
         fmt::format("column '{}' is read as a covariate, which the model does not know",
                     for_message(data.covariates[c])),
         {}});
  }
}

}  // namespace

std::vector<std::size_t> repeated_readings(const MeasuredData& data) {
  const EqualRows equal = equal_rows(data);
  std::vector<std::size_t> repeated = equal.copies;
  repeated.insert(repeated.end(), equal.copies_across.begin(), equal.copies_across.end());
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

std::vector<DataNote> data_notes(const MeasuredData& data,
                                 const std::vector<CsvComment>& comments_below_the_header) {
  std::vector<DataNote> notes;
  if (auto series = recognise_series(data)) notes.push_back(std::move(*series));
  for (DataNote& note : notes_on_equal_rows(data)) notes.push_back(std::move(note));
  add_motor_side(data, notes);
  add_units(data, notes);
  for (DataNote& note : notes_on_directions(data)) notes.push_back(std::move(note));
  for (DataNote& note : notes_below_zero(data)) notes.push_back(std::move(note));
  if (auto inverted = note_inverted(data)) notes.push_back(std::move(*inverted));
  add_covariates(data, notes);
  if (!comments_below_the_header.empty()) {
    DataNote note{NoteKind::comment,
                  "lines below the header begin with # and are taken as comments, not as readings",
                  {}};
    for (const CsvComment& comment : comments_below_the_header) note.lines.push_back(comment.line);
    notes.push_back(std::move(note));
  }
  return notes;
}

}  // namespace reeve::readings
