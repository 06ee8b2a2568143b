#include "readings/data_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/motor_sides.hpp"
#include "numerics/robust.hpp"
#include "readings/column_name.hpp"
#include "readings/copies.hpp"
#include "readings/directions.hpp"
#include "readings/inverted.hpp"
#include "readings/recognise_series.hpp"
#include "readings/row_order.hpp"
#include "readings/rows.hpp"

namespace reeve::readings {
namespace {

bool is_measured(const MeasuredData& data, std::size_t routing, std::size_t channel) {
  return std::any_of(data.readings.begin(), data.readings.end(), [&](const Reading& reading) {
    return reading.routing == routing && reading.tension_N[channel];
  });
}

// "a is beside T4", of the letters that are measured.
std::string key_of(const MeasuredData& data, std::size_t index) {
  const MeasuredRouting& routing = data.routings[index];
  std::string key;
  for (const MotorSide& side : motor_sides(routing.network)) {
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      if (routing.segments[c] != side.motor_side || !is_measured(data, index, c)) continue;
      key += fmt::format("{}{} is beside {}", key.empty() ? "" : ", ", data.channels[c].name,
                         segment_name(routing.network.segments[side.hand]));
    }
  }
  return key;
}

void note_motor_side(MeasuredData& data) {
  auto lines = lines_where(data, [&](const Reading& reading) {
    if (!reading.motor_tension_N) return false;
    const double most_N = (1 + motor_side_tolerance) * *reading.motor_tension_N;
    for (std::size_t i = 0; i < data.channels.size(); ++i) {
      const bool is_motor_side = data.channels[i].segment.kind == SegmentKind::motor_side;
      if (is_motor_side && reading.tension_N[i].value_or(0) > most_N) return true;
    }
    return false;
  });
  if (lines.empty()) return;
  data.notes.push_back(
      {NoteKind::motor_side_above_motor,
       fmt::format("a motor-side segment carries over {:.0f} % more than motor_tension_N, which is "
                   "the sum of all of them: check the units and the zeros of the sensors",
                   100 * motor_side_tolerance),
       std::move(lines)});
}

void note_unit(const std::string& what, double median, double low, double high,
               const std::string& unit, std::vector<DataNote>& notes) {
  if (std::isnan(median) || (median >= low && median <= high)) return;
  notes.push_back(
      {NoteKind::units,
       fmt::format("the median of {} is {:.3g}{}, and from {} to {} is plausible: is it "
                   "in another unit than newton?",
                   what, median, unit, low, high)});
}

// A third below zero: what is above it is noise about nothing, too, and has no unit.
bool reads_nothing(std::size_t above_zero, std::size_t below_zero) {
  return below_zero > 0 && 2 * below_zero >= above_zero;
}

// Zeros are left out: a slack strand says nothing about units.
void note_units(MeasuredData& data) {
  const auto note_tension = [&](const std::string& what, const std::vector<double>& tensions) {
    note_unit(what, median(tensions), least_plausible_tension_N, greatest_plausible_tension_N, " N",
              data.notes);
  };
  std::vector<double> motor;
  for (const Reading& reading : data.readings) {
    if (reading.motor_tension_N.value_or(0) > 0) motor.push_back(*reading.motor_tension_N);
  }
  note_tension("motor_tension_N", motor);
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
    note_tension(column, tensions);
    note_unit(column + " over motor_tension_N", median(ratios), least_plausible_ratio,
              greatest_plausible_ratio, "", data.notes);
  }
}

