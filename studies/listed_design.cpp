#include "studies/listed_design.hpp"

#include <map>
#include <string_view>

#include "catalog/names.hpp"
#include "core/notation.hpp"
#include "search/decide/alike.hpp"
#include "search/decide/places.hpp"

namespace reeve::studies {

std::vector<ListedDesign> list_designs(const std::vector<RankedDesign>& ranked,
                                       const std::vector<Routing>& routings,
                                       const DrawnDesigns& drawn, const Catalogue& catalogue) {
  std::vector<ListedDesign> designs;
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    designs.push_back({ranked[i], routings[i], name_of(catalogue, routings[i]), std::nullopt});
    if (!drawn.ranks.empty()) designs.back().distribution = drawn.ranks[i];
    if (!drawn.bands.empty()) designs.back().bands = drawn.bands[i];
    if (!drawn.constraints_met.empty()) designs.back().constraints_met = drawn.constraints_met[i];
  }
  return designs;
}

void mark_places(std::vector<ListedDesign>& designs, const Order& order) {
  std::vector<RankedDesign> ranked;
  for (const ListedDesign& design : designs) ranked.push_back(design.ranked);
  const std::vector<std::size_t> shared = places(ranked, order);
  for (std::size_t i = 0; i < designs.size(); ++i) designs[i].place = shared[i];
}

void mark_alike(std::vector<ListedDesign>& designs, const Order& order, FingerIdentity identity) {
  std::vector<RankedDesign> ranked;
  std::vector<Routing> routings;
  for (const ListedDesign& design : designs) {
    ranked.push_back(design.ranked);
    routings.push_back(design.routing);
  }
  const std::vector<std::size_t> firsts = first_alike(ranked, routings, order, identity);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    if (firsts[i] == i) continue;
    designs[i].same_as = ranked[firsts[i]].design.word;
    designs[firsts[i]].alike.push_back(ranked[i].design.word);
  }
}

ListedLadder list_ladder(const Ladder& ladder, const std::vector<ListedDesign>& listed,
                         const std::optional<PartPrices>& prices, const Catalogue& catalogue) {
  std::map<std::string_view, const ListedDesign*> by_word;
  for (const ListedDesign& design : listed) by_word[design.ranked.design.word] = &design;
  const auto as_listed = [&](const Design& design) -> ListedDesign {
    const auto found = by_word.find(design.word);
    if (found != by_word.end()) return *found->second;
    const Routing routing = parse_routing(design.word);
    return {{design}, routing, name_of(catalogue, routing), std::nullopt};
  };
  ListedLadder result{ladder, {}, std::nullopt, prices ? prices->unit : ""};
  for (const Rung& rung : ladder.rungs) result.rungs.push_back(as_listed(rung.design));
  if (ladder.affordable) result.affordable = as_listed(*ladder.affordable);
  return result;
}

}  // namespace reeve::studies
