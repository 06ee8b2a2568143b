#include "reports/simulation_report.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "causes/named_effect.hpp"
#include "readings/csv.hpp"
#include "reports/data_text.hpp"
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
      held_field(reading.grasp), direction_field(reading.direction), conditions.motor_tension_N);
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

const char* meaning(Finding finding, bool hides_nothing) {
  if (hides_nothing && finding == Finding::found) return "rightly, no cause is named";
  if (hides_nothing && finding == Finding::wrong) return "a cause is named";
  // In the order of Finding.
  constexpr std::array meanings{
      "all that is hidden is named, no more", "others are named, or not all", "no cause is named",
      "structure is left that no cause explains", "causes explain the data alike"};
  return meanings.at(static_cast<std::size_t>(finding));
}

// Returns the named causes, and the groups that cannot be told apart.
std::string named_text(const PowerTrial& trial) {
  std::string text = fmt::format("{}", fmt::join(trial.named, ", "));
  for (const std::vector<std::string>& group : trial.indistinguishable) {
    text += fmt::format("{}{}", text.empty() ? "" : "; ", fmt::join(group, " or "));
  }
  return text.empty() ? "nothing" : text;
}

Section others_section(const PowerReport& report) {
  constexpr std::size_t most = 10;
  Section section{"Not found, and what was named", std::nullopt, {}};
  std::size_t listed = 0;
  std::size_t others = 0;
  for (const PowerTrial& trial : report.trials) {
    if (trial.finding == Finding::found) continue;
    if (++others > most) continue;
    ++listed;
    section.lines.push_back({fmt::format("  seed {}: {}: {}", trial.seed,
                                         finding_name(trial.finding), named_text(trial))});
  }
  if (others > listed) section.lines.push_back({fmt::format("  … {} more", others - listed)});
  return section;
}

}  // namespace

std::string hidden_text(const Model& model) {
  if (model.effects.empty()) return "no cause";
  return joined(model.effects, ", ",
                [&](const Effect& effect) { return hidden_effect_text(effect, model.hardware); });
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

Document power_sheet(const PowerReport& report) {
  const SimulationReport& experiment = report.experiment;
  const bool hides_nothing = experiment.model.effects.empty();
  const std::string opening = fmt::format("{} simulated experiments, seeds {} to {}, with {}",
                                          report.trials.size(), report.trials.front().seed,
                                          report.trials.back().seed, hidden_text(experiment.model));
  Table table{{text_column("finding"), number_column("count"), number_column("share"),
               number_column("95 % interval"), text_column("meaning")},
              {}};
  for (const FindingShare& share : finding_shares(report.trials)) {
    if (hides_nothing && share.finding == Finding::none) continue;
    table.add({finding_name(share.finding), std::to_string(share.count),
               fmt::format("{:.3f}", share.share),
               fmt::format("{:.3f} to {:.3f}", share.interval.low, share.interval.high),
               meaning(share.finding, hides_nothing)});
  }
  Document document{{{"", std::nullopt, {{opening, true}}}, {"", table, {}}}};
  document.add(others_section(report));
  return document;
}

std::string power_json(const PowerReport& report) {
  const SimulationReport& experiment = report.experiment;
  Json json{{"simulated", true}, {"experiments", report.trials.size()}};
  json["hidden"] = list_json(experiment.model.effects, [&](const Effect& effect) {
    return Json{{"cause", effect_name(effect)},
                {"size", size_text(effect, experiment.model.hardware)}};
  });
  for (const FindingShare& share : finding_shares(report.trials)) {
    json["findings"][finding_name(share.finding)] = {{"count", share.count},
                                                     {"share", share.share},
                                                     {"low", share.interval.low},
                                                     {"high", share.interval.high}};
  }
  json["trials"] = list_json(report.trials, [](const PowerTrial& trial) {
    return Json{{"seed", trial.seed},
                {"finding", finding_name(trial.finding)},
                {"causes", trial.named},
                {"indistinguishable", trial.indistinguishable}};
  });
  json["settings"] = {{"command", experiment.command},
                      {"noise_relative", experiment.noise.relative},
                      {"noise_absolute_N", experiment.noise.absolute_N},
                      {"hardware", to_json(experiment.model.hardware)}};
  json["version"] = version_json();
  return print(json);
}

}  // namespace reeve::reports
