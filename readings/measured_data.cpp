#include "readings/measured_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "readings/data_columns.hpp"
#include "readings/data_notes.hpp"
#include "readings/filled_columns.hpp"
#include "readings/outliers.hpp"
#include "readings/row_order.hpp"
#include "readings/row_reader.hpp"
#include "readings/silent_runs.hpp"
#include "readings/stuck_channels.hpp"

namespace reeve::readings {
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

// A run is one mounting of one rig: rows of one run name that lie in several groups, as when the
// files of two rigs are put together, are so many runs. Their names get the group's behind them:
// "1 (left)". Rows without a group are one of their own where there are two groups or more; beside
// one group they belong to it.
void part_runs_by_group(MeasuredData& data) {
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
  if (parted == 0) return;
  for (Reading& reading : data.readings) {
    const bool parts = groups[reading.run].size() > 1;
    const Group group = parts ? reading.group : *groups[reading.run].begin();
    reading.run = places.at({reading.run, group});
  }
  data.runs = std::move(runs);
  data.notes.push_back(
      {NoteKind::runs_of_groups,
       fmt::format("{} run name{} in several groups, '{}'{}: the rows of each group are a run of "
                   "their own",
                   parted, parted == 1 ? " is" : "s are", first, parted == 1 ? "" : " first")});
}

void note_groups(MeasuredData& data) {
  if (data.groups.size() < 2) {
    data.notes.push_back({NoteKind::not_compared,
                          data.groups.empty()
                              ? std::string("the column of groups is empty")
                              : fmt::format("all rows are of one group, '{}': there is no other to "
                                            "compare it with",
                                            data.groups.front())});
    return;
  }
  auto lines = lines_where(data, [](const Reading& reading) { return !reading.group; });
  if (lines.empty()) return;
  std::string text = fmt::format("{} row{} no group, and no part in comparisons between groups",
                                 lines.size(), lines.size() == 1 ? " has" : "s have");
  data.notes.push_back({NoteKind::not_compared, std::move(text), std::move(lines)});
}

// [channel]: true if it has such a reading.
std::vector<bool> channels_with(const MeasuredData& data, bool (*is)(double tension_N)) {
  std::vector<bool> result(data.channels.size(), false);
  for (const Reading& reading : data.readings) {
    for (std::size_t c = 0; c < result.size(); ++c) {
      if (reading.tension_N[c] && is(*reading.tension_N[c])) result[c] = true;
    }
  }
  return result;
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
  MeasuredData data = read_rows(csv, beginning, columns.columns, resolve, options, faults);
  faults.throw_any(csv.name());
  require_rows(csv, data.readings.size(), data.notes);
  std::move(columns.notes.begin(), columns.notes.end(), std::back_inserter(data.notes));
  leave_out_stuck_channels(data);
  leave_out_silent_runs(data);
  part_runs_by_group(data);
  if (options.group) note_groups(data);
  std::vector<CsvComment> below_the_header;
  for (const CsvComment& comment : csv.comments()) {
    data.simulated |= says_simulated(comment.text);
    if (comment.line > csv.header().line) below_the_header.push_back(comment);
  }
  // Reeve itself writes its own letters.
  if (!data.simulated && has_letters(columns.columns)) note_letters(data);
  leave_out_negative_motor_tensions(data);
  set_outliers_aside(data);
  set_taken(data);
  fill_columns(data);
  note_what_looks_wrong(data, below_the_header);
  return data;
}

}  // namespace

std::vector<bool> reads_below_zero(const MeasuredData& data) {
  return channels_with(data, [](double tension_N) { return tension_N < 0; });
}

std::vector<bool> reads_zero_alone(const MeasuredData& data) {
  auto others = channels_with(data, [](double tension_N) { return tension_N != 0; });
  others.flip();
  return others;
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

}  // namespace reeve::readings
