#include "pages/exploration/exploration_designs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "pages/exploration/exploration_answer.hpp"
#include "pages/page_words.hpp"
#include "search/evaluate/shown_objectives.hpp"

namespace reeve::pages {
namespace {

constexpr std::array<double, 23> power_of_ten{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                              1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                              1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// Eight digits: enough to round as the rest of the page does, and half the bytes. A whole number
// over a power of ten is the nearest number to those digits.
Json rounded(double value) {
  if (value == 0 || !std::isfinite(value)) return number(value);
  const double decimals = 7 - std::floor(std::log10(std::abs(value)));
  if (decimals < 0 || decimals > 22) return value;
  const double power = power_of_ten[static_cast<std::size_t>(decimals)];
  return std::round(value * power) / power;
}

Json values_column(const std::vector<PageDesign>& designs, std::size_t objective) {
  return list_json(designs,
                   [&](const PageDesign& design) { return rounded(design.values[objective]); });
}

Json distribution_column(const std::vector<PageDesign>& designs, double RankDistribution::*part) {
  return list_json(designs, [&](const PageDesign& design) {
    return value_or_null(design.distribution,
                         [&](const RankDistribution& drawn) { return rounded(drawn.*part); });
  });
}

std::set<std::string> known_words(const ExploreReport& report) {
  std::set<std::string> words;
  for (const ReferenceStanding& reference : report.result.references) {
    words.insert(reference.design.word);
  }
  return words;
}

Json same_as_column(const std::vector<PageDesign>& designs) {
  std::unordered_map<std::string_view, std::size_t> places(designs.size());
  for (std::size_t i = 0; i < designs.size(); ++i) places.emplace(designs[i].word, i);
  return list_json(designs, [&](const PageDesign& design) {
    const auto found = design.same_as.empty() ? places.end() : places.find(design.same_as);
    return found == places.end() ? -1 : static_cast<int>(found->second);
  });
}

std::vector<std::string_view> words_of_others(const ExploreReport& report) {
  std::vector<std::string_view> words;
  for (const ReferenceStanding& reference : report.result.references) {
    words.push_back(reference.design.word);
  }
  for (const ListedDesign* design : named_designs(report)) {
    words.push_back(design->ranked.design.word);
  }
  for (const Design& design : report.result.sample) words.push_back(design.word);
  return words;
}

PageDesign page_design(const ListedDesign& listed, DesignKind kind) {
  const RankedDesign& ranked = listed.ranked;
  return {kind,           ranked.design.word,    listed.name,         ranked.rank,
          ranked.front,   ranked.design.values,  listed.distribution, listed.bands,
          listed.same_as, listed.constraints_met};
}

}  // namespace

const char* design_kind_name(DesignKind kind) {
  constexpr std::array<const char*, kind_count> names{"listed", "on the front", "known routing",
                                                      "random sample", "named, not listed"};
  return names[static_cast<std::size_t>(kind)];
}

chart::Style design_style(DesignKind kind) {
  switch (kind) {
    case DesignKind::listed:
      return {chart::Colour::blue, chart::Symbol::circle, 3, 1.5, 1, 0.55};
    case DesignKind::front:
      return {chart::Colour::orange, chart::Symbol::square, 4.5};
    case DesignKind::known:
      return {chart::Colour::green, chart::Symbol::triangle, 5};
    case DesignKind::named:
      return {chart::Colour::sky, chart::Symbol::cross, 5};
    case DesignKind::sample:
      break;
  }
  return {chart::Colour::pink, chart::Symbol::diamond, 2, 1.5, 1, 0.45};
}

chart::Style advised_style() { return {chart::Colour::violet, chart::Symbol::diamond, 8, 2, 0}; }

WordPlaces listed_places(const ExploreReport& report, const std::vector<std::string_view>& words) {
  const std::vector<ListedDesign>& listed = listed_designs(report);
  WordPlaces places;
  for (const std::string_view word : words) places.emplace(word, listed.size());
  for (std::size_t i = 0; i < listed.size(); ++i) {
    const auto found = places.find(listed[i].ranked.design.word);
    if (found != places.end()) found->second = i;
  }
  std::erase_if(places, [&](const auto& entry) { return entry.second == listed.size(); });
  return places;
}

std::vector<PageDesign> page_designs(const ExploreReport& report, std::size_t most) {
  const std::vector<ListedDesign>& listed = listed_designs(report);
  const std::size_t count = std::min(most, listed.size());
  const std::set<std::string> known = known_words(report);
  std::vector<PageDesign> designs;
  designs.reserve(count + report.result.sample.size());
  for (std::size_t i = 0; i < count; ++i) {
    const DesignKind kind = known.contains(listed[i].ranked.design.word) ? DesignKind::known
                            : listed[i].ranked.front == 1                ? DesignKind::front
                                                                         : DesignKind::listed;
    designs.push_back(page_design(listed[i], kind));
  }
  const WordPlaces places = listed_places(report, words_of_others(report));
  std::set<std::string_view> added;
  const auto is_new = [&](std::string_view word) {
    const auto place = places.find(word);
    return (place == places.end() || place->second >= count) && added.insert(word).second;
  };
  for (std::size_t i = 0; i < report.result.references.size(); ++i) {
    const ReferenceStanding& reference = report.result.references[i];
    if (!is_new(reference.design.word)) continue;
    designs.push_back({DesignKind::known, reference.design.word, report.reference_names[i],
                       reference.rank, reference.front, reference.design.values, std::nullopt,
                       report.reference_bands.empty() ? Bands{} : report.reference_bands[i]});
  }
  for (const ListedDesign* design : named_designs(report)) {
    const RankedDesign& ranked = design->ranked;
    if (!is_new(ranked.design.word)) continue;
    designs.push_back({DesignKind::named, ranked.design.word, design->name, ranked.rank,
                       ranked.front, ranked.design.values, std::nullopt});
  }
  // A listed design has a rank, even if there is no room for it here.
  for (const Design& design : report.result.sample) {
    if (places.contains(design.word) || added.contains(design.word)) continue;
    designs.push_back({DesignKind::sample, design.word, "", 0, 0, design.values, std::nullopt});
  }
  return designs;
}

std::vector<Objective> page_objectives(const ExploreReport& report) {
  std::vector<Objective> shown = search::shown_objectives(
      report.options.order, report.options.score, report.options.constraints);
  const bool told = std::ranges::find(shown, Objective::blocks) != shown.end();
  if (!told && report.options.generator.parts.blocks > 0) shown.push_back(Objective::blocks);
  const bool priced = std::ranges::find(shown, Objective::cost) != shown.end();
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
  distribution["constraints_met"] = list_json(designs, [](const PageDesign& design) {
    return value_or_null(design.constraints_met, rounded);
  });
  return columns;
}

Json band_columns(const std::vector<PageDesign>& designs, const std::vector<Objective>& shown,
                  const std::vector<Objective>& ranking) {
  Json columns = Json::array();
  for (const Objective objective : shown) {
    const bool is_ranked = std::ranges::find(ranking, objective) != ranking.end();
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
  return list_json(shown, [&](Objective objective) {
    const ObjectiveRow& row = search::row(objective);
    return Json{{"name", row.name},
                {"title", objective_title(row)},
                {"unit", objective == Objective::cost && !cost_unit.empty() ? cost_unit : row.unit},
                {"better", row.better == Better::higher ? "higher" : "lower"},
                {"least", value_or_null(row.least, number)},
                {"greatest", value_or_null(row.greatest, number)},
                {"count", row.is_count()},
                {"meaning", row.meaning}};
  });
}

}  // namespace reeve::pages
