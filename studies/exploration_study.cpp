#include "studies/exploration_study.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "core/canonical.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/exploration_part.hpp"
#include "search/rank/equivalent.hpp"

namespace reeve::studies {
namespace {

// Some 100 MB of log.
constexpr std::uint64_t most_at_a_time = 300000;

std::vector<std::string> names_of(const std::vector<Routing>& routings,
                                  const Catalogue& catalogue) {
  std::vector<std::string> names;
  for (const Routing& routing : routings) names.push_back(name_of(catalogue, routing));
  return names;
}

// Returns the bands of the known routings that are not among the listed designs. The list is
// parallel to the known routings, empty for the others.
std::optional<std::vector<Bands>> bands_of_unlisted(const ExploreResult& result,
                                                    const ExploreOptions& options,
                                                    const UncertaintyOptions& uncertainty,
                                                    const StudySupervision& supervision) {
  std::vector<Routing> unlisted;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < options.references.size(); ++i) {
    if (result.references[i].rank > 0) continue;
    unlisted.push_back(options.references[i]);
    places.push_back(i);
  }
  const bool with_hand = DesignEvaluator(uncertainty.nominal, uncertainty.grasps).has_hand();
  auto bands = drawn_bands(unlisted, friction_objectives(with_hand), uncertainty,
                           [&](std::uint64_t draw) { return draw_model(uncertainty, draw); },
                           {{}, supervision.stop});
  if (!bands) return std::nullopt;
  std::vector<Bands> all(options.references.size());
  for (std::size_t k = 0; k < places.size(); ++k) all[places[k]] = std::move((*bands)[k]);
  return all;
}

ExploreReport with_distributions(const ExploreOptions& options, ExploreResult result,
                                 const std::optional<UncertaintyOptions>& uncertainty,
                                 const Catalogue& catalogue, const StudySupervision& supervision) {
  std::optional<DrawnDesigns> drawn;
  std::optional<std::vector<Bands>> unlisted;
  const bool draws = uncertainty && !result.partial;
  if (draws) {
    drawn = drawn_designs(result.routings, *uncertainty, supervision.during("drawing"));
    if (drawn) unlisted = bands_of_unlisted(result, options, *uncertainty, supervision);
  }
  const bool draws_stopped = draws && !unlisted;
  if (draws_stopped) drawn.reset();
  ExploreReport report =
      explore_report(options, std::move(result), drawn.value_or(DrawnDesigns{}), catalogue);
  report.uncertainty = uncertainty;
  report.draws_stopped = draws_stopped;
  report.reference_bands = std::move(unlisted).value_or(std::vector<Bands>{});
  for (std::size_t i = 0; i < report.reference_bands.size(); ++i) {
    for (const ListedDesign& design : listed_designs(report)) {
      if (design.ranked.design.word != report.result.references[i].design.word) continue;
      report.reference_bands[i] = design.bands;
    }
  }
  return report;
}

// The drawing shows a smallest grasp that jams: with one held finger fewer it would not jam.
std::optional<SolvedRouting> jammed_first(const ExploreReport& report, const Catalogue& catalogue) {
  const std::vector<ListedDesign>& listed = listed_designs(report);
  if (listed.empty() || listed.front().smallest_jams.empty()) return std::nullopt;
  const GraspSet grasp{{listed.front().smallest_jams.front(), 1}};
  return solved_routing(listed.front().routing, report.options.model, grasp, Direction::pull,
                        catalogue);
}

}  // namespace

Checkpoint checkpoint_in(ExplorationStore& store, std::chrono::seconds every) {
  using Clock = std::chrono::steady_clock;
  Checkpoint checkpoint;
  checkpoint.before = store.record();
  if (store.keep() == Keep::all) {
    checkpoint.design = [&store](const EvaluatedDesign& design) { store.add(design); };
  }
  checkpoint.is_due = [&store, every, last = Clock::now()]() mutable {
    const bool is_due = Clock::now() - last >= every || store.added_since_save() >= most_at_a_time;
    if (is_due) last = Clock::now();
    return is_due;
  };
  checkpoint.save = [&store](ExplorationPart& so_far) { store.save(so_far); };
  return checkpoint;
}

std::vector<Routing> known_routings(const ExploreOptions& options, const Catalogue& catalogue) {
  std::vector<Routing> routings;
  DesignEvaluator evaluator(options.model, options.grasps);
  for (const CatalogueEntry& entry : catalogue.entries) {
    if (finger_count(entry.routing) != options.generator.fingers) continue;
    const Routing routing = canonical(entry.routing, options.generator.identity);
    if (evaluator.has_tensions(routing)) routings.push_back(routing);
  }
  return routings;
}

