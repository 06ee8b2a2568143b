#include "reports/exploration/decision_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/routing.hpp"
#include "core/wearer_parts.hpp"
#include "reports/data_text.hpp"
#include "reports/jam_words.hpp"
#include "reports/motor_words.hpp"
#include "reports/shown_value.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t named_at_most = 4;

struct MeasureWords {
  Objective measure;
  const char* one;     // "sheath"; "" of what is not counted
  const char* plural;  // "sheaths"
  const char* fewest;  // "fewest sheaths"
  const char* less;    // "fewer sheaths"
};

constexpr MeasureWords measures[] = {
    {Objective::sheaths, "sheath", "sheaths", "fewest sheaths", "fewer sheaths"},
    {Objective::blocks, "floating block", "floating blocks", "fewest floating blocks",
     "fewer floating blocks"},
    {Objective::pulleys, "pulley", "pulleys", "fewest pulleys", "fewer pulleys"},
    {Objective::parts, "part", "parts", "fewest parts", "fewer parts"},
    {Objective::cost, "", "cost", "least cost", "a lower cost"}};

const MeasureWords& words_of(Objective measure) {
  return *std::find_if(std::begin(measures), std::end(measures),
                       [&](const MeasureWords& words) { return words.measure == measure; });
}

std::string value_text(Objective objective, const ObjectiveValues& values,
                       const std::string& cost_unit) {
  if (!std::isfinite(value(values, objective))) {
    return objective_heading(objective) + " infinite";
  }
  const std::string unit = shown_unit(objective_unit(objective, cost_unit));
  return fmt::format("{} {}{}{}", objective_heading(objective),
                     shown_value(objective, value(values, objective)), unit.empty() ? "" : " ",
                     unit);
}

// "uniformity 0.985 (-1.1 %)": the change against the first, whichever way is better.
std::string change_text(Objective objective, const ObjectiveValues& values,
                        const ObjectiveValues& first, const std::string& cost_unit) {
  const double before = value(first, objective);
  const double now = value(values, objective);
  std::string text = value_text(objective, values, cost_unit);
  const bool have_change = std::isfinite(before) && std::isfinite(now);
  if (before == now || before == 0 || !have_change) return text;
  return fmt::format("{} ({})", text, signed_percent((now - before) / std::abs(before)));
}

// "4 sheaths", "cost 61.90 EUR"
std::string measure_text(const ListedTradeoff& tradeoff, double amount) {
  const MeasureWords& words = words_of(tradeoff.tradeoff.options.by);
  if (*words.one != '\0') return plural(static_cast<std::size_t>(amount), words.one);
  const std::string unit = tradeoff.cost_unit.empty() ? "" : " " + tradeoff.cost_unit;
  return fmt::format("cost {}{}", shown_value(Objective::cost, amount), unit);
}

bool stays_open(const ObjectiveValues& values) {
  return has_hand(values) && value(values, Objective::closure) < 1;
}

// Returns its value of the measure, and the ranked objectives as changes against the first.
std::string values_text(const ListedTradeoff& tradeoff, const ObjectiveValues& values) {
  const Objective by = tradeoff.tradeoff.options.by;
  std::string text = measure_text(tradeoff, value(values, by));
  for (const Objective objective : tradeoff.tradeoff.objectives) {
    if (objective == by) continue;
    text +=
        ", " + change_text(objective, values, tradeoff.tradeoff.first.values, tradeoff.cost_unit);
  }
  // Nobody ranks by it, and nobody wants less than all.
  if (stays_open(values)) {
    text += fmt::format(", the hand closes to {} of its range only",
                        percent(value(values, Objective::closure)));
  }
  return text;
}

std::string first_text(const ListedDesign& first, const ListedTradeoff& tradeoff) {
  return fmt::format("Best: {}: {}{}", design_name(first),
                     values_text(tradeoff, first.ranked.design.values), equivalent_text(first));
}

// Says in which grasps the first design jams, and how good the best design is that never does.
std::string jams_text(const ListedDesign& first, const ListedTradeoff& tradeoff) {
  std::string text =
      jam_sentence(first.smallest_jams, first.ranked.design.values, expand(first.routing));
  if (first.smallest_jams.empty()) return text;
  if (!tradeoff.never_jams) return text + "; every listed design jams in some grasp";
  return fmt::format("{}; best design that never jams: {}: {}", text,
                     design_name(*tradeoff.never_jams),
                     values_text(tradeoff, tradeoff.never_jams->ranked.design.values));
}

