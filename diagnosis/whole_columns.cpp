#include "diagnosis/whole_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "readings/filled_columns.hpp"

namespace reeve::diagnosis {

namespace {

struct EmptyCells {
  readings::ConditionColumn column;
  std::vector<std::size_t> readings;
};

// The fullest first.
std::vector<EmptyCells> empty_cells(MeasuredData& data) {
  std::vector<EmptyCells> result;
  for (readings::ConditionColumn& column : readings::condition_columns(data)) {
    EmptyCells empty{std::move(column), {}};
    for (std::size_t i = 0; i < data.readings.size(); ++i) {
      if (!empty.column.cell(data.readings[i])) empty.readings.push_back(i);
    }
    const bool is_used = empty.readings.size() < data.readings.size();
    if (is_used && !empty.readings.empty()) result.push_back(std::move(empty));
  }
  std::ranges::stable_sort(result, {},
                           [](const EmptyCells& empty) { return empty.readings.size(); });
  return result;
}

}  // namespace

WholeColumns whole_columns(const MeasuredData& data) {
  constexpr double most_left_out = 1.0 / 3;
  WholeColumns result{data, {}};
  std::vector<Reading>& readings = result.data.readings;
  std::set<std::size_t> incomplete;
  for (const auto& [column, empty] : empty_cells(result.data)) {
    std::set<std::size_t> with_these = incomplete;
    with_these.insert(empty.begin(), empty.end());
    const bool is_out = static_cast<double>(with_these.size()) >
                        most_left_out * static_cast<double>(readings.size());
    std::vector<std::size_t> lines;
    if (is_out) {
      for (Reading& reading : readings) column.cell(reading).reset();
    } else {
      for (const std::size_t i : empty) lines.push_back(readings[i].line);
      incomplete = std::move(with_these);
    }
    result.data.notes.push_back(
        {NoteKind::not_compared,
         fmt::format("column '{}' is empty in {} of {} rows: {}", column.name, empty.size(),
                     readings.size(),
                     is_out ? "it is not looked at" : "they are left out of the diagnosis"),
         std::move(lines)});
  }
  result.incomplete.assign(incomplete.begin(), incomplete.end());
  return result;
}

}  // namespace reeve::diagnosis
