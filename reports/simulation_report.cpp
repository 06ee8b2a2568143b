#include "reports/simulation_report.hpp"

#include <fmt/format.h>

#include <iterator>

#include "causes/named_effect.hpp"
#include "readings/csv.hpp"
#include "reports/output/csv_field.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {
namespace {

using Buffer = fmt::memory_buffer;

template <typename... Values>
void put(Buffer& out, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Values>(values)...);
}

std::string hidden_effect_text(const Effect& effect, const Hardware& hardware) {
  const std::string size = size_text(effect, hardware);
  return size.empty() ? effect_name(effect) : fmt::format("{} ({})", effect_name(effect), size);
}

void put_comments(Buffer& out, const SimulationReport& report) {
  const Simulation& simulation = report.simulation;
  put(out, "# simulated by reeve {}, not measured\n", version_json());
  for (const Effect& effect : report.model.effects) {
    put(out, "# hidden cause: {}\n", hidden_effect_text(effect, report.model.hardware));
  }
  if (report.model.effects.empty()) {
    put(out, "# hidden cause: none, the model with its hardware as given\n");
  }
  for (const PlannedRouting& routing : report.plan.routings) {
    if (routing.label != routing.word) put(out, "# {} is {}\n", routing.label, routing.word);
  }
  put(out, "# noise: standard deviation {} of the tension, and {} N\n", report.noise.relative,
      report.noise.absolute_N);
  if (report.noise.motor_relative > 0) {
    put(out, "# noise of the motor tension: standard deviation {} of it\n",
        report.noise.motor_relative);
  }
  if (simulation.clipped > 0) {
    put(out, "# clipped: {} of {} values would have been below 0 and are 0\n", simulation.clipped,
        simulation.values);
  }
  put(out, "# seed: {}\n# command: {}\n", report.seed, one_line(report.command));
}

void put_header(Buffer& out, const ExperimentPlan& plan) {
  put(out, "run,routing,held,direction,motor_tension_N");
  if (plan.speed_mm_s) put(out, ",speed_mm_s");
  if (plan.cycle) put(out, ",cycle");
  if (plan.temperature_C) put(out, ",temperature_C");
  if (plan.sheath_angle_rad) put(out, ",sheath_angle_rad");
  for (const PlannedColumn& column : plan.columns) put(out, ",{}", csv_field(column.name));
  for (const Segment& channel : plan.channels) {
    const std::string name = segment_name(channel);
    put(out, ",{}{}_N", channel.kind == SegmentKind::strand ? "" : "T", name);
  }
  put(out, "{}\n", plan.repeats > 1 ? ",repeat" : "");
}

void put_row(Buffer& out, const ExperimentPlan& plan, const PlannedReading& reading,
             const std::vector<std::optional<double>>& tensions) {
  const Conditions& conditions = reading.conditions;
  put(out, "{},{},{},{},{}", reading.run + 1, csv_field(plan.routings[reading.routing].label),
      fmt::join(held_fingers(reading.grasp), ";"),
      reading.direction == Direction::pull ? "pull" : "release", conditions.motor_tension_N);
  if (plan.speed_mm_s) put(out, ",{}", conditions.speed_mm_s);
  if (plan.cycle) put(out, ",{}", conditions.cycle);
  if (plan.temperature_C) put(out, ",{}", conditions.temperature_C);
  if (plan.sheath_angle_rad) put(out, ",{}", *reading.sheath_angle_rad);
  for (const double value : reading.columns) put(out, ",{}", value);
  for (const std::optional<double>& tension : tensions) {
    put(out, ",");
    if (tension) put(out, "{:.6g}", *tension);
  }
  if (plan.repeats > 1) put(out, ",{}", reading.repeat + 1);
  put(out, "\n");
}

}  // namespace

std::string hidden_text(const Model& model) {
  std::string text;
  for (const Effect& effect : model.effects) {
    text += (text.empty() ? "" : ", ") + hidden_effect_text(effect, model.hardware);
  }
  return text.empty() ? "no cause" : text;
}

std::string simulation_csv(const SimulationReport& report) {
  Buffer out;
  put_comments(out, report);
  put_header(out, report.plan);
  for (std::size_t i = 0; i < report.simulation.readings.size(); ++i) {
    put_row(out, report.plan, report.simulation.readings[i], report.simulation.tension_N[i]);
  }
  return fmt::to_string(out);
}

std::string simulation_summary(const SimulationReport& report, const std::string& file) {
  const std::size_t routings = report.plan.routings.size();
  return fmt::format("{}: {} simulated readings in {} runs of {} routing{}, with {}\n", file,
                     report.simulation.readings.size(), report.plan.runs, routings,
                     routings == 1 ? "" : "s", hidden_text(report.model));
}

}  // namespace reeve::reports
