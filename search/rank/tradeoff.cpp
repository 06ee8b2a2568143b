#include "search/rank/tradeoff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "search/rank/pareto.hpp"

namespace reeve::search {
namespace {

Order with_measure(const Order& order, Objective by) {
  std::vector<Objective> objectives = ranked_by(order);
  if (std::find(objectives.begin(), objectives.end(), by) == objectives.end()) {
    objectives.push_back(by);
  }
  return {std::move(objectives), order.by_score};
}

// Far below anything that can be measured: a loss of exactly `within` is within it.
constexpr double rounding = 1e-9;

double greatest_loss(const ObjectiveValues& values, const Tradeoff& tradeoff) {
  double greatest = -std::numeric_limits<double>::infinity();
  for (const Objective objective : tradeoff.objectives) {
    greatest = std::max(greatest, loss(objective, values, tradeoff.first.values));
  }
  return greatest;
}

// Adds a design to the front unless it is dominated, and removes those that it dominates.
void admit(const Design& design, const std::vector<Objective>& objectives,
           std::vector<Design>& front) {
  const Goodness worth = goodness(design.values, objectives);
  const bool dominated = std::any_of(front.begin(), front.end(), [&](const Design& other) {
    return dominates(goodness(other.values, objectives), worth);
  });
  if (dominated) return;
  std::erase_if(front, [&](const Design& other) {
    return dominates(worth, goodness(other.values, objectives));
  });
  front.push_back(design);
}

void add_steps(const std::vector<Design>& candidates, const Order& order, Tradeoff& tradeoff) {
  std::vector<Design> front;
  for (std::size_t i = 0; i < candidates.size();) {
    const double at_most = value(candidates[i].values, tradeoff.options.by);
    for (; i < candidates.size() && value(candidates[i].values, tradeoff.options.by) == at_most;
         ++i) {
      admit(candidates[i], order.objectives, front);
    }
    const Design& best = *std::min_element(
        front.begin(), front.end(),
        [&](const Design& a, const Design& b) { return precedes_within_front(a, b, order); });
    if (!tradeoff.steps.empty() && tradeoff.steps.back().design.word == best.word) continue;
    tradeoff.steps.push_back(
        {at_most, best, on_grid(std::clamp(1 - greatest_loss(best.values, tradeoff), 0.0, 1.0))});
  }
}

std::optional<std::size_t> knee(const std::vector<TradeoffStep>& steps) {
  if (steps.size() < 3) return std::nullopt;
  const TradeoffStep& low = steps.front();
  const TradeoffStep& high = steps.back();
  if (high.kept <= low.kept) return std::nullopt;
  std::optional<std::size_t> highest;
  double height = rounding;
  for (std::size_t i = 1; i + 1 < steps.size(); ++i) {
    const double x = (steps[i].at_most - low.at_most) / (high.at_most - low.at_most);
    const double y = (steps[i].kept - low.kept) / (high.kept - low.kept);
    if (y - x <= height) continue;
    height = y - x;
    highest = i;
  }
  return highest;
}

// Returns the candidates of both kinds that none of the other kind matches or beats, either.
std::vector<Design> undominated(const std::vector<Design>& candidates, const Order& order,
                                Objective by) {
  Archive front(with_measure(order, by), 1);
  for (const Design& design : candidates) front.add(design);
  std::vector<Design> designs;
  for (RankedDesign& ranked : front.content().ranked) designs.push_back(std::move(ranked.design));
  return designs;
}

void sort_by_measure(std::vector<Design>& designs, Objective by) {
  std::sort(designs.begin(), designs.end(), [&](const Design& a, const Design& b) {
    const double measure = value(a.values, by);
    const double other = value(b.values, by);
    return measure != other ? measure < other : a.word < b.word;
  });
}

bool has_blocks(const Design& design) { return value(design.values, Objective::blocks) > 0; }

// Returns the candidates with the least measure that lose no more than `within`. The candidates are
// in order of the measure.
std::vector<Design> cheapest_within(const std::vector<Design>& candidates,
                                    const Tradeoff& tradeoff) {
  std::vector<Design> cheapest;
  for (const Design& design : candidates) {
    const double measure = value(design.values, tradeoff.options.by);
    if (!cheapest.empty() && measure > value(cheapest.front().values, tradeoff.options.by)) break;
    if (!is_within(design.values, tradeoff)) continue;
    cheapest.push_back(design);
  }
  return cheapest;
}

Design first_of(std::vector<Design> designs, const Order& order) {
  return rank(std::move(designs), order).front().design;
}

std::optional<Design> affordable(const std::vector<Design>& candidates, const Order& order,
                                 const Tradeoff& tradeoff) {
  std::vector<Design> cheapest = cheapest_within(candidates, tradeoff);
  const auto measure = [&](const Design& design) {
    return value(design.values, tradeoff.options.by);
  };
  if (cheapest.empty() || measure(cheapest.front()) >= measure(tradeoff.first)) return std::nullopt;
  return first_of(std::move(cheapest), order);
}

// Chooses among candidates of one kind; there is at least one.
Design chosen(std::vector<Design> candidates, const Order& order, const Tradeoff& tradeoff) {
  std::vector<Design> cheapest = cheapest_within(candidates, tradeoff);
  return first_of(cheapest.empty() ? std::move(candidates) : std::move(cheapest), order);
}

std::optional<BlockChoice<Design>> block_choice(const std::vector<Design>& candidates,
                                                const Order& order, const Tradeoff& tradeoff) {
  std::vector<Design> with;
  std::vector<Design> without;
  for (const Design& design : candidates) (has_blocks(design) ? with : without).push_back(design);
  if (with.empty() || without.empty()) return std::nullopt;
  return BlockChoice<Design>{chosen(std::move(without), order, tradeoff),
                             chosen(std::move(with), order, tradeoff)};
}

}  // namespace

TradeoffArchive::TradeoffArchive(const Order& order, Objective by)
    : without_blocks_(with_measure(order, by), 1), with_blocks_(with_measure(order, by), 1) {}

const Archive& TradeoffArchive::front_of(const ObjectiveValues& values) const {
  return value(values, Objective::blocks) > 0 ? with_blocks_ : without_blocks_;
}

void TradeoffArchive::add(Design design) {
  Archive& front = has_blocks(design) ? with_blocks_ : without_blocks_;
  front.add(std::move(design));
}

std::vector<Design> TradeoffArchive::candidates() {
  std::vector<Design> designs;
  for (Archive* front : {&without_blocks_, &with_blocks_}) {
    for (RankedDesign& ranked : front->content().ranked) {
      designs.push_back(std::move(ranked.design));
    }
  }
  return designs;
}

std::vector<Objective> ranked_by(const Order& order) {
  std::vector<Objective> objectives = order.objectives;
  const bool has_score =
      std::find(objectives.begin(), objectives.end(), Objective::score) != objectives.end();
  if (order.by_score && !has_score) objectives.push_back(Objective::score);
  return objectives;
}

double loss(Objective objective, const ObjectiveValues& values, const ObjectiveValues& first) {
  const double best = value(first, objective);
  const double given = value(values, objective);
  if (given == best) return 0;
  const double worse = row(objective).better == Better::higher ? best - given : given - best;
  if (best != 0) return on_grid(worse / std::abs(best));
  return worse > 0 ? std::numeric_limits<double>::infinity()
                   : -std::numeric_limits<double>::infinity();
}

bool is_within(const ObjectiveValues& values, const Tradeoff& tradeoff) {
  return greatest_loss(values, tradeoff) <= tradeoff.options.within + rounding;
}

Tradeoff tradeoff(std::vector<Design> candidates, const Design& first, const Order& order,
                  const TradeoffOptions& options) {
  Tradeoff result{options, ranked_by(order), {}, first, std::nullopt, std::nullopt};
  sort_by_measure(candidates, options.by);
  result.choice = block_choice(candidates, order, result);
  candidates = undominated(candidates, order, options.by);
  sort_by_measure(candidates, options.by);
  add_steps(candidates, order, result);
  result.knee = knee(result.steps);
  result.affordable = affordable(candidates, order, result);
  return result;
}

const std::vector<std::string>& tradeoff_measures() {
  static const std::vector<std::string> names{"sheaths", "blocks", "pulleys", "parts", "cost"};
  return names;
}

double parse_within(const std::string& text) {
  const std::string_view whole = trimmed(text);
  const bool in_percent = whole.ends_with('%');
  const auto percent = number_in(trimmed(whole.substr(0, whole.size() - (in_percent ? 1 : 0))));
  if (!in_percent || !percent || *percent < 0 || *percent >= 100) {
    throw InputError({.what = "within",
                      .value = text,
                      .expected = "a loss in percent, from 0% to below 100%, such as 2%"});
  }
  return *percent / 100;
}

}  // namespace reeve::search
