#include "pages/exploration/exploration_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "pages/page_words.hpp"
#include "reports/data_text.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/exploration/design_list.hpp"
#include "reports/jam_words.hpp"
#include "reports/output/json.hpp"
#include "search/evaluate/shown_objectives.hpp"

namespace reeve::pages {
namespace {

double get(const ListedDesign& design, Objective objective) {
  return value(design.ranked.design.values, objective);
}

std::string values_text(const ObjectiveValues& values, const std::vector<Objective>& objectives) {
  std::vector<std::string> texts;
  for (const Objective objective : objectives) {
    texts.push_back(objective_title(row(objective)) + " " + four_digits(value(values, objective)));
  }
  return enumerated(texts);
}

// ", with 4 sheaths and 1 knot": the parts that the ranking does not count, which stand elsewhere.
std::string with_parts(const ListedDesign& design, const std::vector<Objective>& objectives) {
  const std::pair<Objective, const char*> parts[] = {{Objective::sheaths, "sheath"},
                                                     {Objective::pulleys, "pulley"},
                                                     {Objective::knots, "knot"},
                                                     {Objective::blocks, "floating block"}};
  std::vector<std::string> texts;
  for (const auto& [objective, noun] : parts) {
    if (std::ranges::find(objectives, objective) != objectives.end()) continue;
    // A hand without floating blocks is not mentioned.
    if (objective == Objective::blocks && get(design, objective) == 0) continue;
    texts.push_back(plural(static_cast<std::uint64_t>(get(design, objective)), noun));
  }
  return texts.empty() ? "" : ", with " + enumerated(texts);
}

// Names the rule of the ranking that puts the first before the second of its front.
std::string tie_text(const Order& order, const ListedDesign& first, const ListedDesign& second) {
  if (decisive_value(first.ranked.design.values, order) !=
      decisive_value(second.ranked.design.values, order)) {
    return "";
  }
  const char* same = order.by_score ? "score" : "product";
  if (part_total(first.ranked.design.values) < part_total(second.ranked.design.values))
    return fmt::format("; of those with the same {} it needs fewest parts", same);
  return fmt::format(
      "; among those with the same {} and as many parts, only the order of their words decides",
      same);
}

std::string why(const ExploreReport& report, const std::vector<ListedDesign>& listed) {
  const Order& order = report.options.order;
  const std::string objectives = titles(order.objectives);
  const std::uint64_t size = report.front.size() + report.result.front_equals_left_out;
  if (size == 1) {
    return fmt::format(
        "It stands alone on the Pareto front: no other ranked design is better in any "
        "of what the ranking counts: {}.",
        objectives);
  }
  return fmt::format(
      "It is one of {} designs on the Pareto front ({} distinct), which no other beats over {}. "
      "Among these the one with the greatest {} comes first{}.",
      size, distinct_on_front(report), objectives,
      order.by_score ? "score" : "product of mean uniformity and mean efficiency",
      listed.size() > 1 ? tie_text(order, listed[0], listed[1]) : "");
}

std::string next_text(const ExploreReport& report, const ListedDesign& first,
                      const ListedDesign& second) {
  std::vector<std::string> differences;
  for (const Objective objective : report.options.order.objectives) {
    if (get(first, objective) == get(second, objective)) continue;
    differences.push_back(fmt::format("{} {} instead of {}", objective_title(row(objective)),
                                      four_digits(get(second, objective)),
                                      four_digits(get(first, objective))));
  }
  const std::string text = "Next comes " + design_name(second);
  if (differences.empty()) {
    return fmt::format("{}, which equals it in these{}.", text,
                       with_parts(second, report.options.order.objectives));
  }
  return fmt::format("{}: {}{}.", text, enumerated(differences),
                     with_parts(second, report.options.order.objectives));
}

// The known routing with the best rank behind `rank`, by its place in the report.
std::optional<std::size_t> best_known(const ExploreReport& report, std::size_t rank) {
  std::optional<std::size_t> best;
  const std::vector<ReferenceStanding>& references = report.result.references;
  for (std::size_t i = 0; i < references.size(); ++i) {
    if (references[i].rank <= rank) continue;
    if (!best || references[i].rank < references[*best].rank) best = i;
  }
  return best;
}

std::string known_text(const ExploreReport& report) {
  const std::vector<ReferenceStanding>& references = report.result.references;
  if (references.empty()) return "";
  const bool won = std::ranges::any_of(
      references, [](const ReferenceStanding& known) { return known.rank == 1; });
  const std::optional<std::size_t> best = best_known(report, won ? 1 : 0);
  if (!best) {
    return won ? "It is a known routing; no other of these is among the listed designs."
               : "None of the known routings is among the listed designs.";
  }
  const ReferenceStanding& known = references[*best];
  return fmt::format(
      "{}, {}, has rank {}: {} dominate{} it, and it has {}.",
      won ? "It is a known routing; the next of these" : "The best of the known routings",
      report.reference_names[*best], known.rank, plural(known.dominated_by, "design"),
      known.dominated_by == 1 ? "s" : "",
      values_text(known.design.values, report.options.order.objectives));
}

std::vector<std::string> won(const ExploreReport& report) {
  const std::vector<ListedDesign>& listed = listed_designs(report);
  if (listed.empty()) {
    std::vector<std::string> text{"No design is left to rank: every routing was rejected."};
    append(text, sentences_of(infeasible_lines(report.options, report.result)));
    return text;
  }
  std::vector<std::string> text{
      fmt::format("{} comes first of {}: {}{}.", design_name(listed[0]),
                  plural(ranked_designs(report), "design"),
                  values_text(listed[0].ranked.design.values, report.options.order.objectives),
                  with_parts(listed[0], report.options.order.objectives)),
      why(report, listed)};
  text.push_back(known_text(report));
  if (listed.size() > 1) text.push_back(next_text(report, listed[0], listed[1]));
  return text;
}

std::string draws_text(const ExploreReport& report, const std::vector<ListedDesign>& listed) {
  if (!report.uncertainty || !listed[0].distribution) {
    return report.draws_stopped ? ""
                                : "How the order changes with the friction coefficients was not "
                                  "computed; --uncertainty draws them from their ranges.";
  }
  const auto share = [](const ListedDesign& design) {
    return design.distribution ? design.distribution->first : 0;
  };
  const ListedDesign& most = *std::ranges::max_element(listed, {}, share);
  std::string text = fmt::format(
      "With friction coefficients drawn {} times from their ranges, {} stays first in {} of "
      "the draws.",
      report.uncertainty->draws, design_name(listed[0]), share_text(share(listed[0])));
  if (listed[0].distribution->first_shared > 0) {
    text += fmt::format(" In {} it shares first place with designs that equal it.",
                        share_text(listed[0].distribution->first_shared));
  }
  if (&most != &listed[0] && share(most) > share(listed[0])) {
    text +=
        fmt::format(" {} is first most often: in {}.", design_name(most), share_text(share(most)));
  }
  if (listed[0].constraints_met) {
    text += fmt::format(
        " Constraints were judged at the nominal coefficients; in {} of the draws it meets all of "
        "them.",
        share_text(*listed[0].constraints_met));
  }
  return text;
}

std::vector<std::string> changes(const ExploreReport& report) {
  const std::vector<ListedDesign>& listed = listed_designs(report);
  if (listed.empty()) return {};
  std::vector<std::string> stays;
  std::vector<std::string> changed;
  for (const SingleBest& best : single_bests(report)) {
    const std::string title = objective_title(best.objective);
    if (&best.design == &listed[0]) {
      stays.push_back(title);
    } else {
      changed.push_back(fmt::format("{} ({})", title, short_name(best.design)));
    }
  }
  std::vector<std::string> text;
  if (!changed.empty()) {
    text.push_back("Another of the listed designs comes first if nothing counts but " +
                   enumerated(changed) + ".");
  }
  if (!stays.empty()) {
    text.push_back(fmt::format("{} stays first, or equal to the first, by {}.",
                               design_name(listed[0]), enumerated(stays)));
  }
  if (listed.size() < ranked_designs(report)) {
    text.push_back(fmt::format(
        "The list holds the first {} of {} ranked designs. One that it leaves out may be better "
        "in an objective that the ranking does not use.",
        listed.size(), ranked_designs(report)));
  }
  text.push_back(draws_text(report, listed));
  constexpr std::size_t best = 10;
  append(text, sentences_of(shared_carriage_lines(one_of_each(listed, best), {})));
  return text;
}

std::vector<std::string> caveats(const ExploreReport& report) {
  std::vector<std::string> text;
  const std::string partial = partial_note(report);
  if (!partial.empty()) text.push_back("This exploration is partial: " + partial + ".");
  const Shard& shard = report.options.shard;
  if (shard.count > 1) {
    text.push_back(
        fmt::format("This is part {} of {} of the whole: what is best here need not be "
                    "best of all.",
                    shard.index, shard.count));
  }
  for (const std::string& note : notes(report)) text.push_back("Note: " + note + ".");
  return text;
}

void drop_empty(std::vector<std::string>& sentences) {
  std::erase_if(sentences, [](const std::string& sentence) { return sentence.empty(); });
}

}  // namespace

ExplorationWords exploration_words(const ExploreReport& report) {
  ExplorationWords words{won(report), explored_words(report), rejected_words(report),
                         changes(report), caveats(report)};
  drop_empty(words.won);
  drop_empty(words.changes);
  return words;
}

std::vector<SingleBest> single_bests(const ExploreReport& report) {
  const ExploreOptions& options = report.options;
  std::vector<SingleBest> bests;
  for (const BestDesigns& best : report.result.best) {
    if (!is_answered(best.objective, options.order, options.score, options.constraints)) continue;
    for (const ListedDesign& design : listed_designs(report)) {
      if (design.ranked.design.word != best.words.front()) continue;
      bests.push_back({row(best.objective), design, best.count - 1});
      break;
    }
  }
  return bests;
}

}  // namespace reeve::pages
