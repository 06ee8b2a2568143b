// A ranked design with what the catalogue and drawn coefficients say of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "search/judge/ranking.hpp"
#include "search/uncertainty/uncertainty.hpp"

namespace reeve::studies {

struct ListedDesign {
  RankedDesign ranked;
  std::string name;  // "" if it has none
  // Only where uncertainty was asked for.
  std::optional<RankDistribution> distribution;
};

// `distributions` is parallel to `ranked`, or empty.
std::vector<ListedDesign> list_designs(const std::vector<RankedDesign>& ranked,
                                       const std::vector<RankDistribution>& distributions,
                                       const Catalogue& catalogue);

}  // namespace reeve::studies
