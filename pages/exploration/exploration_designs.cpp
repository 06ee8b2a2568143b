#include "pages/exploration/exploration_designs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "pages/exploration/objective_title.hpp"
#include "search/judge/shown_objectives.hpp"

namespace reeve::pages {
namespace {

// Eight digits: enough to round as the rest of the page does, and half the bytes. A whole number
// over a power of ten is the nearest number to those digits.
Json rounded(double value) {
  if (value == 0 || !std::isfinite(value)) return number(value);
  const double decimals = 7 - std::floor(std::log10(std::abs(value)));
  if (decimals < 0 || decimals > 22) return value;
  const double power = std::pow(10, decimals);
  return std::round(value * power) / power;
}

Json values_column(const std::vector<PageDesign>& designs, std::size_t objective) {
  Json column = Json::array();
  for (const PageDesign& design : designs) column.push_back(rounded(design.values[objective]));
  return column;
}

Json distribution_column(const std::vector<PageDesign>& designs, double RankDistribution::*part) {
  Json column = Json::array();
  for (const PageDesign& design : designs) {
    column.push_back(design.distribution ? rounded((*design.distribution).*part) : Json(nullptr));
  }
  return column;
}

std::set<std::string> known_words(const ExploreReport& report) {
  std::set<std::string> words;
  for (const ReferenceStanding& reference : report.result.references) {
    words.insert(reference.design.word);
  }
  return words;
}

// The rungs and the affordable design.
std::vector<const ListedDesign*> of_the_ladder(const ExploreReport& report) {
  std::vector<const ListedDesign*> designs;
  for (const ListedDesign& rung : report.ladder.rungs) designs.push_back(&rung);
  if (report.ladder.affordable) designs.push_back(&*report.ladder.affordable);
  return designs;
}

Json same_as_column(const std::vector<PageDesign>& designs) {
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < designs.size(); ++i) places.emplace(designs[i].word, i);
  Json column = Json::array();
  for (const PageDesign& design : designs) {
    const auto found = places.find(design.same_as);
    column.push_back(found == places.end() ? -1 : static_cast<int>(found->second));
  }
  return column;
}

}  // namespace

const char* design_kind_name(Kind kind) {
  constexpr std::array<const char*, kind_count> names{"listed", "on the front", "known routing",
                                                      "random sample"};
  return names[static_cast<std::size_t>(kind)];
}

chart::Style design_style(Kind kind) {
  switch (kind) {
    case Kind::listed:
      return {chart::Colour::blue, chart::Symbol::circle, 3, 1.5, 1, 0.55};
    case Kind::front:
      return {chart::Colour::orange, chart::Symbol::square, 4.5};
    case Kind::known:
      return {chart::Colour::green, chart::Symbol::triangle, 5};
    case Kind::sample:
      break;
  }
  return {chart::Colour::pink, chart::Symbol::diamond, 2, 1.5, 1, 0.45};
}

chart::Style advised_style() { return {chart::Colour::violet, chart::Symbol::diamond, 8, 2, 0}; }

std::vector<PageDesign> page_designs(const ExploreReport& report, std::size_t most) {
  const std::vector<ListedDesign>& listed = listed_designs(report);
  const std::set<std::string> known = known_words(report);
  std::vector<PageDesign> designs;
  std::set<std::string> held;
  for (std::size_t i = 0; i < std::min(most, listed.size()); ++i) {
    const RankedDesign& ranked = listed[i].ranked;
    const std::string& word = ranked.design.word;
    const Kind kind = known.contains(word) ? Kind::known
                      : ranked.front == 1  ? Kind::front
                                           : Kind::listed;
    held.insert(word);
    designs.push_back({kind, word, listed[i].name, ranked.rank, ranked.front, ranked.design.values,
                       listed[i].distribution, listed[i].bands, listed[i].same_as,
                       listed[i].constraints_met});
  }
  for (std::size_t i = 0; i < report.result.references.size(); ++i) {
    const ReferenceStanding& reference = report.result.references[i];
    if (!held.insert(reference.design.word).second) continue;
    designs.push_back({Kind::known, reference.design.word, report.reference_names[i],
                       reference.rank, reference.front, reference.design.values, std::nullopt,
                       report.reference_bands.empty() ? Bands{} : report.reference_bands[i]});
  }
  for (const ListedDesign* design : of_the_ladder(report)) {
    const RankedDesign& ranked = design->ranked;
    if (!held.insert(ranked.design.word).second) continue;
    designs.push_back({Kind::listed, ranked.design.word, design->name, ranked.rank, ranked.front,
                       ranked.design.values, std::nullopt});
  }
  // What is listed has a rank, even if there is no room for it here.
  for (const ListedDesign& design : listed) held.insert(design.ranked.design.word);
  for (const Design& design : report.result.sample) {
    if (held.contains(design.word)) continue;
    designs.push_back({Kind::sample, design.word, "", 0, 0, design.values, std::nullopt});
  }
  return designs;
}

