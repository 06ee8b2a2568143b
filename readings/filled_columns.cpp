#include "readings/filled_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "numerics/robust.hpp"

namespace reeve::readings {
namespace {

constexpr double well_met = 0.4;

// The cells of a column in a run, as they were taken.
using RunCells = std::vector<std::optional<double>*>;

std::vector<RunCells> cells_by_run(MeasuredData& data, const ConditionColumn& column) {
  std::vector<std::vector<Reading*>> runs(data.runs.size());
  for (Reading& reading : data.readings) runs[reading.run].push_back(&reading);
  std::vector<RunCells> result;
  for (auto& run : runs) {
    std::ranges::sort(run, {}, &Reading::taken);
    RunCells& cells = result.emplace_back();
    for (Reading* reading : run) cells.push_back(&column.cell(*reading));
  }
  return result;
}

enum class Guess : std::uint8_t { line, mean };

// Guesses each cell by the recorded ones of its run but itself; nothing if there is none.
std::vector<std::optional<double>> guesses(const RunCells& run, Guess guess) {
  double sum = 0;
  double count = 0;
  std::vector<std::optional<std::size_t>> before(run.size()), behind(run.size());
  std::optional<std::size_t> last;
  for (std::size_t k = 0; k < run.size(); ++k) {
    before[k] = last;
    if (!*run[k]) continue;
    last = k;
    sum += **run[k];
    count += 1;
  }
  last.reset();
  for (std::size_t k = run.size(); k-- > 0;) {
    behind[k] = last;
    if (*run[k]) last = k;
  }
  std::vector<std::optional<double>> result(run.size());
  for (std::size_t k = 0; k < run.size(); ++k) {
    if (!before[k] && !behind[k]) continue;
    if (guess == Guess::mean) {
      result[k] = *run[k] ? (sum - **run[k]) / (count - 1) : sum / count;
      continue;
    }
    const std::size_t from = before[k] ? *before[k] : *behind[k];
    const std::size_t to = behind[k].value_or(from);
    const double steps = static_cast<double>(to) - static_cast<double>(from);
    const double share =
        steps > 0 ? (static_cast<double>(k) - static_cast<double>(from)) / steps : 0;
    result[k] = std::lerp(**run[from], **run[to], share);
  }
  return result;
}

// Median distance of the recorded cells from a guess; NaN without any.
double distance_from(const std::vector<RunCells>& runs, Guess guess) {
  std::vector<double> off;
  for (const RunCells& run : runs) {
    const auto guessed = guesses(run, guess);
    for (std::size_t k = 0; k < run.size(); ++k) {
      if (*run[k] && guessed[k]) off.push_back(std::abs(**run[k] - *guessed[k]));
    }
  }
  return median(std::move(off));
}

std::optional<Guess> best_guess(const std::vector<RunCells>& runs) {
  std::vector<double> values;
  for (const RunCells& run : runs) {
    for (const std::optional<double>* cell : run) {
      if (*cell) values.push_back(**cell);
    }
  }
  const double middle = median(values);
  for (double& value : values) value = std::abs(value - middle);
  const double line = distance_from(runs, Guess::line);
  const double mean = distance_from(runs, Guess::mean);
  if (!(std::min(line, mean) <= well_met * median(std::move(values)))) return std::nullopt;
  return line <= mean ? Guess::line : Guess::mean;
}

// Returns the number of cells that it fills.
std::size_t fill(const std::vector<RunCells>& runs, Guess guess) {
  std::size_t filled = 0;
  for (const RunCells& run : runs) {
    const auto guessed = guesses(run, guess);
    for (std::size_t k = 0; k < run.size(); ++k) {
      if (*run[k] || !guessed[k]) continue;
      *run[k] = guessed[k];
      ++filled;
    }
  }
  return filled;
}

}  // namespace

std::vector<ConditionColumn> condition_columns(const MeasuredData& data) {
  using Cell = std::optional<double>;
  std::vector<ConditionColumn> result;
  result.push_back({"speed_mm_s", [](Reading& of) -> Cell& { return of.speed_mm_s; }});
  result.push_back({"cycle", [](Reading& of) -> Cell& { return of.cycle; }});
  result.push_back({"temperature_C", [](Reading& of) -> Cell& { return of.temperature_C; }});
  for (std::size_t c = 0; c < data.covariates.size(); ++c) {
    result.push_back({data.covariates[c], [c](Reading& of) -> Cell& { return of.covariates[c]; }});
  }
  return result;
}

void fill_columns(MeasuredData& data) {
  for (const ConditionColumn& column : condition_columns(data)) {
    const auto empty = std::ranges::count_if(
        data.readings, [&](Reading& reading) { return !column.cell(reading); });
    if (empty == 0 || empty == std::ssize(data.readings)) continue;
    const std::vector<RunCells> runs = cells_by_run(data, column);
    const std::optional<Guess> guess = best_guess(runs);
    const std::size_t filled = guess ? fill(runs, *guess) : 0;
    if (filled == 0) continue;
    data.notes.push_back(
        {NoteKind::assumed,
         fmt::format("column '{}' is empty in {} of {} rows, filled in {} by {}", column.name,
                     empty, data.readings.size(), filled,
                     *guess == Guess::line ? "the rows beside in the run" : "the mean of the run"),
         {}});
  }
}

}  // namespace reeve::readings
