#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "pages/exploration/exploration_answer.hpp"
#include "pages/exploration/exploration_designs.hpp"
#include "pages/exploration/exploration_words.hpp"
#include "pages/page_words.hpp"
#include "reports/exploration/decision_words.hpp"

namespace reeve::pages {
namespace {

constexpr std::size_t first_designs = 50;
constexpr std::size_t front_designs = 200;

// Shares line up in their column. A cost without a unit is no share.
std::string cell(const ObjectiveRow& row, const ListedDesign& design) {
  const double v = value(design.ranked.design.values, row.objective);
  const bool is_share = row.unit == std::string_view("1") && row.objective != Objective::cost;
  return is_share && std::isfinite(v) ? fmt::format("{:.4f}", v) : four_digits(v);
}

Json design_row(const ListedDesign& design, const std::vector<Objective>& shown) {
  Json row{{"rank", design.ranked.rank},
           {"front", design.ranked.front},
           {"name", design.name.empty() ? "–" : design.name},
           {"word", design.ranked.design.word},
           {"alike", design.equivalent.empty() ? "" : fmt::format("+{}", design.equivalent.size())},
           {"cells", Json::array()}};
  for (const Objective objective : shown) {
    row["cells"].push_back(cell(search::row(objective), design));
  }
  if (design.distribution) {
    const RankDistribution& drawn = *design.distribution;
    row["cells"].push_back(share_text(drawn.first));
    row["cells"].push_back(four_digits(drawn.median));
    row["cells"].push_back(four_digits(drawn.low) + "–" + four_digits(drawn.high));
  }
  if (design.constraints_met) row["cells"].push_back(share_text(*design.constraints_met));
  return row;
}

Json objective_json(const ObjectiveRow& row, const std::string& cost_unit) {
  const std::string unit = shown_unit(objective_unit(row.objective, cost_unit));
  return {{"title", objective_title(row)},
          {"heading", objective_title(row) + (unit.empty() ? "" : ", " + unit)},
          {"meaning", row.meaning},
          {"better", row.better == Better::higher ? "higher" : "lower"}};
}

Json best_json(const SingleBest& best, const ListedDesign& first, const std::string& cost_unit) {
  Json json = objective_json(best.objective, cost_unit);
  json["value"] = cell(best.objective, best.design);
  json["first"] = cell(best.objective, first);
  json["design"] = design_name(best.design);
  json["rank"] = best.design.ranked.rank;
  json["equal"] = best.equal == 0 ? "none" : fmt::format("{} more", best.equal);
  return json;
}

}  // namespace

Json static_tables(const ExploreReport& report) {
  const std::vector<ListedDesign>& listed = listed_designs(report);
  const std::size_t shown = std::min(
      listed.size(), std::max(first_designs, std::min(front_designs, report.front.size())));
  Json json{{"objectives", Json::array()}, {"rows", Json::array()}, {"bests", Json::array()}};
  const std::vector<Objective> objectives = page_objectives(report);
  const std::string unit = cost_unit(report.options.prices);
  for (std::size_t i = 0; i < objectives.size(); ++i) {
    json["objectives"].push_back(objective_json(row(objectives[i]), unit));
    json["objectives"].back()["column"] = i;
  }
  for (std::size_t i = 0; i < listed.size() && json["rows"].size() < shown; ++i) {
    if (listed[i].same_as.empty()) json["rows"].push_back(design_row(listed[i], objectives));
  }
  json["bests"] = list_json(single_bests(report), [&](const SingleBest& best) {
    return best_json(best, listed.front(), unit);
  });
  json["uncertain"] = !listed.empty() && listed.front().distribution.has_value();
  json["constrained"] = !listed.empty() && listed.front().constraints_met.has_value();
  json["has_bests"] = !json["bests"].empty();
  json["table_caption"] = "Designs, best first. Values are over the grasps of this exploration.";
  json["bests_caption"] = fmt::format(
      "Among the {} listed of {} ranked designs; of those that are equally good, the one with "
      "the best rank.",
      listed.size(), ranked_designs(report));
  return json;
}

}  // namespace reeve::pages
