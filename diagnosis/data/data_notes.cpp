#include "diagnosis/data/data_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "diagnosis/series/recognise_series.hpp"

namespace reeve::diagnosis {
namespace {

// All that two rows can share but the line and the run.
auto values(const Reading& reading) {
  return std::tie(reading.routing, reading.grasp.held, reading.direction, reading.motor_tension_N,
                  reading.speed_mm_s, reading.cycle, reading.temperature_C,
                  reading.sheath_angle_rad, reading.tension_N, reading.covariates);
}

// Readings in an order in which equal ones stand together, the earliest first.
std::vector<std::size_t> equal_together(const MeasuredData& data) {
  const std::vector<Reading>& readings = data.readings;
  std::vector<std::size_t> order(readings.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const auto key = [&](std::size_t i) {
      return std::tuple_cat(values(readings[i]), std::tie(readings[i].line));
    };
    return key(a) < key(b);
  });
  return order;
}

// Each repeated row is in one note: of its own run if that has had the row before.
void add_duplicates(const MeasuredData& data, std::vector<DataNote>& notes) {
  const std::vector<Reading>& readings = data.readings;
  const std::vector<std::size_t> order = equal_together(data);
  DataNote same{NoteKind::duplicate, "", {}};
  DataNote across{NoteKind::duplicate_across_runs, "", {}};
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const Reading& first = readings[order[begin]];
    std::set<std::size_t> runs{first.run};
    for (end = begin + 1; end < order.size() && values(readings[order[end]]) == values(first);
         ++end) {
      const Reading& repeated = readings[order[end]];
      (runs.insert(repeated.run).second ? across : same).lines.push_back(repeated.line);
    }
  }
  const auto add = [&](DataNote note, const char* text) {
    if (note.lines.empty()) return;
    std::sort(note.lines.begin(), note.lines.end());
    note.text = fmt::format("{} {} {}", note.lines.size(),
                            note.lines.size() == 1 ? "row repeats" : "rows repeat", text);
    notes.push_back(std::move(note));
  };
  add(std::move(same),
      "an earlier row of the same run in every value. They are counted; if a reading was copied, "
      "delete its copies");
  add(std::move(across),
      "an earlier row of another run in every value. They are counted; if readings were copied, "
      "delete the copies: runs that share readings cannot test each other");
}

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

// 0 if there are none.
double upper_median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void add_units(const std::string& what, double median, double low, double high,
               const std::string& unit, std::vector<DataNote>& notes) {
  if (median == 0 || (median >= low && median <= high)) return;
  notes.push_back(
      {NoteKind::units,
       fmt::format("the median of {} is {:.3g}{}, and from {} to {} is plausible: is it "
                   "in another unit than newton?",
                   what, median, unit, low, high),
       {}});
}

// Zeros are left out: a slack strand says nothing about units.
void add_units(const MeasuredData& data, std::vector<DataNote>& notes) {
  const auto add_tension = [&](const std::string& what, const std::vector<double>& tensions) {
    add_units(what, upper_median(tensions), least_plausible_tension_N, greatest_plausible_tension_N,
              " N", notes);
  };
  std::vector<double> motor;
  for (const Reading& reading : data.readings) {
    if (reading.motor_tension_N.value_or(0) > 0) motor.push_back(*reading.motor_tension_N);
  }
  add_tension("motor_tension_N", motor);
  for (std::size_t i = 0; i < data.channels.size(); ++i) {
    const std::string column = (data.channels[i].segment.kind == SegmentKind::strand ? "" : "T") +
                               data.channels[i].name + "_N";
    std::vector<double> tensions, ratios;
    for (const Reading& reading : data.readings) {
      const double tension = reading.tension_N[i].value_or(0);
      if (tension > 0) tensions.push_back(tension);
      if (tension > 0 && reading.motor_tension_N.value_or(0) > 0) {
        ratios.push_back(tension / *reading.motor_tension_N);
      }
    }
    add_tension(column, tensions);
    add_units(column + " over motor_tension_N", upper_median(ratios), least_plausible_ratio,
              greatest_plausible_ratio, "", notes);
  }
}

}  // namespace

std::vector<std::size_t> repeated_readings(const MeasuredData& data) {
  const std::vector<std::size_t> order = equal_together(data);
  std::vector<std::size_t> repeated;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (values(data.readings[order[i]]) == values(data.readings[order[i - 1]])) {
      repeated.push_back(order[i]);
    }
  }
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

std::vector<DataNote> data_notes(const MeasuredData& data,
                                 const std::vector<CsvComment>& comments_below_the_header) {
  std::vector<DataNote> notes;
  if (auto series = recognise_series(data)) notes.push_back(std::move(*series));
  add_duplicates(data, notes);
  add_motor_side(data, notes);
  add_units(data, notes);
  for (const std::string& covariate : data.covariates) {
    notes.push_back(
        {NoteKind::covariate,
         fmt::format("column '{}' is read as a covariate, which the model does not know",
                     for_message(covariate)),
         {}});
  }
  if (!comments_below_the_header.empty()) {
    DataNote note{NoteKind::comment,
                  "lines below the header begin with # and are taken as comments, not as readings",
                  {}};
    for (const CsvComment& comment : comments_below_the_header) note.lines.push_back(comment.line);
    notes.push_back(std::move(note));
  }
  return notes;
}

}  // namespace reeve::diagnosis
