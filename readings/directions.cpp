#include "readings/directions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/motor_sides.hpp"
#include "numerics/robust.hpp"
#include "readings/units.hpp"

namespace reeve::readings {
namespace {

// A pulled row, its tensions at the strands.
struct PulledRow {
  std::size_t line = 0;
  bool assumed = false;  // true if nothing says that it was pulled
  double motor_N = 0;
  std::vector<std::optional<double>> strands_N;  // [channel]; nothing for other segments
  std::optional<double> beside_sheaths_N;        // Σ, if all are measured
};

std::optional<double> sum_beside_sheaths(const MeasuredData& data, const Reading& reading) {
  const MeasuredRouting& routing = data.routings[reading.routing];
  double sum_N = 0;
  for (const MotorSide& side : motor_sides(routing.network)) {
    const auto channel =
        std::find(routing.segments.begin(), routing.segments.end(), std::optional(side.hand));
    if (channel == routing.segments.end()) return std::nullopt;
    const auto& tension =
        reading.tension_N[static_cast<std::size_t>(channel - routing.segments.begin())];
    if (!tension) return std::nullopt;
    sum_N += *tension;
  }
  return sum_N;
}

std::vector<PulledRow> pulled_rows(const MeasuredData& data) {
  std::vector<PulledRow> rows;
  for (const Reading& reading : data.readings) {
    const bool has_blocks = !data.routings[reading.routing].network.blocks.empty();
    if (reading.direction != Direction::pull || has_blocks ||
        !(reading.motor_tension_N.value_or(0) > 0)) {
      continue;
    }
    PulledRow row{reading.line, reading.direction_assumed, *reading.motor_tension_N,
                  reading.tension_N, sum_beside_sheaths(data, reading)};
    bool has_strand = false;
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      if (data.channels[c].segment.kind != SegmentKind::strand) row.strands_N[c].reset();
      has_strand |= row.strands_N[c].has_value();
    }
    if (has_strand) rows.push_back(std::move(row));
  }
  return rows;
}

double greatest(const PulledRow& row) {
  double result = 0;
  for (const auto& tension_N : row.strands_N) result = std::max(result, tension_N.value_or(0));
  return result;
}

bool breaks_pull(const PulledRow& row) {
  return greatest(row) > (1 + direction_tolerance) * row.motor_N;
}

double share(const std::vector<PulledRow>& rows, const std::function<bool(const PulledRow&)>& is) {
  return static_cast<double>(std::count_if(rows.begin(), rows.end(), is)) /
         static_cast<double>(rows.size());
}

bool mended(const std::vector<PulledRow>& rows, const std::function<bool(const PulledRow&)>& is) {
  return share(rows, is) <= most_broken_if_mended;
}

bool breaks_release(const PulledRow& row) {
  return row.beside_sheaths_N.value_or(row.motor_N) < (1 - direction_tolerance) * row.motor_N;
}

// A cycle without recorded turning points of the carriage.
bool broken_may_be_released(const std::vector<PulledRow>& rows) {
  std::vector<PulledRow> broken = rows;
  std::erase_if(broken, std::not_fn(breaks_pull));
  return mended(broken, breaks_release) &&
         std::all_of(broken.begin(), broken.end(),
                     [](const PulledRow& row) { return row.assumed; });
}

bool breaks_exchanged(PulledRow row, std::size_t channel) {
  if (row.strands_N[channel]) std::swap(*row.strands_N[channel], row.motor_N);
  return breaks_pull(row);
}

// A unit so large that it mends anything is no explanation: some strand gets a fifth of the motor.
bool unit_mends(const std::vector<PulledRow>& rows, double factor) {
  constexpr double least_share = 0.2;
  std::vector<double> ratios;
  for (const PulledRow& row : rows) ratios.push_back(greatest(row) / (factor * row.motor_N));
  return median(std::move(ratios)) >= least_share && mended(rows, [&](PulledRow row) {
           row.motor_N *= factor;
           return breaks_pull(row);
         });
}

std::vector<std::string> remedies(const MeasuredData& data, const std::vector<PulledRow>& rows) {
  std::vector<std::string> result;
  if (mended(rows, breaks_release)) {
    result.emplace_back("direction = release");
  } else if (broken_may_be_released(rows)) {
    result.emplace_back("direction = release in these rows");
  }
  for (std::size_t c = 0; c < data.channels.size(); ++c) {
    if (mended(rows, [&](const PulledRow& row) { return breaks_exchanged(row, c); })) {
      result.push_back(fmt::format("motor_tension_N and {}_N exchanged", data.channels[c].name));
    }
  }
  for (const char* unit : {"daN", "kN", "kgf", "lbf"}) {
    if (unit_mends(rows, find_unit(unit, Dimension::force)->factor)) {
      result.push_back(fmt::format("motor_tension_N in {}", unit));
    }
  }
  return result;
}

}  // namespace

void note_directions(MeasuredData& data) {
  const auto assumed = std::count_if(data.readings.begin(), data.readings.end(),
                                     [](const Reading& r) { return r.direction_assumed; });
  if (assumed > 0) {
    data.notes.push_back(
        {NoteKind::assumed,
         fmt::format("the direction is not given in {} of {} rows: pull is assumed", assumed,
                     data.readings.size())});
  }
  const std::vector<PulledRow> rows = pulled_rows(data);
  if (rows.empty() || share(rows, breaks_pull) <= most_broken_rows) return;
  DataNote note{NoteKind::not_as_pulled, ""};
  for (const PulledRow& row : rows) {
    if (breaks_pull(row)) note.lines.push_back(row.line);
  }
  note.text = fmt::format(
      "in {} of {} pulled rows a strand reads over {:.0f} % more than motor_tension_N, which no "
      "friction does while the carriage pulls. ",
      note.lines.size(), rows.size(), 100 * direction_tolerance);
  const std::vector<std::string> mending = remedies(data, rows);
  note.text += mending.empty() ? "Neither the other direction nor another column or unit of the "
                                 "motor tension mends that"
                               : fmt::format("This would mend it: {}", fmt::join(mending, "; or "));
  data.notes.push_back(std::move(note));
}

}  // namespace reeve::readings