const std::vector<ListedDesign>& listed_designs(const ExploreReport& report) {
  return report.front.size() > report.top.size() ? report.front : report.top;
}

std::size_t distinct_on_front(const ExploreReport& report) {
  std::set<std::vector<double>> sets;
  for (const ListedDesign& design : report.front) {
    std::vector<double> set;
    for (const Objective objective : report.options.order.objectives) {
      set.push_back(value(design.ranked.design.values, objective));
    }
    sets.insert(std::move(set));
  }
  return sets.size();
}

ExploreReport explore_report(const ExploreOptions& options, ExploreResult result,
                             const DrawnDesigns& drawn, const Catalogue& catalogue) {
  ExploreReport report;
  report.options = options;
  const bool front_is_longer = result.front.size() > result.top.size();
  std::vector<RankedDesign>& ranked = front_is_longer ? result.front : result.top;
  std::vector<RankedDesign>& first = front_is_longer ? result.top : result.front;
  const std::vector<std::size_t> equivalent =
      first_equivalent(ranked, result.routings, options.order, options.generator.identity);
  const std::vector<std::size_t> shared = places(ranked, options.order);
  const auto listed = [&](std::vector<RankedDesign> designs, std::vector<Routing> routings) {
    std::vector<ListedDesign> list =
        list_designs(std::move(designs), std::move(routings), drawn, options.model, catalogue);
    mark_equivalent(list, equivalent);
    mark_places(list, shared);
    return list;
  };
  const auto end_of_first = result.routings.begin() + static_cast<std::ptrdiff_t>(first.size());
  std::vector<ListedDesign>& shorter = front_is_longer ? report.top : report.front;
  std::vector<ListedDesign>& longer = front_is_longer ? report.front : report.top;
  shorter = listed(std::move(first), {result.routings.begin(), end_of_first});
  longer = listed(std::move(ranked), std::move(result.routings));
  report.robust_first = robust_first(longer, options.order);
  report.tradeoff = list_tradeoff(result.tradeoff, longer, options.order, options.model,
                                  options.prices, catalogue);
  add_bars(report.tradeoff, {options.model, options.grasps, options.score, options.prices},
           catalogue);
  report.jammed_first = jammed_first(report, catalogue);
  report.reference_names = names_of(options.references, catalogue);
  report.result = std::move(result);
  return report;
}

ExploreReport planned_report(const ExploreOptions& options,
                             const std::optional<UncertaintyOptions>& uncertainty,
                             const Catalogue& catalogue) {
  ExploreReport report;
  report.options = options;
  report.uncertainty = uncertainty;
  report.reference_names = names_of(options.references, catalogue);
  return report;
}

ExploreReport exploration_study(const ExploreOptions& options,
                                const std::optional<UncertaintyOptions>& uncertainty,
                                const Catalogue& catalogue, const StudySupervision& supervision,
                                const Checkpoint& checkpoint, const Searcher& search) {
  return with_distributions(options,
                            explore(options, supervision.during("exploring"), checkpoint, search),
                            uncertainty, catalogue, supervision);
}

ExploreReport merged_study(const ExploreOptions& options,
                           const std::optional<UncertaintyOptions>& uncertainty,
                           const std::vector<ShardRecord>& shards, const Catalogue& catalogue,
                           const StudySupervision& supervision) {
  return with_distributions(options, conclude(shards, options, supervision.during("exploring")),
                            uncertainty, catalogue, supervision);
}

std::vector<ListedDesign> designs_to_sweep(const ExploreReport& report) {
  std::vector<ListedDesign> chosen;
  const auto add = [&](const ListedDesign& design) {
    const std::string& word = design.ranked.design.word;
    const bool is_there = std::ranges::any_of(
        chosen, [&](const ListedDesign& other) { return other.ranked.design.word == word; });
    if (!is_there && design.same_as.empty() && chosen.size() < most_swept) chosen.push_back(design);
  };
  if (!report.top.empty()) add(report.top.front());
  if (report.tradeoff.affordable) add(*report.tradeoff.affordable);
  for (const ListedDesign& step : report.tradeoff.steps) add(step);
  for (const ListedDesign& design : report.front) add(design);
  return chosen;
}

void add_sweep(ExploreReport& report, const SweepOptions& options,
               const StudySupervision& supervision) {
  report.sweep_over = options.over;
  if (report.result.partial || report.draws_stopped) return;
  report.sweep = swept_designs(designs_to_sweep(report), options, supervision);
}

void add_motor(ExploreReport& report, const UncertaintyOptions& drawn) {
  if (report.result.partial || listed_designs(report).empty()) return;
  report.motor = motor_force(listed_designs(report).front().routing, drawn);
}

}  // namespace reeve::studies
