#include "diagnosis/filled_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "numerics/robust.hpp"

namespace reeve::diagnosis {
namespace {

constexpr double slowly = 0.1;
constexpr double most_left_out = 1.0 / 3;

using CellOf = std::function<std::optional<double>&(Reading&)>;

struct Column {
  std::string name;
  CellOf cell;
};

std::vector<Column> columns(const MeasuredData& data) {
  std::vector<Column> result{{"speed_mm_s", [](Reading & r) -> auto& {return r.speed_mm_s;
}
}  // namespace
, {"cycle", [](Reading& r) -> auto& {return r.cycle;
}  // namespace reeve::diagnosis
}
, {
  "temperature_C", [](Reading & r) -> auto& { return r.temperature_C; }
}
}
;
for (std::size_t c = 0; c < data.covariates.size(); ++c) {
    result.push_back({data.covariates[c], [c](Reading& r) -> auto& { return r.covariates[c];
}
});
}
return result;
}

// The readings of each run, as they were taken.
std::vector<std::vector<Reading*>> runs_as_taken(MeasuredData& data) {
  std::vector<std::vector<Reading*>> runs(data.runs.size());
  for (Reading& reading : data.readings) runs[reading.run].push_back(&reading);
  for (auto& run : runs) {
    std::ranges::sort(run, {}, [](const Reading* reading) { return reading->taken; });
  }
  return runs;
}

// Places in a run whose cells are recorded.
std::vector<std::size_t> recorded_places(const std::vector<Reading*>& run, const CellOf& cell) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < run.size(); ++k) {
    if (cell(*run[k])) places.push_back(k);
  }
  return places;
}

double on_line(const std::vector<Reading*>& run, const CellOf& cell, std::size_t from,
               std::size_t to, std::size_t at) {
  const double share = static_cast<double>(at - from) / static_cast<double>(to - from);
  return std::lerp(*cell(*run[from]), *cell(*run[to]), share);
}

bool changes_slowly(const std::vector<std::vector<Reading*>>& runs, const CellOf& cell) {
  std::vector<double> values, off;
  for (const std::vector<Reading*>& run : runs) {
    const std::vector<std::size_t> recorded = recorded_places(run, cell);
    for (std::size_t i = 0; i < recorded.size(); ++i) {
      values.push_back(*cell(*run[recorded[i]]));
      if (i == 0 || i + 1 == recorded.size()) continue;
      off.push_back(std::abs(values.back() -
                             on_line(run, cell, recorded[i - 1], recorded[i + 1], recorded[i])));
    }
  }
  if (off.empty()) return false;
  const double middle = median(values);
  for (double& value : values) value = std::abs(value - middle);
  return median(std::move(off)) <= slowly * median(std::move(values));
}

void fill(const std::vector<Reading*>& run, const CellOf& cell) {
  const std::vector<std::size_t> recorded = recorded_places(run, cell);
  if (recorded.empty()) return;
  for (std::size_t k = 0; k < run.size(); ++k) {
    std::optional<double>& own = cell(*run[k]);
    if (own) continue;
    const auto behind = std::ranges::lower_bound(recorded, k);
    if (behind == recorded.begin()) {
      own = cell(*run[recorded.front()]);
    } else if (behind == recorded.end()) {
      own = cell(*run[recorded.back()]);
    } else {
      own = on_line(run, cell, *(behind - 1), *behind, k);
    }
  }
}

}  // namespace

FilledColumns filled_columns(const MeasuredData& data) {
  FilledColumns result{data, {}};
  std::set<std::size_t> incomplete;
  std::vector<Reading>& readings = result.data.readings;
  const std::vector<std::vector<Reading*>> runs = runs_as_taken(result.data);
  for (const auto& [name, cell] : columns(data)) {
    const auto is_empty = [&](Reading& reading) { return !cell(reading); };
    const auto empty = [&] {
      return static_cast<std::size_t>(std::ranges::count_if(readings, is_empty));
    };
    const std::size_t before = empty();
    if (before == 0 || before == readings.size()) continue;
    if (changes_slowly(runs, cell)) {
      for (const std::vector<Reading*>& run : runs) fill(run, cell);
    }
    const std::size_t left = empty();
    std::string what;
    std::vector<std::size_t> lines;
    if (left < before) {
      what = fmt::format(", {} of which are filled from those beside them in their runs",
                         before - left);
    }
    const bool is_out =
        static_cast<double>(left) > most_left_out * static_cast<double>(readings.size());
    if (is_out) {
      what += ": it is not looked at";
      for (Reading& reading : readings) cell(reading).reset();
    } else if (left > 0) {
      what +=
          fmt::format(": {} are left out of the diagnosis", left < before ? "the others" : "they");
      for (std::size_t i = 0; i < readings.size(); ++i) {
        if (cell(readings[i])) continue;
        incomplete.insert(i);
        lines.push_back(readings[i].line);
      }
    }
    result.data.notes.push_back({left == 0 ? NoteKind::assumed : NoteKind::not_compared,
                                 fmt::format("column '{}' is empty in {} of {} rows{}", name,
                                             before, readings.size(), what),
                                 std::move(lines)});
  }
  result.incomplete.assign(incomplete.begin(), incomplete.end());
  return result;
}

}  // namespace reeve::diagnosis
