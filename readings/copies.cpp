#include "readings/copies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "numerics/robust.hpp"
#include "readings/polished_levels.hpp"

namespace reeve::readings {
namespace {

constexpr double chance_of_copies = 0.01;
constexpr std::size_t least_stretch = 3;
constexpr double least_relative_scatter = 0.003;
// σ over the upper quartile of absolute deviations, if normal. The median is 0 where steps are
// coarse.
constexpr double scatter_per_quartile = 0.8693;
constexpr std::size_t enough_values = 20;  // needed to take the least difference as the step

auto kind_of(const Reading& reading) {
  return std::tie(reading.routing, reading.grasp.held, reading.direction);
}

auto tensions_of(const Reading& reading) {
  return std::tuple_cat(kind_of(reading), std::tie(reading.motor_tension_N, reading.tension_N));
}

// 0.01 of 3.25; 0 where a value has more than nine decimals, as after a conversion.
double decimal_step(const std::vector<double>& values) {
  double step = 1;
  for (const double value : values) {
    while (std::abs(value / step - std::round(value / step)) >
           1e-6 + 1e-12 * std::abs(value / step)) {
      step /= 10;
      if (step < 1e-9) return 0;
    }
  }
  return step;
}

double step_of(const std::vector<double>& values) {
  const std::set<double> distinct(values.begin(), values.end());
  const double decimal = decimal_step(values);
  return distinct.size() >= enough_values || decimal == 0 ? least_step(values) : decimal;
}

// Sensor of a channel in one kind of rows.
struct SensorCells {
  double step_N = 0;
  double scatter = 0;  // relative scatter about the levels
  double zeros = 0;    // share of its readings that are 0
};

std::map<std::size_t, SensorCells> sensors(const KindCells& cells, const PolishedLevels& levels,
                                           bool simulated) {
  const double least_scatter = simulated ? 0 : least_relative_scatter;
  std::map<std::size_t, std::vector<double>> values, left;
  for (const KindCell& cell : cells) {
    values[cell.channel].push_back(cell.value_N);
    const double expected_N = levels.expected_N(cell);
    if (expected_N > 0) left[cell.channel].push_back(std::abs(cell.value_N / expected_N - 1));
  }
  std::map<std::size_t, SensorCells> result;
  for (const auto& [channel, list] : values) {
    const auto zeros = static_cast<double>(std::count(list.begin(), list.end(), 0.0));
    result[channel] = {
        step_of(list),
        std::max(scatter_per_quartile * quantile_of(left[channel], 0.75), least_scatter),
        zeros / static_cast<double>(list.size())};
  }
  return result;
}

// p_c; 1 where nothing is known.
double chance_of_equal(const SensorCells& sensor, const KindCell& cell, double level_N) {
  if (cell.value_N == 0) return sensor.zeros;
  const double scatter_N = sensor.scatter * level_N;
  if (!(scatter_N > 0) || sensor.step_N == 0) return 1;
  return std::min(1.0, sensor.step_N / (2 * std::sqrt(std::numbers::pi) * scatter_N));
}

// A kind's readings, and what chance makes of them.
struct KindReadings {
  std::vector<std::size_t> readings;
  std::map<std::size_t, double> chance;  // Π p_c by reading
  double expected_pairs = 0;             // E
};

KindReadings kind_of_cells(const MeasuredData& data, const KindCells& cells) {
  const std::size_t motor = data.channels.size();
  const PolishedLevels levels = polished_levels(cells, motor);
  const std::map<std::size_t, SensorCells> of_channel = sensors(cells, levels, data.simulated);
  KindReadings kind;
  std::map<double, std::vector<double>> at_load;
  for (std::size_t begin = 0, end = 0; begin < cells.size(); begin = end) {
    end = begin;
    while (end < cells.size() && cells[end].reading == cells[begin].reading) ++end;
    const std::size_t load = cells[end - 1].channel == motor ? end - 1 : begin;
    double chance = 1;
    for (std::size_t i = begin; i < end; ++i) {
      if (i == load) continue;
      chance *=
          chance_of_equal(of_channel.at(cells[i].channel), cells[i], levels.expected_N(cells[i]));
    }
    kind.chance[cells[begin].reading] = chance;
    kind.readings.push_back(cells[begin].reading);
    at_load[cells[load].value_N].push_back(chance);
  }
  for (const auto& [load, list] : at_load) {
    const double others = static_cast<double>(list.size() - 1) / 2;
    kind.expected_pairs += others * std::accumulate(list.begin(), list.end(), 0.0);
  }
  return kind;
}

// Equal readings of a kind, each list in the order in which they were taken.
std::vector<std::vector<std::size_t>> classes_of(const MeasuredData& data,
                                                 const KindReadings& kind) {
  std::vector<std::size_t> order = kind.readings;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Reading& x = data.readings[a];
    const Reading& y = data.readings[b];
    return std::tuple_cat(tensions_of(x), std::tie(x.taken)) <
           std::tuple_cat(tensions_of(y), std::tie(y.taken));
  });
  std::vector<std::vector<std::size_t>> result;
  for (const std::size_t i : order) {
    const bool is_new = result.empty() || tensions_of(data.readings[result.back().front()]) !=
                                              tensions_of(data.readings[i]);
    if (is_new) result.emplace_back();
    result.back().push_back(i);
  }
  std::erase_if(result, [](const auto& equal) { return equal.size() < 2; });
  return result;
}

