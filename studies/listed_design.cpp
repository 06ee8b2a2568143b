#include "studies/listed_design.hpp"

#include "catalog/names.hpp"

namespace reeve::studies {

std::vector<ListedDesign> list_designs(const std::vector<RankedDesign>& ranked,
                                       const std::vector<Routing>& routings,
                                       const std::vector<RankDistribution>& distributions,
                                       const Catalogue& catalogue) {
  std::vector<ListedDesign> designs;
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    designs.push_back({ranked[i], routings[i], name_of(catalogue, routings[i]), std::nullopt});
    if (!distributions.empty()) designs.back().distribution = distributions[i];
  }
  return designs;
}

}  // namespace reeve::studies
