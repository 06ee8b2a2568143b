#include "studies/diagnosis_study.hpp"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "readings/row_order.hpp"
#include "search/enumerate/generator.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/rank/ranking.hpp"

namespace reeve::studies {
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
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : catalogue.entries) {
    if (finger_count(entry.routing) != fingers) continue;
    designs.push_back({entry.word, evaluator.evaluate(entry.routing)});
    names.push_back(entry.name);
  }
  std::vector<std::string> ordered;
  for (const RankedDesign& ranked : rank(std::move(designs), Order{})) {
    ordered.push_back(names[ranked.given]);
  }
  return ordered;
}

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
  } catch (const OutOfRange&) {
    return std::nullopt;  // fitted to extreme readings, the model has no tensions in some routing
  }
}

}  // namespace

bool is_bench(const MeasuredData& data) {
  return std::ranges::all_of(
             data.routings,
             [](const MeasuredRouting& measured) { return measured.network.fingers < 2; }) &&
         std::ranges::all_of(data.readings,
                             [](const Reading& reading) { return reading.grasp.held == 0; });
}

std::optional<DiagnosisReport> diagnosis_study(DiagnosisRequest request,
                                               const Catalogue& catalogue) {
  const auto start = std::chrono::steady_clock::now();
  DiagnosisReport report;
  report.data = in_order_of_contents(std::move(request.data));
  report.hardware = std::move(request.hardware);
  report.settings = request.settings;
  report.with_generated = request.with_generated;
  for (const CatalogueEntry& entry : catalogue.entries) report.names[entry.word] = entry.name;
  DiagnoseOptions options;
  static_cast<DiagnosisSettings&>(options) = request.settings;
  options.threads = request.threads;
  options.routings = measurable_routings(report.data, catalogue, request.with_generated);
  options.stage = std::move(request.stage);
  options.stop = request.stop;
  auto result = diagnose_until(report.data, report.hardware, options);
  if (!result) return std::nullopt;
  report.result = std::move(*result);
  if (!is_bench(report.data)) {
    report.ranking = catalogue_ranking(report.hardware, report.result.model, catalogue);
  }
  report.published = published_models(catalogue, report.data, report.result);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

std::optional<SolvedRouting> next_routing(const DiagnosisReport& report,
                                          const Catalogue& catalogue) {
  if (!report.result.next_measurement) return std::nullopt;
  const Measurement& at = report.result.next_measurement->measurement;
  Model model = report.result.model;
  model.conditions = at.conditions;
  try {
    return solved_routing(at.routing.routing, model, {{at.grasp, 1}}, at.direction, catalogue);
  } catch (const OutOfRange&) {
    return std::nullopt;
  }
}

}  // namespace reeve::studies
