#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/routing.hpp"
#include "core/text.hpp"
#include "pages/page_words.hpp"
#include "pages/ranking_parts.hpp"
#include "reports/assumed_words.hpp"
#include "reports/data_text.hpp"
#include "reports/document/document.hpp"
#include "reports/exploration/band_report.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/exploration/design_list.hpp"
#include "reports/jam_words.hpp"
#include "reports/motor_words.hpp"
#include "search/evaluate/shown_objectives.hpp"

namespace reeve::pages {
namespace {

// The score first, where it orders.
std::string values_text(const RankReport& report, std::size_t place) {
  const ObjectiveValues& values = report.designs[place].ranked.design.values;
  const std::string score = report.order.by_score
                                ? fmt::format("score {}, ", fixed(value(values, Objective::score)))
                                : "";
  return fmt::format("{}mean uniformity {} and mean efficiency {}", score,
                     fixed(value(values, Objective::uniformity_mean)),
                     fixed(value(values, Objective::efficiency_mean)));
}

std::string label_of(const RankReport& report, const Labels& labels, const std::string& word) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (report.designs[i].ranked.design.word == word) return labels[i];
  }
  return word;
}

std::string compared(const RankReport& report) {
  const Hardware hardware = effective_hardware(report.model);
  const bool with_own = !hardware.fingers.empty() || !hardware.contacts.empty();
  return fmt::format(
      "Compared: {} with {} in the grasps {} (held fingers), by {}, at the friction coefficients "
      "{:g} of tubes, {:g} of sheaths and {:g} of bearings{}.{}",
      plural(report.designs.size(), "routing"),
      plural(static_cast<std::size_t>(report.details->routings.front().network.fingers), "finger"),
      to_text(report.grasps), objective_titles(report.order.objectives), hardware.tube.mu,
      hardware.sheath.mu, hardware.bearing.mu,
      with_own ? "; some fingers or contacts have their own" : "",
      report.order.by_score ? " " + order_text(report.order, report.score) + "." : "");
}

std::string winner(const RankReport& report, const Labels& labels) {
  if (labels.size() == 1) {
    return fmt::format("{} alone was given, with {}.", labels[0], values_text(report, 0));
  }
  return fmt::format("{} comes first, with {}. Next is {}, with {}.", labels[0],
                     values_text(report, 0), labels[1], values_text(report, 1));
}

std::string front(const RankReport& report, const Labels& labels) {
  if (labels.size() < 2) return "";
  std::vector<std::string> names;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (report.designs[i].ranked.front == 1) names.push_back(labels[i]);
  }
  if (names.size() == 1) {
    return labels[0] +
           " is alone on the Pareto front: no other is better in any of the objectives "
           "chosen.";
  }
  return fmt::format(
      "{} routings are on the Pareto front, none of which is better than another in all objectives "
      "chosen: {}. Among them the {} decides.",
      names.size(), fmt::join(names, ", "),
      report.order.by_score ? "score" : "product of both means");
}

// Objectives that put others first, those with the same ones together.
Json others(const RankReport& report, const Labels& labels) {
  const std::string& first = report.designs.front().ranked.design.word;
  Json list = Json::array();
  for (const BestDesigns& best : report.details->best) {
    if (!is_answered(best.objective, report.order, report.score)) continue;
    if (std::ranges::find(best.words, first) != best.words.end()) continue;
    std::vector<std::string> names;
    for (const std::string& word : best.words) names.push_back(label_of(report, labels, word));
    list.push_back({{"objective", objective_title(row(best.objective))},
                    {"meaning", row(best.objective).meaning},
                    {"routings", fmt::format("{}", fmt::join(names, ", "))}});
  }
  return list;
}

// Returns the lines that the trade-off decides; the first design stands above.
Json decision(const RankReport& report) {
  const std::vector<DocumentLine> motor = motor_lines(report.motor, report.model.hardware.motor);
  if (report.tradeoff.steps.size() < 2) return sentences_of(motor);
  std::vector<DocumentLine> lines = answer_lines(report.designs, report.tradeoff);
  lines.erase(lines.begin());
  append(lines, motor);
  append(lines, shared_carriage_lines(one_of_each(report.designs), report.model.hardware.tendon));
  return sentences_of(lines);
}

std::string uncertainty(const RankReport& report, const Labels& labels) {
  if (!report.uncertainty) return "";
  const RankDistribution& drawn = *report.designs.front().distribution;
  std::string text = fmt::format(
      "With coefficients drawn from their ranges ({}, seed {}) {} is first in {} of the draws.",
      plural(report.uncertainty->draws, "draw"), report.uncertainty->seed, labels[0],
      share_text(drawn.first));
  std::vector<DocumentLine> lines = robust_lines(report.robust_first);
  append(lines, shared_first_lines(report.designs));
  for (const std::string& sentence : sentences_of(lines)) text += " " + sentence;
  return text;
}

std::string margin(const RankReport& report, const Labels& labels) {
  if (!report.margins || report.margins->empty()) return "";
  const auto least = std::ranges::min_element(*report.margins, {}, &Margin::least_lead);
  const std::string over = label_of(report, labels, least->challenger);
  const std::string lead = fixed(least->least_lead, 4);
  if (least->least_lead > 0) {
    return fmt::format(
        "Nowhere that was searched in the ranges of the coefficients does another take the lead: "
        "it is least over {}, {} in mean uniformity × mean efficiency.",
        over, lead);
  }
  return fmt::format(
      "Within the ranges of the coefficients the order can turn: the lead over {} falls to {} in "
      "mean uniformity × mean efficiency.",
      over, lead);
}

// Otherwise --margin is refused.
bool is_by_both_means(Order order) {
  std::ranges::sort(order.objectives);
  return order.objectives == Order().objectives && !order.by_score;
}

}  // namespace

Json ranking_answer(const RankReport& report, const Labels& labels) {
  Json values{{"compared", compared(report)},
              {"winner", winner(report, labels)},
              {"front", front(report, labels)},
              {"uncertainty", uncertainty(report, labels)},
              {"margin", margin(report, labels)}};
  values["assumed"] = assumed_text(report.model);
  values["decision"] = decision(report);
  values["others"] = others(report, labels);
  const auto& data = report.details->distributions.data;
  values["simulated"] = data && data->simulated;
  values["has_others"] = !values["others"].empty();
  values["hint"] = !report.uncertainty && !report.margins && labels.size() > 1;
  values["margin_can_be_had"] = is_by_both_means(report.order);
  return values;
}

}  // namespace reeve::pages
