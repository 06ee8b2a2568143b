// A ranked design with what the catalogue and drawn coefficients say of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "core/routing.hpp"
#include "search/judge/ranking.hpp"
#include "search/uncertainty/uncertainty.hpp"

namespace reeve::studies {

struct ListedDesign {
  RankedDesign ranked;
  Routing routing;
  std::string name;  // "" if it has none
  // Only where uncertainty was asked for.
  std::optional<RankDistribution> distribution;
};

// `routings` begins parallel to `ranked`, and so does `distributions` or is empty.
std::vector<ListedDesign> list_designs(const std::vector<RankedDesign>& ranked,
                                       const std::vector<Routing>& routings,
                                       const std::vector<RankDistribution>& distributions,
                                       const Catalogue& catalogue);

}  // namespace reeve::studies
