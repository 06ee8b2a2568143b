#include "studies/listed_design.hpp"

#include <map>
#include <string_view>
#include <utility>

#include "core/bars.hpp"
#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"

namespace reeve::studies {
namespace {

std::optional<ListedDesign> first_that_never_jams(const std::vector<ListedDesign>& listed,
                                                  const Order& order) {
  std::vector<Design> designs;
  std::vector<const ListedDesign*> listed_as;
  for (const ListedDesign& design : listed) {
    if (value(design.ranked.design.values, Objective::jams_all) > 0) continue;
    designs.push_back(design.ranked.design);
    listed_as.push_back(&design);
  }
  if (designs.empty()) return std::nullopt;
  return *listed_as[rank(std::move(designs), order).front().given];
}

double low_quantile(const ListedDesign& design) {
  if (design.decisive) return design.decisive->low;
  const ObjectiveValues& values = design.ranked.design.values;
  return value(values, Objective::uniformity_p5) * value(values, Objective::efficiency_p5);
}

}  // namespace

std::vector<ListedDesign> list_designs(std::vector<RankedDesign> ranked,
                                       std::vector<Routing> routings, const DrawnDesigns& drawn,
                                       const Model& model, const Catalogue& catalogue) {
  DesignEvaluator evaluator(model, {});
  std::vector<ListedDesign> designs;
  designs.reserve(ranked.size());
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    std::string name = name_of(catalogue, routings[i]);
    std::vector<Grasp> smallest_jams = evaluator.smallest_jams(routings[i]);
    designs.push_back(
        {std::move(ranked[i]), std::move(routings[i]), std::move(name), std::nullopt});
    designs.back().smallest_jams = std::move(smallest_jams);
    if (!drawn.ranks.empty()) designs.back().distribution = drawn.ranks[i];
    if (!drawn.bands.empty()) designs.back().bands = drawn.bands[i];
    if (!drawn.decisive.empty()) designs.back().decisive = drawn.decisive[i];
    if (!drawn.constraints_met.empty()) designs.back().constraints_met = drawn.constraints_met[i];
  }
  return designs;
}

void mark_places(std::vector<ListedDesign>& designs, const std::vector<std::size_t>& places) {
  for (std::size_t i = 0; i < designs.size(); ++i) designs[i].place = places[i];
}

void mark_equivalent(std::vector<ListedDesign>& designs, const std::vector<std::size_t>& firsts) {
  for (std::size_t i = 0; i < designs.size(); ++i) {
    if (firsts[i] == i) continue;
    ListedDesign& first = designs[firsts[i]];
    designs[i].same_as = first.ranked.design.word;
    first.equivalent.push_back(designs[i].ranked.design.word);
  }
}

std::optional<RobustFirst> robust_first(const std::vector<ListedDesign>& designs,
                                        const Order& order) {
  if (designs.empty()) return std::nullopt;
  const bool over_draws = designs.front().decisive.has_value();
  if (order.by_score && !over_draws) return std::nullopt;
  const ListedDesign* robust = &designs.front();
  for (const ListedDesign& design : designs) {
    if (low_quantile(design) > low_quantile(*robust)) robust = &design;
  }
  const auto as_robust = [&](const ListedDesign& design) {
    return RobustDesign{design, decisive_value(design.ranked.design.values, order),
                        low_quantile(design)};
  };
  return RobustFirst{as_robust(designs.front()), as_robust(*robust), order.by_score, over_draws};
}

ListedTradeoff list_tradeoff(const Tradeoff& tradeoff, const std::vector<ListedDesign>& listed,
                             const Order& order, const Model& model,
                             const std::optional<PartPrices>& prices, const Catalogue& catalogue) {
  DesignEvaluator evaluator(model, {});
  std::map<std::string_view, const ListedDesign*> by_word;
  for (const TradeoffStep& step : tradeoff.steps) by_word[step.design.word] = nullptr;
  if (tradeoff.affordable) by_word[tradeoff.affordable->word] = nullptr;
  if (tradeoff.choice) {
    by_word[tradeoff.choice->without.word] = nullptr;
    by_word[tradeoff.choice->with.word] = nullptr;
  }
  for (const ListedDesign& design : listed) {
    const auto found = by_word.find(design.ranked.design.word);
    if (found != by_word.end()) found->second = &design;
  }
  const auto as_listed = [&](const Design& design) -> ListedDesign {
    const ListedDesign* found = by_word.at(design.word);
    if (found != nullptr) return *found;
    const Routing routing = parse_routing(design.word);
    ListedDesign unlisted{{design}, routing, name_of(catalogue, routing), std::nullopt};
    unlisted.smallest_jams = evaluator.smallest_jams(routing);
    return unlisted;
  };
  ListedTradeoff result;
  result.tradeoff = tradeoff;
  result.cost_unit = prices ? prices->unit : "";
  for (const TradeoffStep& step : tradeoff.steps) result.steps.push_back(as_listed(step.design));
  if (tradeoff.affordable) result.affordable = as_listed(*tradeoff.affordable);
  if (tradeoff.choice) {
    result.choice = {as_listed(tradeoff.choice->without), as_listed(tradeoff.choice->with)};
  }
  result.never_jams = first_that_never_jams(listed, order);
  return result;
}

void add_bars(ListedTradeoff& tradeoff, const EvaluatedBy& by, const Catalogue& catalogue) {
  if (!tradeoff.choice) return;
  const std::optional<Routing> barred = with_bars(tradeoff.choice->with.routing);
  if (!barred) return;
  const Routing routing = canonical(*barred, FingerIdentity::distinct);
  DesignEvaluator evaluator(by.model, by.grasps, by.score, by.prices);
  const Design design{to_word(routing), evaluator.evaluate(routing)};
  tradeoff.with_bars = {{design}, routing, name_of(catalogue, routing), std::nullopt};
  tradeoff.with_bars->smallest_jams = evaluator.smallest_jams(routing);
}

LookAtNetworks looks_at_designs(const std::vector<ListedDesign>& designs) {
  return [&designs](ValueUse& use) {
    for (const ListedDesign& design : designs) use.look_at(expand(design.routing));
  };
}

std::optional<SweptDesigns> swept_designs(const std::vector<ListedDesign>& designs,
                                          const SweepOptions& options,
                                          const StudySupervision& supervision) {
  std::vector<Routing> routings;
  for (const ListedDesign& design : designs) routings.push_back(design.routing);
  auto swept = sweep(routings, options, supervision.during("sweeping"));
  if (!swept) return std::nullopt;
  const Coefficient over = options.over.coefficient;
  ValueUse use = value_use(options.uncertainty.nominal.hardware, over);
  looks_at_designs(designs)(use);
  return SweptDesigns{std::move(*swept), designs,
                      use.has_owners() ? left_alone(row(over).name, use) : ""};
}

}  // namespace reeve::studies