std::vector<Objective> page_objectives(const ExploreReport& report) {
  std::vector<Objective> shown = search::shown_objectives(
      report.options.order, report.options.score, report.options.constraints);
  const bool told = std::find(shown.begin(), shown.end(), Objective::blocks) != shown.end();
  if (!told && report.options.generator.parts.blocks > 0) shown.push_back(Objective::blocks);
  const bool priced = std::find(shown.begin(), shown.end(), Objective::cost) != shown.end();
  if (!priced && report.options.prices) shown.push_back(Objective::cost);
  return shown;
}

Json design_columns(const std::vector<PageDesign>& designs, const std::vector<Objective>& shown) {
  Json columns;
  for (const char* name : {"word", "name", "rank", "front", "kind", "values"}) {
    columns[name] = Json::array();
  }
  columns["distribution"] = Json::object();
  columns["same_as"] = same_as_column(designs);
  for (const PageDesign& design : designs) {
    columns["word"].push_back(design.word);
    columns["name"].push_back(design.name);
    columns["rank"].push_back(design.rank);
    columns["front"].push_back(design.front);
    columns["kind"].push_back(static_cast<int>(design.kind));
  }
  for (const Objective objective : shown) {
    columns["values"].push_back(values_column(designs, static_cast<std::size_t>(objective)));
  }
  if (designs.empty() || !designs.front().distribution) return columns;
  Json& distribution = columns["distribution"];
  distribution["first"] = distribution_column(designs, &RankDistribution::first);
  distribution["median"] = distribution_column(designs, &RankDistribution::median);
  distribution["low"] = distribution_column(designs, &RankDistribution::low);
  distribution["high"] = distribution_column(designs, &RankDistribution::high);
  if (!designs.front().constraints_met) return columns;
  distribution["constraints_met"] = Json::array();
  for (const PageDesign& design : designs) {
    distribution["constraints_met"].push_back(value_or_null(design.constraints_met, rounded));
  }
  return columns;
}

Json band_columns(const std::vector<PageDesign>& designs, const std::vector<Objective>& shown,
                  const std::vector<Objective>& ranking) {
  Json columns = Json::array();
  for (const Objective objective : shown) {
    const bool is_ranked = std::find(ranking.begin(), ranking.end(), objective) != ranking.end();
    Json low = Json::array();
    Json high = Json::array();
    bool any = false;
    for (const PageDesign& design : designs) {
      const Band* band = is_ranked ? find_band(design.bands, objective) : nullptr;
      low.push_back(band == nullptr ? Json(nullptr) : rounded(band->low));
      high.push_back(band == nullptr ? Json(nullptr) : rounded(band->high));
      any = any || band != nullptr;
    }
    columns.push_back(any ? Json{{"low", low}, {"high", high}} : Json(nullptr));
  }
  return columns;
}

Json objectives_json(const std::vector<Objective>& shown, const std::string& cost_unit) {
  Json list = Json::array();
  for (const Objective objective : shown) {
    const ObjectiveRow& row = search::row(objective);
    list.push_back(
        {{"name", row.name},
         {"title", objective_title(row)},
         {"unit", objective == Objective::cost && !cost_unit.empty() ? cost_unit : row.unit},
         {"better", row.better == Better::higher ? "higher" : "lower"},
         {"least", value_or_null(row.least, number)},
         {"greatest", value_or_null(row.greatest, number)},
         {"count", row.is_count()},
         {"meaning", row.meaning}});
  }
  return list;
}

}  // namespace reeve::pages
