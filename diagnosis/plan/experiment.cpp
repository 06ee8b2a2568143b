#include "diagnosis/plan/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "numerics/random.hpp"
#include "numerics/streams.hpp"

namespace reeve::diagnosis {
namespace {

enum class Factor : std::uint32_t {
  grasp = streams::grasps,
  motor_tension = streams::motor_tensions,
  speed = streams::speeds,
  temperature = streams::temperatures,
  sheath_angle = streams::sheath_angles
};

Factor factor_of_column(std::size_t column) {
  return static_cast<Factor>(streams::columns + 2 * static_cast<std::uint32_t>(column));
}
std::uint32_t order_stream(Factor factor) { return static_cast<std::uint32_t>(factor); }
std::uint32_t place_stream(Factor factor) { return static_cast<std::uint32_t>(factor) + 1; }

// As a person would set it, and within the range for all that.
double four_digits(double value, Range range) {
  if (value == 0) return std::clamp(value, range.low, range.high);
  const double exponent = std::floor(std::log10(std::abs(value))) - 3;
  const double power = std::pow(10, std::abs(exponent));
  const double rounded =
      exponent < 0 ? std::round(value * power) / power : std::round(value / power) * power;
  return std::clamp(rounded, range.low, range.high);
}

double between(Range range, double share, bool logarithmic) {
  if (logarithmic) return range.low * std::pow(range.high / range.low, share);
  return range.low + share * (range.high - range.low);
}

// Rows of one run: which level each factor has in each of them. Or the runs of an experiment, for
// what changes from run to run.
class RunPlanner {
 public:
  RunPlanner(const ExperimentPlan& plan, std::uint64_t seed, std::size_t run)
      : seed_(seed), run_(run), rows_(plan.rows), mounting_(run / plan.routings.size()) {}
  static RunPlanner of_runs(const ExperimentPlan& plan, std::uint64_t seed) {
    RunPlanner planner(plan, seed, 0);
    planner.rows_ = plan.runs;
    return planner;
  }

  // The levels' numbers, equally often to within one; which are once more changes by mounting.
  std::vector<std::size_t> levels(Factor factor, std::size_t count) const {
    std::vector<std::size_t> numbers = order(factor);
    for (std::size_t& number : numbers) number = (mounting_ * rows_ + number) % count;
    return numbers;
  }

  std::vector<double> values(Factor factor, const PlannedLevels& levels,
                             bool logarithmic = false) const {
    std::vector<double> values;
    values.reserve(rows_);
    if (!levels.list.empty()) {
      for (const std::size_t i : this->levels(factor, levels.list.size())) {
        values.push_back(levels.list[i]);
      }
      return values;
    }
    for (const std::size_t part : order(factor)) {
      const double within = uniform(seed_, place_stream(factor), run_ * rows_ + values.size());
      const double share = (static_cast<double>(part) + within) / static_cast<double>(rows_);
      values.push_back(four_digits(between(levels.range, share, logarithmic), levels.range));
    }
    return values;
  }

