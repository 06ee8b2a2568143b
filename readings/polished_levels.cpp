#include "readings/polished_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "numerics/robust.hpp"

namespace reeve::readings {

namespace {

constexpr int polishing_passes = 4;

// Channels that read nothing in many rows: slack, or behind a contact that lets nothing through.
// What they read else is noise, and says nothing of the load.
std::set<std::size_t> without_load(const KindCells& cells) {
  constexpr std::size_t most_zeros = 5;  // no load if more than one reading in this many is 0
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> counts;  // all, and those of nothing
  for (const KindCell& cell : cells) {
    auto& [all, nothing] = counts[cell.channel];
    ++all;
    if (!(cell.value_N > 0)) ++nothing;
  }
  std::set<std::size_t> result;
  for (const auto& [channel, count] : counts) {
    if (most_zeros * count.second > count.first) result.insert(channel);
  }
  return result;
}

}  // namespace

std::vector<KindCells> cells_by_kind(const MeasuredData& data) {
  std::map<std::tuple<std::size_t, std::uint64_t, Direction>, KindCells> by_kind;
  for (std::size_t i = 0; i < data.readings.size(); ++i) {
    const Reading& reading = data.readings[i];
    KindCells& cells = by_kind[{reading.routing, reading.grasp.held, reading.direction}];
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      if (reading.tension_N[c]) cells.push_back({i, c, *reading.tension_N[c]});
    }
    if (reading.motor_tension_N) {
      cells.push_back({i, data.channels.size(), *reading.motor_tension_N});
    }
  }
  std::vector<KindCells> result;
  for (auto& [kind, cells] : by_kind) result.push_back(std::move(cells));
  return result;
}

double PolishedLevels::expected_N(const KindCell& cell) const {
  const auto s = row.find(cell.reading);
  const auto l = channel.find(cell.channel);
  if (s == row.end() || l == channel.end()) return std::numeric_limits<double>::quiet_NaN();
  return std::exp(s->second + l->second);
}

PolishedLevels polished_levels(const KindCells& cells, std::size_t motor) {
  PolishedLevels levels;
  const std::set<std::size_t> slack = without_load(cells);
  const auto tells_of_load = [&](const KindCell& cell) {
    return cell.value_N > 0 && (cell.channel == motor || !slack.contains(cell.channel));
  };
  std::map<std::size_t, std::size_t> in_row;
  for (const KindCell& cell : cells) in_row[cell.reading] += tells_of_load(cell) ? 1 : 0;
  for (int pass = 0; pass < polishing_passes; ++pass) {
    std::map<std::size_t, std::vector<double>> by_row, by_channel;
    for (const KindCell& cell : cells) {
      if (!tells_of_load(cell)) continue;
      const bool is_scale = cell.channel == motor && in_row[cell.reading] < 3;
      const double left = std::log(cell.value_N) - levels.channel[cell.channel];
      std::vector<double>& row = by_row[cell.reading];
      if (is_scale) row.clear();
      row.push_back(left);
    }
    for (auto& [reading, values] : by_row) levels.row[reading] = median(std::move(values));
    for (const KindCell& cell : cells) {
      if (!(cell.value_N > 0) || !levels.row.contains(cell.reading)) continue;
      by_channel[cell.channel].push_back(std::log(cell.value_N) - levels.row[cell.reading]);
    }
    for (auto& [channel, values] : by_channel) levels.channel[channel] = median(std::move(values));
  }
  return levels;
}

double least_step(std::vector<double> values) {
  constexpr double rounding = 1e-9;
  std::sort(values.begin(), values.end());
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double difference = values[i] - values[i - 1];
    if (difference > rounding * std::abs(values[i])) step = std::min(step, difference);
  }
  return std::isfinite(step) ? step : 0;
}

}  // namespace reeve::readings
