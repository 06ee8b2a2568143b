#include "reports/power_report.hpp"

#include <fmt/format.h>

#include "causes/named_effect.hpp"
#include "reports/output/json.hpp"
#include "reports/simulation_report.hpp"

namespace reeve::reports {
namespace {

const char* meaning(Finding finding, bool hides_nothing) {
  switch (finding) {
    case Finding::found:
      return hides_nothing ? "rightly, no cause is named" : "all that is hidden is named, no more";
    case Finding::wrong:
      return hides_nothing ? "a cause is named" : "others are named, or not all";
    case Finding::none:
      return "no cause is named";
    case Finding::unexplained:
      return "structure is left that no cause explains";
    case Finding::indistinguishable:
      return "causes explain the data alike";
  }
  return "";
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
