#include "diagnosis/dataset.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "numerics/robust.hpp"
#include "readings/column_name.hpp"
#include "readings/row_order.hpp"

namespace reeve::diagnosis {
namespace {

// RowPlaces says where the runs of some data stand, and their readings in them.
struct RowPlaces {
  std::vector<double> run;  // number of each run
  std::vector<double> row;  // place of each reading in its run, from 1, as they were taken
  // Time since each reading's run began, or since a pause in it; empty without a clock.
  std::vector<double> since_pause_s;
};

// The readings of each run, as they were taken.
using TakenInRuns = std::vector<std::vector<std::size_t>>;

// A step of the clock is a pause from so many usual ones.
constexpr double steps_of_a_pause = 5;

std::vector<double> since_pause_s(const MeasuredData& data, const TakenInRuns& taken) {
  const std::optional<std::size_t> clock = readings::clock_of(data);
  if (!clock) return {};
  const double unit = *readings::clock_unit(data.covariates[*clock]);
  const auto time_s = [&](std::size_t i) { return unit * *data.readings[i].covariates[*clock]; };
  std::vector<double> steps;
  for (const std::vector<std::size_t>& run : taken) {
    for (std::size_t k = 1; k < run.size(); ++k)
      steps.push_back(time_s(run[k]) - time_s(run[k - 1]));
  }
  const double pause = steps.empty() ? 0 : steps_of_a_pause * median(steps);
  std::vector<double> result(data.readings.size());
  for (const std::vector<std::size_t>& run : taken) {
    for (std::size_t k = 1; k < run.size(); ++k) {
      const double step = time_s(run[k]) - time_s(run[k - 1]);
      if (step < pause) result[run[k]] = result[run[k - 1]] + step;
    }
  }
  return result;
}

RowPlaces places(const MeasuredData& data) {
  RowPlaces found{readings::run_numbers(data.runs), std::vector<double>(data.readings.size()), {}};
  std::vector<std::size_t> taken(data.readings.size());
  std::iota(taken.begin(), taken.end(), std::size_t{0});
  std::ranges::sort(taken, {}, [&](std::size_t i) { return data.readings[i].taken; });
  TakenInRuns in_runs(data.runs.size());
  for (const std::size_t i : taken) {
    std::vector<std::size_t>& run = in_runs[data.readings[i].run];
    run.push_back(i);
    found.row[i] = static_cast<double>(run.size());
  }
  found.since_pause_s = since_pause_s(data, in_runs);
  return found;
}

std::shared_ptr<const Record> record(const MeasuredData& data, std::size_t index,
                                     const RowPlaces& places, double order) {
  const Reading& reading = data.readings[index];
  Record result{data.runs[reading.run], reading.group ? data.groups[*reading.group] : "", {}};
  const auto add = [&](const std::string& name, std::optional<double> value) {
    if (value) result.columns.push_back({name, *value});
  };
  add("order", order);
  add("run", places.run[reading.run]);
  add("row_in_run", places.row[index]);
  if (!places.since_pause_s.empty()) add("since_pause_s", places.since_pause_s[index]);
  add("sheath_angle_rad", reading.sheath_angle_rad);
  for (std::size_t c = 0; c < data.covariates.size(); ++c) {
    add(data.covariates[c], reading.covariates[c]);
  }
  return std::make_shared<const Record>(std::move(result));
}

Conditions conditions(const MeasuredData& data, std::size_t index, const RowPlaces& places) {
  const Reading& reading = data.readings[index];
  Conditions result;
  result.motor_tension_N = reading.motor_tension_N.value_or(result.motor_tension_N);
  result.speed_mm_s = reading.speed_mm_s.value_or(result.speed_mm_s);
  result.cycle = reading.cycle.value_or(result.cycle);
  result.temperature_C = reading.temperature_C.value_or(result.temperature_C);
  const std::size_t last = data.readings.size() - 1;
  result.order = last > 0 ? static_cast<double>(reading.taken) / static_cast<double>(last) : 0;
  result.record = record(data, index, places, result.order);
  return result;
}

bool says_something(const std::vector<Cell>& cells, const Reading& reading) {
  if (reading.motor_tension_N) return *reading.motor_tension_N > 0;
  double sum_N = 0;
  for (const Cell& cell : cells) sum_N += cell.measured_N;
  return cells.size() >= 2 && sum_N > 0;
}

template <typename Member>
bool any_given(const MeasuredData& data, Member member) {
  return std::ranges::any_of(data.readings,
                             [&](const Reading& reading) { return (reading.*member).has_value(); });
}

template <typename Member>
bool varies(const MeasuredData& data, Member member) {
  return std::ranges::any_of(data.readings, [&](const Reading& reading) {
    return reading.*member != data.readings.front().*member;
  });
}

// Some reading is less than half of another.
bool is_wide(const MeasuredData& data, std::size_t channel) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0;
  for (const Reading& reading : data.readings) {
    const std::optional<double>& tension = reading.tension_N[channel];
    if (!tension) continue;
    least = std::min(least, *tension);
    greatest = std::max(greatest, *tension);
  }
  return 2 * least < greatest;
}

}  // namespace

