#include "diagnosis/whole_columns.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "readings/filled_columns.hpp"

namespace reeve::diagnosis {

WholeColumns whole_columns(const MeasuredData& data) {
  constexpr double most_left_out = 1.0 / 3;
  WholeColumns result{data, {}};
  std::vector<Reading>& readings = result.data.readings;
  std::set<std::size_t> incomplete;
  for (const readings::ConditionColumn& column : readings::condition_columns(data)) {
    std::vector<std::size_t> empty, lines;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      if (column.cell(readings[i])) continue;
      empty.push_back(i);
      lines.push_back(readings[i].line);
    }
    if (empty.empty() || empty.size() == readings.size()) continue;
    const bool is_out =
        static_cast<double>(empty.size()) > most_left_out * static_cast<double>(readings.size());
    if (is_out) {
      for (Reading& reading : readings) column.cell(reading).reset();
    } else {
      incomplete.insert(empty.begin(), empty.end());
    }
    result.data.notes.push_back(
        {NoteKind::not_compared,
         fmt::format("column '{}' is empty in {} of {} rows: {}", column.name, empty.size(),
                     readings.size(),
                     is_out ? "it is not looked at" : "they are left out of the diagnosis"),
         is_out ? std::vector<std::size_t>() : std::move(lines)});
  }
  result.incomplete.assign(incomplete.begin(), incomplete.end());
  return result;
}

}  // namespace reeve::diagnosis
