#include "diagnosis/data/dataset.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace reeve::diagnosis {
namespace {

Conditions conditions(const Reading& reading) {
  Conditions result;
  result.motor_tension_N = reading.motor_tension_N.value_or(result.motor_tension_N);
  result.speed_mm_s = reading.speed_mm_s.value_or(result.speed_mm_s);
  result.cycle = reading.cycle.value_or(result.cycle);
  result.temperature_C = reading.temperature_C.value_or(result.temperature_C);
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
  return std::any_of(data.readings.begin(), data.readings.end(),
                     [&](const Reading& reading) { return (reading.*member).has_value(); });
}

}  // namespace

double Dataset::degrees_of_freedom() const {
  const auto free = std::count_if(rows.begin(), rows.end(),
                                  [](const DatasetRow& row) { return !row.has_motor_tension; });
  return static_cast<double>(cells.size()) - static_cast<double>(free);
}

Dataset dataset(const MeasuredData& data, const std::vector<std::size_t>& readings, Rows rows) {
  using Key = std::tuple<std::size_t, std::uint64_t, Direction, std::optional<double>>;
  Dataset result;
  result.data = &data;
  std::map<Key, std::size_t> blocks;
  for (const std::size_t index : readings) {
    const Reading& reading = data.readings[index];
    std::vector<Cell> cells;
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      if (!reading.tension_N[c]) continue;
      cells.push_back(
          {index, c, *data.routings[reading.routing].segments[c], *reading.tension_N[c]});
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
                           reading.motor_tension_N.has_value(), conditions(reading)});
    result.cells.insert(result.cells.end(), cells.begin(), cells.end());
  }
  return result;
}

Survey survey(const MeasuredData& data) {
  Survey result;
  for (const MeasuredRouting& routing : data.routings) {
    result.routings.push_back({routing.word, &routing.network, {}});
  }
  for (const Reading& reading : data.readings) {
    std::vector<Grasp>& recorded = result.routings[reading.routing].recorded;
    if (std::find(recorded.begin(), recorded.end(), reading.grasp) == recorded.end()) {
      recorded.push_back(reading.grasp);
    }
  }
  for (const Channel& channel : data.channels) result.channels.push_back(channel.segment);
  result.has_speed = any_given(data, &Reading::speed_mm_s);
  result.has_cycle = any_given(data, &Reading::cycle);
  result.has_temperature = any_given(data, &Reading::temperature_C);
  return result;
}

}  // namespace reeve::diagnosis