Conditions typical_conditions(const MeasuredData& data, const std::vector<std::size_t>& readings) {
  Conditions result;
  const auto median_of_given = [&](const auto& value_of) {
    std::vector<double> values;
    for (const std::size_t i : readings) {
      if (const std::optional<double> value = value_of(data.readings[i])) values.push_back(*value);
    }
    if (values.empty()) return std::optional<double>();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
    std::nth_element(values.begin(), middle, values.end());
    return std::optional(*middle);
  };
  const auto take = [&](double Conditions::*to, std::optional<double> Reading::*from) {
    const auto value = median_of_given([&](const Reading& reading) { return reading.*from; });
    if (value) result.*to = *value;
  };
  take(&Conditions::motor_tension_N, &Reading::motor_tension_N);
  take(&Conditions::speed_mm_s, &Reading::speed_mm_s);
  take(&Conditions::cycle, &Reading::cycle);
  take(&Conditions::temperature_C, &Reading::temperature_C);
  Record record;
  for (std::size_t c = 0; c < data.covariates.size(); ++c) {
    const auto value = median_of_given([&](const Reading& of) { return of.covariates[c]; });
    if (value) record.columns.push_back({data.covariates[c], *value});
  }
  result.record = std::make_shared<const Record>(std::move(record));
  return result;
}

double Dataset::degrees_of_freedom() const {
  const auto free =
      std::ranges::count_if(rows, [](const DatasetRow& row) { return !row.has_motor_tension; });
  return static_cast<double>(cells.size()) - static_cast<double>(free);
}

std::vector<std::ptrdiff_t> rows_of_part(const Dataset& all, const Dataset& part) {
  std::vector<std::ptrdiff_t> result;
  auto from = all.rows.begin();
  for (const DatasetRow& row : part.rows) {
    while (from->reading != row.reading) ++from;  // both in the order of the readings
    result.push_back(from - all.rows.begin());
  }
  return result;
}

std::vector<std::ptrdiff_t> cells_of_part(const Dataset& all, const Dataset& part) {
  std::vector<std::ptrdiff_t> result;
  for (const std::ptrdiff_t r : rows_of_part(all, part)) {
    const DatasetRow& row = all.rows[static_cast<std::size_t>(r)];
    for (std::size_t i = row.first; i < row.last; ++i) {
      result.push_back(static_cast<std::ptrdiff_t>(i));
    }
  }
  return result;
}

Dataset dataset(const MeasuredData& data, const std::vector<std::size_t>& readings, Rows rows) {
  using Key = std::tuple<std::size_t, std::uint64_t, Direction, std::optional<double>>;
  Dataset result;
  result.data = &data;
  std::map<Key, std::size_t> blocks;
  const RowPlaces where = places(data);
  for (const std::size_t index : readings) {
    const Reading& reading = data.readings[index];
    std::vector<Cell> cells;
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      if (!reading.tension_N[c]) continue;
      cells.push_back({index, c, *data.routings[reading.routing].segments[c], *reading.tension_N[c],
                       result.rows.size()});
    }
    if (rows == Rows::that_say_something && !says_something(cells, reading)) continue;
    const Key key{reading.routing, reading.grasp.held, reading.direction, reading.sheath_angle_rad};
    const auto [found, is_new] = blocks.emplace(key, result.blocks.size());
    if (is_new) {
      result.blocks.push_back(
          {reading.routing, reading.grasp, reading.direction, reading.sheath_angle_rad, {}});
    }
    result.blocks[found->second].rows.push_back(result.rows.size());
    result.rows.push_back({index, result.cells.size(), result.cells.size() + cells.size(),
                           reading.motor_tension_N.has_value(), motor_deviation(data, reading),
                           conditions(data, index, where)});
    result.cells.insert(result.cells.end(), cells.begin(), cells.end());
  }
  return result;
}

double force_scale(const MeasuredData& data) {
  std::vector<double> loads;
  for (const Reading& reading : data.readings) {
    double sum = 0;
    for (const auto& tension : reading.tension_N) sum += std::max(tension.value_or(0), 0.0);
    const double load = reading.motor_tension_N.value_or(sum);
    if (load > 0) loads.push_back(load);
  }
  if (loads.empty()) return 1;
  const auto middle = loads.begin() + static_cast<std::ptrdiff_t>(loads.size() / 2);
  std::nth_element(loads.begin(), middle, loads.end());
  return *middle / range_load_N;
}

Survey survey(const MeasuredData& data) {
  Survey result;
  for (const MeasuredRouting& routing : data.routings) {
    result.routings.push_back({routing.word, &routing.network, {}});
  }
  for (const Reading& reading : data.readings) {
    std::vector<Grasp>& recorded = result.routings[reading.routing].recorded;
    if (std::ranges::find(recorded, reading.grasp) == recorded.end()) {
      recorded.push_back(reading.grasp);
    }
  }
  for (std::size_t c = 0; c < data.channels.size(); ++c) {
    result.channels.push_back(data.channels[c].segment);
    if (is_wide(data, c)) result.wide_channels.push_back(data.channels[c].segment);
  }
  result.has_speed = any_given(data, &Reading::speed_mm_s);
  result.has_cycle = any_given(data, &Reading::cycle);
  result.has_temperature = any_given(data, &Reading::temperature_C);
  result.has_motor_tension = any_given(data, &Reading::motor_tension_N);
  result.has_both_directions = varies(data, &Reading::direction);
  result.sheath_angle_varies = varies(data, &Reading::sheath_angle_rad);
  const std::vector<bool> below = reads_below_zero(data);
  result.reads_below_zero = std::ranges::find(below, true) != below.end();
  return result;
}

}  // namespace reeve::diagnosis
