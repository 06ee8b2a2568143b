#include "readings/measured_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "readings/columns.hpp"
#include "readings/csv.hpp"
#include "readings/data_notes.hpp"
#include "readings/fault_list.hpp"
#include "readings/outliers.hpp"
#include "readings/row_order.hpp"
#include "readings/row_reader.hpp"
#include "readings/rows.hpp"

namespace reeve::readings {

namespace {

void add_notes(std::vector<DataNote> more, MeasuredData& data) {
  std::move(more.begin(), more.end(), std::back_inserter(data.notes));
}

void leave_out_what_scales_nothing(MeasuredData& data) {
  add_notes(leave_out_negative_motor_tensions(data), data);
  if (!data.readings.empty()) return;
  throw InputError({.where = data.file,
                    .what = "motor_tension_N is below zero in every row",
                    .expected = "motor tensions from 0"});
}

void mark_simulated(const CsvReader& csv, MeasuredData& data) {
  for (const CsvComment& comment : csv.comments()) {
    data.simulated |= says_simulated(comment.text);
  }
}

void add_comments(const CsvReader& csv, MeasuredData& data) {
  std::vector<CsvComment> below;
  for (const CsvComment& comment : csv.comments()) {
    if (comment.line > csv.header().line) below.push_back(comment);
  }
  add_notes(data_notes(data, below), data);
}

bool has_letters(const std::vector<DataColumn>& columns) {
  return std::any_of(columns.begin(), columns.end(), [](const DataColumn& column) {
    return column.role == DataRole::tension && !column.place.beside &&
           column.place.segment.kind == SegmentKind::motor_side;
  });
}

MeasuredData read(CsvReader csv, const RoutingResolver& resolve, const ReadingOptions& options) {
  FaultList faults;
  const Beginning beginning = read_beginning(csv, options, faults);
  DataColumns columns = read_columns(csv, beginning.units, options, faults);
  RowReader rows(csv, columns.columns, resolve, options, faults);
  each_row(csv, beginning, faults, [&](const CsvRow& row) { rows.read(row); });
  MeasuredData data = rows.finish();
  faults.throw_any(csv.name());
  require_rows(csv, data.readings.size(), data.notes);
  add_notes(std::move(columns.notes), data);
  add_notes(part_runs_by_group(data), data);
  if (options.group) add_notes(notes_on_groups(data), data);
  mark_simulated(csv, data);
  // Reeve itself writes its own letters.
  add_notes(notes_on_letters(data, !data.simulated && has_letters(columns.columns)), data);
  leave_out_what_scales_nothing(data);
  add_notes(set_outliers_aside(data), data);
  set_taken(data);
  add_comments(csv, data);
  return data;
}

}  // namespace

std::vector<bool> reads_below_zero(const MeasuredData& data) {
  std::vector<bool> result(data.channels.size(), false);
  for (const Reading& reading : data.readings) {
    for (std::size_t c = 0; c < result.size(); ++c) {
      if (reading.tension_N[c].value_or(0) < 0) result[c] = true;
    }
  }
  return result;
}

std::vector<bool> reads_zero_alone(const MeasuredData& data) {
  std::vector<bool> result(data.channels.size(), true);
  for (const Reading& reading : data.readings) {
    for (std::size_t c = 0; c < result.size(); ++c) {
      if (reading.tension_N[c].value_or(0) != 0) result[c] = false;
    }
  }
  return result;
}

std::optional<KnownNoise> known_noise(const MeasuredData& data, std::size_t channel) {
  return channel < data.known_noise.size() ? data.known_noise[channel] : std::nullopt;
}

double motor_deviation(const MeasuredData& data, const Reading& reading) {
  const double tension_N = reading.motor_tension_N.value_or(0);
  const double known = data.known_motor_noise ? data.known_motor_noise->deviation(tension_N) : 0;
  return std::max(known, reading.motor_error_N.value_or(0));
}

MeasuredData read_measured_data(const std::filesystem::path& path, const RoutingResolver& resolve,
                                const ReadingOptions& options) {
  return read(CsvReader::open(path), resolve, options);
}

MeasuredData parse_measured_data(std::string text, const std::string& name,
                                 const RoutingResolver& resolve, const ReadingOptions& options) {
  return read(CsvReader(std::move(text), name), resolve, options);
}

namespace {

using Group = std::optional<std::size_t>;

std::vector<std::set<Group>> groups_of_runs(const MeasuredData& data) {
  std::vector<std::set<Group>> groups(data.runs.size());
  for (const Reading& reading : data.readings) groups[reading.run].insert(reading.group);
  // A cell that was left empty makes no other rig.
  for (std::set<Group>& of_run : groups) {
    if (of_run.size() == 2 && of_run.contains(std::nullopt)) of_run = {Group{}};
  }
  return groups;
}

std::string parted_name(const MeasuredData& data, std::size_t run, Group group) {
  return fmt::format("{} ({})", data.runs[run], group ? data.groups[*group] : "no group");
}

}  // namespace

std::vector<DataNote> notes_on_groups(const MeasuredData& data) {
  std::vector<DataNote> notes;
  if (data.groups.size() < 2) {
    notes.push_back({NoteKind::not_compared,
                     data.groups.empty() ? std::string("the column of groups is empty")
                                         : fmt::format("all rows are of one group, '{}': there is "
                                                       "no other to compare it with",
                                                       data.groups.front()),
                     {}});
    return notes;
  }
  DataNote without{NoteKind::not_compared, "", {}};
  for (const Reading& reading : data.readings) {
    if (!reading.group) without.lines.push_back(reading.line);
  }
  if (without.lines.empty()) return notes;
  without.text = fmt::format("{} row{} no group, and no part in comparisons between groups",
                             without.lines.size(), without.lines.size() == 1 ? " has" : "s have");
  notes.push_back(std::move(without));
  return notes;
}

std::vector<DataNote> part_runs_by_group(MeasuredData& data) {
  const std::vector<std::set<Group>> groups = groups_of_runs(data);
  std::vector<std::string> runs;
  std::map<std::pair<std::size_t, Group>, std::size_t> places;
  std::size_t parted = 0;
  std::string first;
  for (std::size_t run = 0; run < groups.size(); ++run) {
    for (const Group group : groups[run]) {
      places[{run, group}] = runs.size();
      runs.push_back(groups[run].size() == 1 ? data.runs[run] : parted_name(data, run, group));
    }
    if (groups[run].size() < 2) continue;
    if (parted++ == 0) first = data.runs[run];
  }
  if (parted == 0) return {};
  for (Reading& reading : data.readings) {
    const bool parts = groups[reading.run].size() > 1;
    const Group group = parts ? reading.group : *groups[reading.run].begin();
    reading.run = places.at({reading.run, group});
  }
  data.runs = std::move(runs);
  return {
      {NoteKind::runs_of_groups,
       fmt::format("{} run name{} in several groups{}: the rows of each group are a run of their "
                   "own",
                   parted, parted == 1 ? " is" : "s are",
                   parted == 1 ? fmt::format(", '{}'", first) : fmt::format(", '{}' first", first)),
       {}}};
}

}  // namespace reeve::readings
