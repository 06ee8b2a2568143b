// The designs that the page of an exploration holds: its plots, its table and its filters work on
// these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "drawing/chart/chart.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/output/json.hpp"

namespace reeve::pages {

// Role of a design on the page, in the numbering of the scripts.
enum class DesignKind : std::uint8_t { listed, front, known, sample, named };
inline constexpr std::size_t kind_count = 5;

// "listed", "on the front", "known routing", "random sample", "named, not listed"
const char* design_kind_name(DesignKind kind);

// How charts mark designs, on every page: the front is an orange square wherever it is drawn.
chart::Style design_style(DesignKind kind);
// Style of the advised designs: the affordable design and the knee.
chart::Style advised_style();

struct PageDesign {
  DesignKind kind = DesignKind::listed;
  std::string word;
  std::string name;      // "" if it has none
  std::size_t rank = 0;  // 0: none is known
  int front = 0;         // 1: the best
  ObjectiveValues values{};
  std::optional<RankDistribution> distribution;
  Bands bands = {};
  std::string same_as = {};  // the design that stands for it where alike designs are one line
  std::optional<double> constraints_met = std::nullopt;  // share of the draws
};

// Indices of words among the listed designs, from 0; without words that are not listed.
using WordPlaces = std::unordered_map<std::string_view, std::size_t>;
WordPlaces listed_places(const ExploreReport& report, const std::vector<std::string_view>& words);

// Returns the first `most` of the listed designs; then the known routings and the named designs,
// if not among these; then the random sample.
std::vector<PageDesign> page_designs(const ExploreReport& report, std::size_t most);

// In columns, as assets/exploration_charts.js describes them: {"word", "name", "rank", "front",
// "kind", "same_as", "values", "distribution"}; "same_as" counts from 0, -1 for none; the last is
// empty unless the listed designs have one.
// `shown` are the objectives whose values are given.
// The objectives that are shown to people, with the blocks where the parts allow them.
std::vector<Objective> page_objectives(const ExploreReport& report);

Json design_columns(const std::vector<PageDesign>& designs, const std::vector<Objective>& shown);

// Parallel to `shown`: {"low", "high"}, each a column, of the ranked objectives that have bands,
// and null of the others.
Json band_columns(const std::vector<PageDesign>& designs, const std::vector<Objective>& shown,
                  const std::vector<Objective>& ranking);

// [{"name", "title", "unit", "better", "least", "greatest", "count", "meaning"}], "least" and
// "greatest" null where there is none, "count" where values are whole numbers.
Json objectives_json(const std::vector<Objective>& shown, const std::string& cost_unit = "");

}  // namespace reeve::pages
