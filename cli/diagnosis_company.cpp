#include "cli/diagnosis_company.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "catalog/model_file.hpp"
#include "core/canonical.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "core/version.hpp"
#include "diagnosis/csv.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis_words.hpp"
#include "search/evaluation.hpp"
#include "search/generator.hpp"
#include "search/ranking.hpp"
#include "studies/shown_routing.hpp"

namespace reeve::cli {
namespace {

constexpr std::size_t most_generated = 200;

std::set<int> finger_counts(const MeasuredData& data) {
  std::set<int> counts;
  for (const MeasuredRouting& measured : data.routings) {
    counts.insert(finger_count(measured.routing));
  }
  return counts;
}

void add_generated(int fingers, std::vector<MeasurableRouting>& routings) {
  GeneratorOptions options;
  options.fingers = fingers;
  options.one_tendon = true;
  RoutingGenerator generator(options);
  Routing routing;
  for (std::size_t n = 0; n < most_generated && generator.next(routing);) {
    if (!is_actuated(routing)) continue;
    routings.push_back({to_word(routing), routing});
    ++n;
  }
}

std::vector<std::string> order(const Model& model, const Catalogue& catalogue) {
  constexpr int fingers = 2;
  DesignEvaluator evaluator(model, single_grasps(fingers));
  std::vector<Design> designs;
  for (const CatalogueEntry& entry : catalogue.entries) {
    if (finger_count(entry.routing) != fingers) continue;
    designs.push_back({entry.word, evaluator.evaluate(entry.routing)});
  }
  std::vector<std::string> names;
  for (const RankedDesign& ranked : rank(std::move(designs), Order{})) {
    names.push_back(catalogue.find_word(parse_routing(ranked.design.word))->name);
  }
  return names;
}

}  // namespace

std::vector<MeasurableRouting> measurable_routings(const MeasuredData& data,
                                                   const Catalogue& catalogue, bool generated) {
  std::vector<MeasurableRouting> routings;
  const std::set<int> fingers = finger_counts(data);
  for (const CatalogueEntry& entry : catalogue.entries) {
    if (!fingers.contains(finger_count(entry.routing))) continue;
    routings.push_back({entry.word, entry.routing});
  }
  if (!generated) return routings;
  for (const int count : fingers) {
    if (count > 0) add_generated(count, routings);
  }
  return routings;
}

std::optional<CatalogueRanking> catalogue_ranking(const Hardware& plain, const Model& extended,
                                                  const Catalogue& catalogue) {
  if (extended.effects.empty()) return std::nullopt;
  Model before;
  before.hardware = plain;
  try {
    return CatalogueRanking{order(before, catalogue), order(extended, catalogue)};
  } catch (const InputError&) {
    return std::nullopt;  // fitted to extreme readings, the model has no tensions in some routing
  }
}

std::optional<ShownRouting> next_routing(const DiagnosisReport& report,
                                         const Catalogue& catalogue) {
  if (!report.result.next_measurement) return std::nullopt;
  const Measurement& at = report.result.next_measurement->measurement;
  Model model = report.result.model;
  model.conditions = at.conditions;
  try {
    return shown_routing(parse_routing(at.routing), model, {{at.grasp, 1}}, at.direction,
                         catalogue);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::string extended_model_toml(const DiagnosisReport& report,
                                const UncertaintyRanges& uncertainty) {
  const DiagnosisResult& result = report.result;
  const Version build = version();
  std::vector<std::string> lines{fmt::format("Extended by reeve {} from the readings in {}",
                                             build.number, one_line(report.data.file))};
  if (report.data.simulated) lines.push_back(fmt::format("The data are {}.", simulated_text));
  lines.push_back(fmt::format("Verdict: {}", name(result.verdict)));
  for (const NamedCause& cause : result.causes) lines.push_back(cause_text(cause));
  for (const auto& names : result.indistinguishable) {
    lines.push_back(fmt::format("The data cannot tell apart: {}", fmt::join(names, ", ")));
  }
  return model_toml(result.model, lines, uncertainty);
}

}  // namespace reeve::cli
