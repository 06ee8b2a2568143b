#include "pages/exploration/exploration_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>

#include "pages/page_words.hpp"
#include "reports/data_text.hpp"
#include "reports/document/document.hpp"
#include "reports/exploration/band_report.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/exploration/target_report.hpp"
#include "reports/motor_words.hpp"
#include "reports/shown_value.hpp"

namespace reeve::pages {
namespace {

const ListedDesign* knee(const ListedTradeoff& tradeoff) {
  return tradeoff.tradeoff.knee ? &tradeoff.steps[*tradeoff.tradeoff.knee] : nullptr;
}

// The counts of parts are said anyway.
std::vector<Objective> ranked_and_constrained(const ExploreOptions& options) {
  std::vector<Objective> objectives = options.order.objectives;
  for (const Constraint& constraint : options.constraints) {
    const bool told = std::ranges::find(objectives, constraint.objective) != objectives.end();
    if (!told && !row(constraint.objective).is_count()) objectives.push_back(constraint.objective);
  }
  return objectives;
}

// "uniformity mean 0.996, efficiency mean 0.322; 10 sheaths, 8 pulleys, 2 knots"
std::string values_text(const ExploreReport& report, const ListedDesign& design) {
  std::string text;
  for (const Objective objective : ranked_and_constrained(report.options)) {
    const ObjectiveRow& about = row(objective);
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", objective_title(about),
                        shown_value(objective, value(design.ranked.design.values, objective)));
  }
  constexpr std::pair<Objective, const char*> parts[] = {{Objective::sheaths, "sheath"},
                                                         {Objective::pulleys, "pulley"},
                                                         {Objective::knots, "knot"},
                                                         {Objective::blocks, "floating block"}};
  std::string counts;
  for (const auto& [objective, noun] : parts) {
    const auto count = static_cast<std::uint64_t>(value(design.ranked.design.values, objective));
    if (count > 0) counts += fmt::format("{}{}", counts.empty() ? "; " : ", ", plural(count, noun));
  }
  return text + counts;
}

Json slot(const std::string& id, const std::string& heading, const ListedDesign& design,
          const ExploreReport& report, const SolveDesign& solve) {
  return {{"heading", heading},
          {"label", design_name(design)},
          {"values", values_text(report, design)},
          {"svg", grasp_svg(solve(design.routing), 0, id)}};
}

// The answer's lines by themselves: the first design, when it jams, the advised one, and others.
constexpr std::size_t first_lines = 3;

// Returns the target, the first design and the advised one: a phone shows these words alone. When
// the first one jams is no paragraph of its own: the first screen holds the plot, too.
Json answer_first(const ExploreReport& report) {
  std::vector<DocumentLine> lines = target_lines(report.target);
  const std::vector<DocumentLine> best = answer_lines(listed_designs(report), report.tradeoff);
  if (best.size() >= first_lines) {
    append(lines, {{best[0].text + ". " + best[1].text}, best[2]});
  }
  return sentences_of(lines);
}

Json answer_further(const ExploreReport& report) {
  std::vector<DocumentLine> lines = answer_lines(listed_designs(report), report.tradeoff);
  lines.erase(lines.begin(),
              lines.begin() + static_cast<std::ptrdiff_t>(std::min(first_lines, lines.size())));
  append(lines, motor_lines(report.motor, report.options.model.hardware.motor));
  append(lines, robust_lines(report.robust_first));
  return sentences_of(lines);
}

Json word_or_null(const ListedDesign* design) {
  return design == nullptr ? Json(nullptr) : Json(design->ranked.design.word);
}

}  // namespace

Json answer_body(const ExploreReport& report, const SolveDesign& solve) {
  const std::vector<ListedDesign>& listed = listed_designs(report);
  Json body{{"answer", answer_first(report)}, {"further", answer_further(report)}};
  body["slots"] = Json::array();
  if (listed.empty()) return body;
  body["slots"].push_back(slot("slot-first", "Best", listed.front(), report, solve));
  if (report.tradeoff.affordable) {
    const std::string heading = advised_text(report.tradeoff.tradeoff.options);
    body["slots"].push_back(
        slot("slot-affordable", heading, *report.tradeoff.affordable, report, solve));
  }
  return body;
}

std::vector<AdvisedDesign> advised_designs(const ExploreReport& report) {
  const ListedTradeoff& tradeoff = report.tradeoff;
  std::vector<AdvisedDesign> designs;
  if (tradeoff.affordable) {
    designs.push_back(
        {tradeoff.affordable->ranked.design.word, within_text(tradeoff.tradeoff.options)});
  }
  if (const ListedDesign* bend = knee(tradeoff)) {
    const std::string& word = bend->ranked.design.word;
    if (!designs.empty() && designs.front().word == word) {
      designs.front().label += ", knee";
    } else {
      designs.push_back({word, "knee"});
    }
  }
  return designs;
}

Json tradeoff_marks(const ExploreReport& report) {
  const std::vector<ListedDesign>& listed = listed_designs(report);
  const ListedTradeoff& tradeoff = report.tradeoff;
  Json advised = list_json(advised_designs(report), [](const AdvisedDesign& design) {
    return Json{{"word", design.word}, {"label", design.label}};
  });
  Json named = list_json(named_designs(report), word_or_null);
  return {{"first", word_or_null(listed.empty() ? nullptr : &listed.front())},
          {"affordable", word_or_null(tradeoff.affordable ? &*tradeoff.affordable : nullptr)},
          {"knee", word_or_null(knee(tradeoff))},
          {"heading", advised_text(tradeoff.tradeoff.options)},
          {"advised", std::move(advised)},
          {"named", std::move(named)}};
}

std::vector<const ListedDesign*> named_designs(const ExploreReport& report) {
  const ListedTradeoff& tradeoff = report.tradeoff;
  std::vector<const ListedDesign*> designs;
  std::set<std::string_view> held;
  const auto add = [&](const ListedDesign& design) {
    if (held.insert(design.ranked.design.word).second) designs.push_back(&design);
  };
  if (!listed_designs(report).empty()) add(listed_designs(report).front());
  for (const auto* design : {&tradeoff.affordable, &tradeoff.with_bars, &tradeoff.never_jams}) {
    if (*design) add(**design);
  }
  if (tradeoff.choice) {
    add(tradeoff.choice->without);
    add(tradeoff.choice->with);
  }
  if (report.robust_first) add(report.robust_first->robust.design);
  for (const ListedDesign& step : tradeoff.steps) add(step);
  return designs;
}

}  // namespace reeve::pages