void note_below_zero(MeasuredData& data) {
  std::string counts;
  for (std::size_t c = 0; c < data.channels.size(); ++c) {
    std::size_t below = 0;
    std::size_t given = 0;
    for (const Reading& reading : data.readings) {
      given += reading.tension_N[c] ? 1 : 0;
      below += reading.tension_N[c].value_or(0) < 0 ? 1 : 0;
    }
    if (below == 0) continue;
    counts += fmt::format("{}{} of {} of {}", counts.empty() ? "" : ", ", below, given,
                          data.channels[c].name);
  }
  if (counts.empty()) return;
  auto lines = lines_where(data, [](const Reading& reading) {
    return std::any_of(reading.tension_N.begin(), reading.tension_N.end(),
                       [](const auto& tension) { return tension.value_or(0) < 0; });
  });
  std::sort(lines.begin(), lines.end());
  data.notes.push_back(
      {NoteKind::below_zero,
       "readings below zero (" + counts +
           ") are used as they are: a zero that drifts gives them. A tare row takes it off",
       std::move(lines)});
}

// An empty cell beside others that name fingers says that none is held.
void note_grasps(MeasuredData& data) {
  const auto assumed = std::ranges::count_if(data.readings, &Reading::grasp_assumed);
  const bool some_are_said = std::ranges::any_of(data.readings, [&](const Reading& reading) {
    return !reading.grasp_assumed && data.routings[reading.routing].network.fingers > 1;
  });
  if (assumed == 0 || some_are_said) return;
  data.notes.push_back({NoteKind::assumed, held_is_assumed(static_cast<std::size_t>(assumed),
                                                           data.readings.size(), "rows")});
}

// The clock gives rows their order, and is no news to whoever logged it.
void note_covariates(MeasuredData& data) {
  const std::optional<std::size_t> clock = clock_of(data);
  for (std::size_t c = 0; c < data.covariates.size(); ++c) {
    if (c == clock) continue;
    data.notes.push_back(
        {NoteKind::covariate,
         fmt::format("column '{}' is read as a covariate, which the model does not know",
                     for_message(data.covariates[c]))});
  }
}

void note_comments(const std::vector<CsvComment>& comments, MeasuredData& data) {
  if (comments.empty()) return;
  DataNote note{NoteKind::comment,
                "lines below the header begin with # and are taken as comments, not as readings"};
  for (const CsvComment& comment : comments) note.lines.push_back(comment.line);
  data.notes.push_back(std::move(note));
}

}  // namespace

void note_letters(MeasuredData& data) {
  for (std::size_t i = 0; i < data.routings.size(); ++i) {
    const MeasuredRouting& routing = data.routings[i];
    if (letters_match_strands(routing.network)) continue;
    const std::string key = key_of(data, i);
    if (key.empty()) continue;
    data.notes.push_back(
        {NoteKind::letters,
         fmt::format("letters run in walk order: in {} {}. Where a, b, c, d were meant beside T1, "
                     "T2, T3, T4, name the columns at_T1_N and so on",
                     routing.word, key)});
  }
}

void leave_out_negative_motor_tensions(MeasuredData& data) {
  const auto is_negative = [](const Reading& reading) {
    return reading.motor_tension_N.value_or(0) < 0;
  };
  auto lines = lines_where(data, is_negative);
  if (lines.empty()) return;
  std::erase_if(data.readings, is_negative);
  if (data.readings.empty()) {
    throw InputError({.where = data.file,
                      .what = "motor_tension_N is below zero in every row",
                      .expected = "motor tensions from 0: exchange the sign of that column"});
  }
  data.notes.push_back(
      {NoteKind::not_compared,
       "motor_tension_N is below zero, which is no scale for the model's tensions: these rows are "
       "left out. If the sensor's zero has drifted, a tare row takes it off",
       std::move(lines)});
}

void note_what_looks_wrong(MeasuredData& data,
                           const std::vector<CsvComment>& comments_below_the_header) {
  if (auto series = recognise_series(data)) data.notes.push_back(std::move(*series));
  note_equal_rows(data);
  note_motor_side(data);
  note_units(data);
  note_directions(data);
  note_grasps(data);
  note_below_zero(data);
  if (auto inverted = inverted_channels(data)) data.notes.push_back(std::move(*inverted));
  note_covariates(data);
  note_comments(comments_below_the_header, data);
}

}  // namespace reeve::readings
