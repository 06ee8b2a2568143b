#include "diagnosis/verdict/model_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/fit/forecast.hpp"
#include "diagnosis/verdict/run_words.hpp"
#include "numerics/robust.hpp"
#include "readings/units.hpp"

namespace reeve::diagnosis {
namespace {

constexpr double odd_direction_factor = 3;
constexpr double least_odd_direction = 0.1;
constexpr double most_odd_of_a_run = 0.2;
constexpr std::size_t least_odd_rows = 3;
constexpr std::size_t least_rows_shifted = 20;
constexpr double shifted_factor = 3;
constexpr double least_shifted = 0.05;

// Calls use(row, cell, ln (T / m)) for each cell in which both are above zero.
template <typename Use>
void for_each_logarithm(const Dataset& all, const Forecast& at, Use use) {
  for (const DatasetRow& row : all.rows) {
    if (!row.has_motor_tension) continue;
    for (std::size_t i = row.first; i < row.last; ++i) {
      const double forecast_N = at.reading_N[static_cast<Eigen::Index>(i)];
      const double measured_N = all.cells[i].measured_N;
      if (forecast_N > 0 && measured_N > 0) {
        use(row, all.cells[i], std::log(measured_N / forecast_N));
      }
    }
  }
}

constexpr double near_a_unit = 0.1;  // in logarithms
constexpr std::size_t enough_readings = 8;

struct ChannelLevel {
  double middle = 0;  // median of ln (T / m)
  double spread = 0;  // median of the distances from it
};

// NaN of channels with few readings that tell.
std::vector<ChannelLevel> channel_levels(const Dataset& all, const Forecast& at) {
  std::vector<std::vector<double>> logs(all.data->channels.size());
  for_each_logarithm(all, at, [&](const DatasetRow&, const Cell& cell, double logarithm) {
    logs[cell.channel].push_back(logarithm);
  });
  std::vector<ChannelLevel> levels;
  for (std::vector<double>& of_channel : logs) {
    if (of_channel.size() < enough_readings) {
      levels.push_back({std::nan(""), std::nan("")});
      continue;
    }
    const double middle = median(of_channel);
    for (double& logarithm : of_channel) logarithm = std::abs(logarithm - middle);
    levels.push_back({middle, median(std::move(of_channel))});
  }
  return levels;
}

struct ChannelGroup {
  std::vector<std::string> off;  // columns that read exp(middle) times what the model says
  std::size_t others = 0;
  bool others_are_near = true;
};

ChannelGroup group_at(double middle, const std::vector<ChannelLevel>& levels,
                      const std::vector<Channel>& channels) {
  ChannelGroup group;
  for (std::size_t c = 0; c < levels.size(); ++c) {
    if (std::isnan(levels[c].middle)) continue;
    if (std::abs(levels[c].middle - middle) < near_a_unit && levels[c].spread <= near_a_unit) {
      group.off.push_back(channels[c].name + "_N");
      continue;
    }
    ++group.others;
    if (std::abs(levels[c].middle) > std::abs(middle) / 2) group.others_are_near = false;
  }
  return group;
}

std::string who_is_off(const ChannelGroup& group, double factor) {
  const bool are_many = group.off.size() > 1;
  // Two channels of which one is off do not say which.
  const std::size_t least_others = are_many && group.others == 0 ? 0 : 2;
  if (group.off.empty() || !group.others_are_near || group.others < least_others) return "";
  return fmt::format(
      "{} {} about {:.3g} times what the model says{}: {}", fmt::join(group.off, ", "),
      are_many ? "read" : "reads", factor,
      group.others == 0 ? " with the motor's tension" : ", and no other channel is off like that",
      are_many ? "are they in " : "is it in ");
}

// By reading; NaN if nothing can be compared.
using RowLevels = std::vector<double>;

// Medians over each row of use(ln (T / m)).
template <typename Use>
RowLevels row_levels(const MeasuredData& data, const std::vector<std::size_t>& readings,
                     const Model& model, Use use) {
  RowLevels result(data.readings.size(), std::nan(""));
  const Dataset all = dataset(data, readings);
  const std::optional<Forecast> at = try_forecast(all, model);
  if (!at) return result;
  std::map<std::size_t, std::vector<double>> off;
  for_each_logarithm(all, *at, [&](const DatasetRow& row, const Cell&, double logarithm) {
    off[row.reading].push_back(use(logarithm));
  });
  for (auto& [reading, of_row] : off) result[reading] = median(std::move(of_row));
  return result;
}

RowLevels distances(const MeasuredData& data, const std::vector<std::size_t>& readings,
                    const Model& model) {
  return row_levels(data, readings, model, [](double logarithm) { return std::abs(logarithm); });
}

// Readings i and j of one run, j the one behind or before i as they were taken.
struct Neighbours {
  std::size_t i = 0, j = 0;
};

std::vector<Neighbours> neighbours(const MeasuredData& data,
                                   const std::vector<std::size_t>& readings, bool behind) {
  std::vector<std::size_t> taken = readings;
  std::ranges::sort(taken, {}, [&](std::size_t i) { return data.readings[i].taken; });
  if (!behind) std::ranges::reverse(taken);
  std::vector<Neighbours> result;
  for (std::size_t k = 1; k < taken.size(); ++k) {
    const Neighbours pair{taken[k - 1], taken[k]};
    if (data.readings[pair.i].run == data.readings[pair.j].run) result.push_back(pair);
  }
  return result;
}

// Median distance of the levels, each from the median of its block.
double spread_in_blocks(const Dataset& all, const RowLevels& levels) {
  std::vector<double> off;
  for (const ReadingBlock& block : all.blocks) {
    std::vector<double> own;
    for (const std::size_t row : block.rows) {
      const double level = levels[all.rows[row].reading];
      if (!std::isnan(level)) own.push_back(level);
    }
    if (own.empty()) continue;
    const double middle = median(own);
    for (const double level : own) off.push_back(std::abs(level - middle));
  }
  return off.size() < least_rows_shifted ? std::nan("") : median(std::move(off));
}

MeasuredData the_other_way(MeasuredData data) {
  for (Reading& reading : data.readings) {
    reading.direction = reading.direction == Direction::pull ? Direction::release : Direction::pull;
  }
  return data;
}

double usual_distance(const RowLevels& recorded, const RowLevels& other) {
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
  const RowLevels recorded = distances(data, readings, nominal);
  const MeasuredData reversed = the_other_way(data);
  const RowLevels other = distances(reversed, readings, nominal);
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

std::optional<DataNote> note_on_shifted_rows(const MeasuredData& data,
                                             const std::vector<std::size_t>& readings,
                                             const Model& nominal) {
  const Dataset all = dataset(data, readings);
  const RowLevels levels =
      row_levels(data, readings, nominal, [](double logarithm) { return logarithm; });
  for (const bool behind : {true, false}) {
    RowLevels own(levels.size(), std::nan(""));
    RowLevels other = own;
    for (const auto& [i, j] : neighbours(data, readings, behind)) {
      const double motor_N = data.readings[j].motor_tension_N.value_or(0);
      if (std::isnan(levels[i]) || !(motor_N > 0)) continue;
      own[i] = levels[i];
      other[i] = levels[i] + std::log(*data.readings[i].motor_tension_N / motor_N);
    }
    const double by_own = spread_in_blocks(all, own);
    const double by_other = spread_in_blocks(all, other);
    if (!(by_own > shifted_factor * by_other && by_own > least_shifted)) continue;
    return DataNote{
        NoteKind::shifted_rows,
        fmt::format("tensions go with motor_tension_N of the row {} them, {:.2g} % off, better "
                    "than with that of their own, {:.2g} % off: is a column a row late?",
                    behind ? "behind" : "before", 100 * by_other, 100 * by_own),
        {}};
  }
  return std::nullopt;
}

std::vector<DataNote> notes_on_channel_units(const Dataset& all, const Model& nominal) {
  const std::optional<Forecast> at = try_forecast(all, nominal);
  if (!at) return {};
  const std::vector<ChannelLevel> levels = channel_levels(all, *at);
  std::vector<DataNote> notes;
  for (const char* unit : {"kgf", "lbf", "kN"}) {
    const double factor = find_unit(unit, Dimension::force)->factor;
    for (const bool is_taken_for_it : {false, true}) {
      const double reads = is_taken_for_it ? factor : 1 / factor;
      const std::string who =
          who_is_off(group_at(std::log(reads), levels, all.data->channels), reads);
      if (who.empty()) continue;
      notes.push_back({NoteKind::units,
                       is_taken_for_it ? fmt::format("{}newton, and taken for {}?", who, unit)
                                       : fmt::format("{}{}?", who, unit),
                       {}});
    }
  }
  return notes;
}

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
  std::ranges::sort(note.lines);
  note.text = fmt::format(
      "{} of {} rows of {} read as if the carriage had gone the other way than their direction "
      "says: is it written down as it was?",
      count, rows, runs_text(runs, data));
  return note;
}

}  // namespace reeve::diagnosis