 private:
  // The rows' numbers, shuffled.
  std::vector<std::size_t> order(Factor factor) const {
    std::vector<double> keys(rows_);
    for (std::size_t row = 0; row < rows_; ++row) {
      keys[row] = uniform(seed_, order_stream(factor), run_ * rows_ + row);
    }
    std::vector<std::size_t> numbers(rows_);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    std::ranges::stable_sort(numbers,
                             [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    return numbers;
  }

  std::uint64_t seed_;
  std::size_t run_;
  std::size_t rows_;
  std::size_t mounting_;
};

// The values of each column: by run, those of all runs; otherwise those of this one's rows.
using ColumnValues = std::vector<std::vector<double>>;

ColumnValues column_values(const ExperimentPlan& plan, const RunPlanner& planner,
                           const RunPlanner& of_runs) {
  ColumnValues values;
  for (std::size_t c = 0; c < plan.columns.size(); ++c) {
    const PlannedColumn& column = plan.columns[c];
    values.push_back(
        (column.by_run ? of_runs : planner).values(factor_of_column(c), column.levels));
  }
  return values;
}

// As a file of these readings says it.
std::shared_ptr<const Record> record_of(const ExperimentPlan& plan, const PlannedReading& reading,
                                        std::size_t row_in_run) {
  std::vector<NamedValue> columns;
  for (std::size_t c = 0; c < plan.columns.size(); ++c) {
    columns.push_back({plan.columns[c].name, reading.columns[c]});
  }
  columns.push_back({"order", reading.conditions.order});
  columns.push_back({"run", static_cast<double>(reading.run + 1)});
  columns.push_back({"row_in_run", static_cast<double>(row_in_run)});
  if (plan.sheath_angle_rad) columns.push_back({"sheath_angle_rad", *reading.sheath_angle_rad});
  return std::make_shared<const Record>(
      Record{std::to_string(reading.run + 1), "", std::move(columns)});
}

double cycle_at(const PlannedLevels& cycle, std::size_t row, std::size_t rows) {
  if (!cycle.list.empty()) return cycle.list[row * cycle.list.size() / rows];
  const double share = rows > 1 ? static_cast<double>(row) / static_cast<double>(rows - 1) : 0;
  return std::clamp(std::round(between(cycle.range, share, false)), cycle.range.low,
                    cycle.range.high);
}

bool varies(const PlannedLevels& levels) {
  return levels.list.size() > 1 || (levels.list.empty() && levels.range.low < levels.range.high);
}

Range range_of(const PlannedLevels& levels) {
  if (levels.list.empty()) return levels.range;
  const auto [least, greatest] = std::ranges::minmax_element(levels.list);
  return {*least, *greatest};
}

std::vector<SurveyedColumn> surveyed_columns(const ExperimentPlan& plan) {
  std::vector<SurveyedColumn> columns{{"motor_tension_N", range_of(plan.motor_tension_N)}};
  const auto add = [&](const std::string& name, const std::optional<PlannedLevels>& levels) {
    if (levels) columns.push_back({name, range_of(*levels)});
  };
  add("speed_mm_s", plan.speed_mm_s);
  add("cycle", plan.cycle);
  add("temperature_C", plan.temperature_C);
  add("sheath_angle_rad", plan.sheath_angle_rad);
  for (const PlannedColumn& column : plan.columns) add(column.name, column.levels);
  columns.push_back({"order", {0, 1}});
  columns.push_back({"run", {1, static_cast<double>(plan.runs)}});
  columns.push_back({"row_in_run", {1, static_cast<double>(plan.rows * plan.repeats)}});
  return columns;
}

void require_channels(const ExperimentPlan& plan) {
  for (const Segment& channel : plan.channels) {
    const bool found = std::ranges::any_of(plan.routings, [&](const PlannedRouting& routing) {
      return find_segment(routing.network, channel).has_value();
    });
    if (!found) {
      throw InputError(
          {.where = "channels",
           .what = fmt::format("'{}': no routing has that segment", segment_name(channel))});
    }
  }
  for (const PlannedRouting& routing : plan.routings) {
    const bool measured = std::ranges::any_of(plan.channels, [&](const Segment& channel) {
      return find_segment(routing.network, channel).has_value();
    });
    if (!measured) {
      throw InputError({.where = "channels",
                        .what = fmt::format("none of them is a segment of {}", routing.label),
                        .expected = "at least one for each routing"});
    }
  }
}

}  // namespace

void validate(const ExperimentPlan& plan) {
  if (plan.runs < plan.routings.size()) {
    throw InputError({.what = "runs",
                      .value = std::to_string(plan.runs),
                      .expected = fmt::format("at least {}, one for each routing (two are better)",
                                              plan.routings.size()),
                      .form = InputForm::equals});
  }
  if (plan.runs > max_planned_readings / plan.rows ||
      plan.runs * plan.rows > max_planned_readings / plan.repeats) {
    throw InputError({.what = fmt::format("runs = {}, of {} rows and {} repeats", plan.runs,
                                          plan.rows, plan.repeats),
                      .expected = fmt::format("{} readings at most", max_planned_readings)});
  }
  if (plan.cycle && !std::ranges::is_sorted(plan.cycle->list)) {
    throw InputError({.what = "cycles", .expected = "a list that rises"});
  }
  require_channels(plan);
}

std::vector<PlannedReading> schedule(const ExperimentPlan& plan, std::uint64_t seed) {
  std::vector<PlannedReading> readings;
  readings.reserve(plan.runs * plan.rows * plan.repeats);
  const RunPlanner of_runs = RunPlanner::of_runs(plan, seed);
  for (std::size_t run = 0; run < plan.runs; ++run) {
    PlannedReading reading;
    reading.run = run;
    reading.routing = run % plan.routings.size();
    const std::vector<Grasp>& grasps = plan.routings[reading.routing].grasps;
    const RunPlanner planner(plan, seed, run);
    const std::vector<std::size_t> motions =
        planner.levels(Factor::grasp, grasps.size() * plan.directions.size());
    const auto values = [&](Factor factor, const std::optional<PlannedLevels>& levels,
                            bool logarithmic) {
      return levels ? planner.values(factor, *levels, logarithmic) : std::vector<double>{};
    };
    const std::vector<double> tensions =
        planner.values(Factor::motor_tension, plan.motor_tension_N);
    const std::vector<double> speeds = values(Factor::speed, plan.speed_mm_s, true);
    const std::vector<double> temperatures = values(Factor::temperature, plan.temperature_C, false);
    const std::vector<double> angles = values(Factor::sheath_angle, plan.sheath_angle_rad, false);
    const ColumnValues columns = column_values(plan, planner, of_runs);
    for (std::size_t row = 0; row < plan.rows; ++row) {
      reading.columns.clear();
      for (std::size_t c = 0; c < columns.size(); ++c) {
        reading.columns.push_back(columns[c][plan.columns[c].by_run ? run : row]);
      }
      reading.grasp = grasps[motions[row] % grasps.size()];
      reading.direction = plan.directions[motions[row] / grasps.size()];
      Conditions& conditions = reading.conditions;
      conditions.motor_tension_N = tensions[row];
      if (plan.speed_mm_s) conditions.speed_mm_s = speeds[row];
      if (plan.temperature_C) conditions.temperature_C = temperatures[row];
      if (plan.sheath_angle_rad) reading.sheath_angle_rad = angles[row];
      if (plan.cycle) {
        conditions.cycle = cycle_at(*plan.cycle, run * plan.rows + row, plan.runs * plan.rows);
      }
      for (reading.repeat = 0; reading.repeat < plan.repeats; ++reading.repeat) {
        readings.push_back(reading);
      }
    }
  }
  for (std::size_t i = 0; i < readings.size(); ++i) {
    PlannedReading& reading = readings[i];
    if (i > 0) {
      reading.conditions.order = static_cast<double>(i) / static_cast<double>(readings.size() - 1);
    }
    reading.conditions.record = record_of(plan, reading, i % (plan.rows * plan.repeats) + 1);
  }
  return readings;
}

Survey survey(const ExperimentPlan& plan) {
  Survey survey;
  for (const PlannedRouting& routing : plan.routings) {
    survey.routings.push_back({routing.word, &routing.network, routing.grasps});
  }
  survey.channels = plan.channels;
  survey.wide_channels = plan.channels;
  survey.has_speed = plan.speed_mm_s.has_value();
  survey.has_cycle = plan.cycle.has_value();
  survey.has_temperature = plan.temperature_C.has_value();
  survey.has_motor_tension = true;
  survey.reads_below_zero = true;  // the rig's sensors; in the file they are clipped
  survey.has_both_directions = plan.directions.size() > 1;
  survey.runs = plan.runs;
  survey.columns = surveyed_columns(plan);
  survey.sheath_angle_varies = plan.sheath_angle_rad && varies(*plan.sheath_angle_rad);
  return survey;
}

}  // namespace reeve::diagnosis
