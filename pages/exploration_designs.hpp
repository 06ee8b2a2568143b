// The designs that the page of an exploration holds, in columns: its plots, its table and its
// filters work on these. assets/exploration_charts.js describes them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "reports/explore_report.hpp"
#include "reports/json.hpp"

namespace reeve {

// What a design is here for, as the scripts count it.
enum class Kind : std::uint8_t { listed, front, known, sample };

// The longer of top and front: both are the beginning of one ranking.
const std::vector<ListedDesign>& listed_designs(const ExploreReport& report);

// Of the listed designs the first `most`, then the known routings that are not among these, then
// the random sample. {"word", "name", "rank", "front", "kind", "values", "distribution"}
Json design_columns(const ExploreReport& report, std::size_t most);

// {"objectives", "ranking", "designs"}
Json chart_data(const ExploreReport& report, Json columns);

}  // namespace reeve
