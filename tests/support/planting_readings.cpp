#include "tests/support/planting_readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "tests/support/planting_walk.hpp"

namespace reeve::testing {
namespace {

using Tensions = std::map<std::string, double>;

bool depends_on_load(const Nature& nature) {
  return nature.load_exponent != 0 || nature.bending_force_N != 0 || nature.drag_force_N != 0;
}

// Without what does not act, so that most rows are solved once.
Condition essential(const Nature& nature, Condition condition) {
  if (nature.speed_slope == 0) condition.speed_mm_s.reset();
  if (nature.wear_change == 0) condition.cycle.reset();
  if (nature.temperature_slope_per_K == 0) condition.temperature_C.reset();
  if (!depends_on_load(nature)) condition.motor_tension_N = 1;
  return condition;
}

class TensionTable {
 public:
  explicit TensionTable(const Nature& nature) : nature_(nature) {}

  Tensions of(const Condition& condition) {
    const Condition c = essential(nature_, condition);
    const Key key{c.word,       c.held,  c.direction,     c.motor_tension_N,
                  c.speed_mm_s, c.cycle, c.temperature_C, c.exponent_factor};
    auto found = solved_.find(key);
    if (found == solved_.end()) found = solved_.emplace(key, planted_tensions(nature_, c)).first;
    Tensions tension = found->second;
    for (auto& [segment, value] : tension) value *= condition.motor_tension_N / c.motor_tension_N;
    return tension;
  }

 private:
  using Key =
      std::tuple<std::string, std::set<int>, ReferenceDirection, double, std::optional<double>,
                 std::optional<double>, std::optional<double>, std::map<ContactName, double>>;
  const Nature& nature_;
  std::map<Key, Tensions> solved_;
};

void add_pretension(const Sensors& sensors, Tensions& tension) {
  for (auto& [segment, value] : tension) {
    if (is_strand(segment)) value += sensors.pretension_N;
  }
}

// In the order of the columns: each channel takes a share of the next one that the row has.
void add_crosstalk(const Sensors& sensors, const std::vector<std::string>& channels,
                   Tensions& tension) {
  const Tensions clean = tension;
  const std::string* last = nullptr;
  for (const std::string& channel : channels) {
    if (!clean.contains(channel)) continue;
    if (last != nullptr) tension.at(*last) += sensors.crosstalk * clean.at(channel);
    last = &channel;
  }
}

double found_or(const std::map<std::string, double>& values, const std::string& key, double other) {
  const auto found = values.find(key);
  return found == values.end() ? other : found->second;
}

double factor_in_order(const Sensors& sensors, std::size_t row, std::size_t rows) {
  const auto order = static_cast<double>(row);
  const double phase = 2 * std::numbers::pi * order / sensors.wave_period_rows;
  return (1 + sensors.drift * order / static_cast<double>(rows)) *
         (1 + sensors.wave_amplitude * std::sin(phase));
}

std::string held_text(const std::set<int>& held) { return fmt::format("{}", fmt::join(held, ";")); }

std::string number_text(const std::optional<double>& number) {
  return number ? fmt::format("{:.10g}", *number) : "";
}

// A column other than those of the sensors.
struct RowColumn {
  std::string name;
  std::string (*text)(const ExperimentRow&);
};

std::vector<RowColumn> row_columns(const Experiment& experiment) {
  std::vector<RowColumn> columns{
      {"run", [](const ExperimentRow& row) { return row.run; }},
      {"routing", [](const ExperimentRow& row) { return row.condition.word; }},
      {"held", [](const ExperimentRow& row) { return held_text(row.condition.held); }},
      {"direction",
       [](const ExperimentRow& row) -> std::string {
         return row.condition.direction == ReferenceDirection::pull ? "pull" : "release";
       }},
      {"motor_tension_N",
       [](const ExperimentRow& row) { return number_text(row.condition.motor_tension_N); }}};
  const std::vector<RowColumn> optional{
      {"speed_mm_s",
       [](const ExperimentRow& row) { return number_text(row.condition.speed_mm_s); }},
      {"cycle", [](const ExperimentRow& row) { return number_text(row.condition.cycle); }},
      {"temperature_C",
       [](const ExperimentRow& row) { return number_text(row.condition.temperature_C); }}};
  for (const RowColumn& column : optional) {
    const auto& rows = experiment.rows;
    if (std::any_of(rows.begin(), rows.end(),
                    [&](const ExperimentRow& row) { return !column.text(row).empty(); })) {
      columns.push_back(column);
    }
  }
  return columns;
}

std::string column_of(const std::string& channel) {
  return (is_strand(channel) ? "" : "T") + channel + "_N";
}

std::string cell(const ExperimentRow& row, const std::vector<double>& readings,
                 const std::string& channel) {
  const auto at = std::find(row.measured.begin(), row.measured.end(), channel);
  if (at == row.measured.end()) return "";
  return fmt::format("{:.4f}", readings[static_cast<std::size_t>(at - row.measured.begin())]);
}

}  // namespace

Readings expected_readings(const Truth& truth, const Experiment& experiment) {
  const Sensors& sensors = truth.sensors;
  TensionTable table(truth.nature);
  const std::size_t last = experiment.rows.empty() ? 0 : experiment.rows.size() - 1;
  Readings readings;
  for (std::size_t i = 0; i < experiment.rows.size(); ++i) {
    const ExperimentRow& row = experiment.rows[i];
    Condition condition = row.condition;
    condition.motor_tension_N = at_tendon(truth.drive, condition);
    Tensions tension = table.of(condition);
    add_pretension(sensors, tension);
    add_crosstalk(sensors, experiment.channels, tension);
    apply(truth.electronics, experiment.channels,
          static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(last, 1)), tension);
    const double factor = factor_in_order(sensors, i, experiment.rows.size());
    std::vector<double>& of_row = readings.emplace_back();
    for (const std::string& channel : row.measured) {
      const double gain = found_or(sensors.gain, channel, 1);
      const double offset_N = found_or(sensors.offset_N, channel, 0);
      const double mounted = found_or(row.gain, channel, 1);
      of_row.push_back(factor * mounted * (gain * tension.at(channel) + offset_N));
    }
  }
  return readings;
}

double as_printed(double reading_N) { return std::round(reading_N * 1e4) / 1e4; }

std::string to_csv(const Experiment& experiment, const Readings& readings,
                   const std::string& comment) {
  const std::vector<RowColumn> columns = row_columns(experiment);
  std::string text = "# simulated: " + comment + "\n";
  std::string header;
  for (const RowColumn& column : columns) header += (header.empty() ? "" : ",") + column.name;
  for (const std::string& channel : experiment.channels) header += "," + column_of(channel);
  text += header + "\n";
  for (std::size_t i = 0; i < experiment.rows.size(); ++i) {
    const ExperimentRow& row = experiment.rows[i];
    for (const RowColumn& column : columns) {
      if (&column != &columns.front()) text += ",";
      text += column.text(row);
    }
    for (const std::string& channel : experiment.channels) {
      text += "," + cell(row, readings[i], channel);
    }
    text += "\n";
  }
  return text;
}

}  // namespace reeve::testing
