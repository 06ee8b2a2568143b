#include "readings/runs_of_groups.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

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
