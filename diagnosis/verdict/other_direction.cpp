#include "diagnosis/verdict/other_direction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/fit/forecast.hpp"
#include "diagnosis/verdict/run_words.hpp"
#include "numerics/robust.hpp"

namespace reeve::diagnosis {
namespace {

// Distances by reading; NaN if nothing can be compared.
using RowDistances = std::vector<double>;

RowDistances distances(const MeasuredData& data, const std::vector<std::size_t>& readings,
                       const Model& model) {
  RowDistances result(data.readings.size(), std::nan(""));
  const Dataset all = dataset(data, readings);
  const std::optional<Forecast> at = try_forecast(all, model);
  if (!at) return result;
  for (const DatasetRow& row : all.rows) {
    if (!row.has_motor_tension) continue;
    std::vector<double> off;
    for (std::size_t i = row.first; i < row.last; ++i) {
      const double forecast_N = at->reading_N[static_cast<Eigen::Index>(i)];
      const double measured_N = all.cells[i].measured_N;
      if (forecast_N > 0 && measured_N > 0)
        off.push_back(std::abs(std::log(measured_N / forecast_N)));
    }
    result[row.reading] = median(std::move(off));
  }
  return result;
}

MeasuredData the_other_way(MeasuredData data) {
  for (Reading& reading : data.readings) {
    reading.direction = reading.direction == Direction::pull ? Direction::release : Direction::pull;
  }
  return data;
}

double usual_distance(const RowDistances& recorded, const RowDistances& other) {
  std::vector<double> lesser;
  for (std::size_t r = 0; r < recorded.size(); ++r) {
    if (recorded[r] >= 0 && other[r] >= 0) lesser.push_back(std::min(recorded[r], other[r]));
  }
  return median(std::move(lesser));
}

struct OddRun {
  std::size_t rows = 0;
  std::vector<std::size_t> odd;  // readings
};

std::map<std::size_t, OddRun> odd_runs(const MeasuredData& data,
                                       const std::vector<std::size_t>& readings,
                                       const Model& nominal) {
  const RowDistances recorded = distances(data, readings, nominal);
  const MeasuredData reversed = the_other_way(data);
  const RowDistances other = distances(reversed, readings, nominal);
  const double usual = usual_distance(recorded, other);
  std::map<std::size_t, OddRun> runs;
  for (std::size_t r = 0; r < recorded.size(); ++r) {
    if (!(recorded[r] >= 0 && other[r] >= 0)) continue;
    OddRun& run = runs[data.readings[r].run];
    ++run.rows;
    if (recorded[r] > odd_direction_factor * std::max(other[r], usual) &&
        recorded[r] > least_odd_direction) {
      run.odd.push_back(r);
    }
  }
  std::erase_if(runs, [](const auto& run) {
    return run.second.odd.size() < least_odd_rows ||
           static_cast<double>(run.second.odd.size()) <=
               most_odd_of_a_run * static_cast<double>(run.second.rows);
  });
  return runs;
}

}  // namespace

std::optional<DataNote> note_on_other_direction(const MeasuredData& data,
                                                const std::vector<std::size_t>& readings,
                                                const Model& nominal) {
  const std::map<std::size_t, OddRun> odd = odd_runs(data, readings, nominal);
  if (odd.empty()) return std::nullopt;
  DataNote note{NoteKind::other_direction, "", {}};
  std::vector<std::size_t> runs;
  std::size_t rows = 0;
  for (const auto& [number, run] : odd) {
    runs.push_back(number);
    rows += run.rows;
    for (const std::size_t reading : run.odd) {
      note.lines.push_back(data.readings[reading].line);
    }
  }
  const std::size_t count = note.lines.size();
  std::sort(note.lines.begin(), note.lines.end());
  note.text = fmt::format(
      "{} of {} rows of {} read as if the carriage had gone the other way than their direction "
      "says: is it written down as it was?",
      count, rows, runs_text(runs, data));
  return note;
}

}  // namespace reeve::diagnosis