std::string affordable_text(const ListedTradeoff& listed) {
  const Tradeoff& tradeoff = listed.tradeoff;
  const MeasureWords& words = words_of(tradeoff.options.by);
  const std::string within = within_text(tradeoff.options);
  if (!listed.affordable) {
    return fmt::format("No design {} of it has {}", within, words.less);
  }
  return fmt::format("{} of it: {}: {}", advised_text(tradeoff.options),
                     design_name(*listed.affordable),
                     values_text(listed, tradeoff.affordable->values));
}

// Names the parts that the wearer carries: "at the hand no moving part, 4 strands".
std::string wearer_text(const Routing& routing) {
  const WearerParts parts = wearer_parts(routing);
  const std::string moving =
      parts.moving_parts == 0 ? "no moving part"
                              : plural(static_cast<std::size_t>(parts.moving_parts), "moving part");
  return fmt::format("at the hand {}, {}", moving,
                     plural(static_cast<std::size_t>(parts.strands), "strand"));
}

std::string choice_text(const char* kind, const ListedDesign& design,
                        const ListedTradeoff& listed) {
  const Tradeoff& tradeoff = listed.tradeoff;
  const ObjectiveValues& values = design.ranked.design.values;
  const std::string chosen =
      is_within(values, tradeoff)
          ? fmt::format("{} {} of the best", words_of(tradeoff.options.by).fewest,
                        within_text(tradeoff.options))
          : "best";
  const std::string jams = design.smallest_jams.empty() ? "" : ", jams in some grasps";
  return fmt::format("{} floating blocks, {}: {}: {}{}; {}", kind, chosen, design_name(design),
                     values_text(listed, values), jams, wearer_text(design.routing));
}

// Returns two lines, the second with the effect of bars in place of the floating pulleys.
std::vector<DocumentLine> choice_lines(const ListedTradeoff& tradeoff) {
  std::string with = choice_text("With", tradeoff.choice->with, tradeoff);
  if (tradeoff.with_bars) {
    with += fmt::format("; with rigid bars in place of its pulleys it is {}: {}",
                        design_name(*tradeoff.with_bars),
                        values_text(tradeoff, tradeoff.with_bars->ranked.design.values));
  }
  return {{choice_text("Without", tradeoff.choice->without, tradeoff)}, {std::move(with)}};
}

std::optional<double> finite(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

// "the least is 1", "the least is 37.66 N": rounded away from the bound, so that a design meets the
// constraint with this bound.
std::string nearest_text(const Constraint& constraint, const Nearest& reached,
                         const std::string& cost_unit) {
  const Nearest nearest{finite(reached.above), finite(reached.below)};
  const bool is_any_reached = reached.above || reached.below;
  if (is_any_reached && !nearest.above && !nearest.below) return "in all of them it is infinite";
  const bool below = constraint.comparison.front() == '<';
  const bool above = constraint.comparison.front() == '>';
  const std::string own = objective_unit(constraint.objective, cost_unit);
  const std::string unit = own.empty() ? "" : " " + own;
  const auto low = [&] { return rounded_text(*nearest.below, Rounding::down); };
  const auto high = [&] { return rounded_text(*nearest.above, Rounding::up) + unit; };
  if (below && nearest.above) return "the least is " + high();
  if (above && nearest.below) return "the greatest is " + low() + unit;
  if (nearest.above && nearest.below) {
    return fmt::format("the nearest are {} and {}", low(), high());
  }
  if (nearest.above) return "the nearest is " + high();
  return nearest.below ? "the nearest is " + low() + unit : "";
}

}  // namespace

std::string design_name(const ListedDesign& design) {
  const std::string& word = design.ranked.design.word;
  return design.name.empty() ? word : design.name + " (" + word + ")";
}

std::string short_name(const ListedDesign& design) {
  return design.name.empty() ? design.ranked.design.word : design.name;
}

std::string objective_heading(Objective objective) {
  const ObjectiveRow& about = row(objective);
  return about.part == std::string_view("worst") ? std::string("worst ") + about.heading
                                                 : about.heading;
}

std::string cost_unit(const std::optional<PartPrices>& prices) {
  return prices ? prices->unit : "";
}

std::string objective_unit(Objective objective, const std::string& cost_unit) {
  if (objective == Objective::cost) return cost_unit;
  const ObjectiveRow& about = row(objective);
  return about.is_count() || about.unit == std::string_view("1") ? "" : about.unit;
}