// Returns equal readings taken one after the other, without the first of each stretch.
std::set<std::size_t> stretched(const MeasuredData& data, const std::vector<std::size_t>& equal,
                                const KindReadings& kind) {
  const auto taken = [&](std::size_t place) { return data.readings[equal[place]].taken; };
  std::set<std::size_t> result;
  for (std::size_t begin = 0, end = 0; begin < equal.size(); begin = end) {
    end = begin + 1;
    while (end < equal.size() && taken(end) == taken(end - 1) + 1) ++end;
    const auto length = static_cast<double>(end - begin);
    const auto rows = static_cast<double>(kind.readings.size());
    if (end - begin >= least_stretch &&
        rows * std::pow(kind.chance.at(equal[begin]), length - 1) < chance_of_copies) {
      result.insert(equal.begin() + static_cast<std::ptrdiff_t>(begin) + 1,
                    equal.begin() + static_cast<std::ptrdiff_t>(end));
    }
  }
  return result;
}

void add_kind(const MeasuredData& data, const KindReadings& kind, EqualRows& result) {
  const auto classes = classes_of(data, kind);
  double repeated = 0;
  for (const auto& equal : classes) repeated += static_cast<double>(equal.size() - 1);
  const bool all_are_copies = kind.expected_pairs < chance_of_copies * repeated;
  for (const auto& equal : classes) {
    const std::set<std::size_t> in_stretches = stretched(data, equal, kind);
    std::set<std::size_t> runs{data.readings[equal.front()].run};
    for (std::size_t k = 1; k < equal.size(); ++k) {
      const std::size_t i = equal[k];
      const bool is_own = !runs.insert(data.readings[i].run).second;
      const bool is_copy = all_are_copies || in_stretches.count(i) != 0;
      (!is_copy ? result.by_chance : is_own ? result.copies : result.copies_across).push_back(i);
    }
  }
}

}  // namespace

EqualRows equal_rows(const MeasuredData& data) {
  EqualRows result;
  for (const KindCells& cells : cells_by_kind(data)) {
    add_kind(data, kind_of_cells(data, cells), result);
  }
  for (auto* list : {&result.copies, &result.copies_across, &result.by_chance}) {
    std::sort(list->begin(), list->end());
  }
  return result;
}

std::vector<std::size_t> repeated_readings(const MeasuredData& data) {
  const EqualRows equal = equal_rows(data);
  std::vector<std::size_t> repeated = equal.copies;
  repeated.insert(repeated.end(), equal.copies_across.begin(), equal.copies_across.end());
  std::sort(repeated.begin(), repeated.end());
  return repeated;
}

void note_equal_rows(MeasuredData& data) {
  const EqualRows equal = equal_rows(data);
  const auto note = [&](NoteKind kind, const std::vector<std::size_t>& readings, const char* text) {
    if (readings.empty()) return;
    std::vector<std::size_t> lines;
    for (const std::size_t i : readings) lines.push_back(data.readings[i].line);
    const char* repeat = readings.size() == 1 ? "row repeats" : "rows repeat";
    data.notes.push_back(
        {kind, fmt::format("{} {} {}", readings.size(), repeat, text), std::move(lines)});
  };
  note(
      NoteKind::duplicate, equal.copies,
      "an earlier row of the same run in every tension, which readings so fine do not do by chance: "
      "copies, or a logger that repeats its last value. A diagnosis leaves them out");
  note(
      NoteKind::duplicate_across_runs, equal.copies_across,
      "an earlier row of another run in every tension, which readings so fine do not do by chance. A "
      "diagnosis leaves them out: runs that share readings cannot test each other");
  note(NoteKind::equal_by_chance, equal.by_chance,
       "an earlier row in every tension, as readings so coarse do by chance. They are kept");
}

}  // namespace reeve::readings