std::string signed_percent(double share) { return fmt::format("{:+.1f} %", 100 * share); }

std::string within_text(const TradeoffOptions& options) {
  return fmt::format("within {:.4g} %", 100 * options.within);
}

std::string tradeoff_title(const Tradeoff& tradeoff) {
  const ObjectiveRow& about = row(tradeoff.options.by);
  return fmt::format("Best design {} {}", about.is_count() ? "for each number of" : "up to each",
                     words_of(tradeoff.options.by).plural);
}

std::string advised_text(const TradeoffOptions& options) {
  std::string text = fmt::format("{} {}", words_of(options.by).fewest, within_text(options));
  text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

std::string equivalent_text(const ListedDesign& design) {
  if (design.equivalent.empty()) return "";
  return fmt::format(" ({})", plural(design.equivalent.size(), "equivalent variant"));
}

std::vector<DocumentLine> answer_lines(const std::vector<ListedDesign>& designs,
                                       const ListedTradeoff& tradeoff) {
  if (designs.empty() || tradeoff.steps.empty()) return {};
  std::vector<DocumentLine> lines{{first_text(designs.front(), tradeoff)},
                                  {jams_text(designs.front(), tradeoff)}};
  append(lines, tradeoff.choice ? choice_lines(tradeoff)
                                : std::vector<DocumentLine>{{affordable_text(tradeoff)}});
  if (tradeoff.tradeoff.knee) {
    const TradeoffStep& step = tradeoff.tradeoff.steps[*tradeoff.tradeoff.knee];
    lines.push_back({fmt::format("Knee of the trade-off: {}, {}",
                                 design_name(tradeoff.steps[*tradeoff.tradeoff.knee]),
                                 measure_text(tradeoff, step.at_most))});
  }
  if (stays_open(designs.front().ranked.design.values)) {
    lines.push_back({"Hands that close all the way: --constraint 'closure>=1'"});
  }
  return lines;
}

std::vector<DocumentLine> equivalent_lines(const std::vector<ListedDesign>& shown) {
  std::vector<DocumentLine> lines;
  for (const ListedDesign& design : shown) {
    if (design.equivalent.empty()) continue;
    lines.push_back(
        {fmt::format("Equivalent variants of rank {}, with other bearings: {}", design.ranked.rank,
                     enumerated(design.equivalent, ", ", named_at_most))});
  }
  return lines;
}

std::vector<DocumentLine> infeasible_lines(const ExploreOptions& options,
                                           const ExploreResult& result) {
  std::vector<DocumentLine> alone;
  std::vector<DocumentLine> together;
  const std::string unit = cost_unit(options.prices);
  for (std::size_t c = 0; c < result.infeasible.size(); ++c) {
    const Constraint& constraint = options.constraints[c];
    const ConstraintReach& reach = result.infeasible[c];
    const std::string least = nearest_text(constraint, reach.of_all, unit);
    if (!reach.met && !least.empty()) {
      alone.push_back({fmt::format("No design meets {}: {}", constraint.text, least), true});
    }
    const std::string others = nearest_text(constraint, reach.of_those_that_meet_the_others, unit);
    if (!others.empty()) {
      together.push_back(
          {fmt::format("Of the designs that meet all but {}, {}", constraint.text, others), true});
    }
  }
  if (result.evaluated == 0 && result.without_tensions.count > 0 && !result.partial) {
    return {{"No design has tensions in all grasps", true}};
  }
  if (result.infeasible.empty() && result.evaluated > 0 && result.best.empty() && !result.partial) {
    return {{"No design of this shard meets the constraints", true}};
  }
  if (result.infeasible.empty()) return {};
  std::vector<DocumentLine>& lines = alone.empty() ? together : alone;
  if (alone.empty()) {
    lines.insert(lines.begin(),
                 {fmt::format("Each of these constraints is met by some design, but {} by none",
                              result.infeasible.size() == 2
                                  ? std::string("both")
                                  : fmt::format("all {}", result.infeasible.size())),
                  true});
  }
  const Hardware& hardware = options.model.hardware;
  const double work_J = least_work_J(hardware, options.generator.fingers, options.grasps);
  const auto motors = static_cast<std::size_t>(options.generator.parts.motors);
  append(lines, energy_lines(work_J, hardware.motor, motors));
  return lines;
}

}  // namespace reeve::reports
