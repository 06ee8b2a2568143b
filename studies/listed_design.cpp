#include "studies/listed_design.hpp"

#include <map>
#include <string_view>
#include <utility>

#include "catalog/catalogue.hpp"
#include "core/notation.hpp"

namespace reeve::studies {

std::vector<ListedDesign> list_designs(std::vector<RankedDesign> ranked,
                                       std::vector<Routing> routings, const DrawnDesigns& drawn,
                                       const Catalogue& catalogue) {
  std::vector<ListedDesign> designs;
  designs.reserve(ranked.size());
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    std::string name = name_of(catalogue, routings[i]);
    designs.push_back(
        {std::move(ranked[i]), std::move(routings[i]), std::move(name), std::nullopt});
    if (!drawn.ranks.empty()) designs.back().distribution = drawn.ranks[i];
    if (!drawn.bands.empty()) designs.back().bands = drawn.bands[i];
    if (!drawn.constraints_met.empty()) designs.back().constraints_met = drawn.constraints_met[i];
  }
  return designs;
}

void mark_places(std::vector<ListedDesign>& designs, const std::vector<std::size_t>& places) {
  for (std::size_t i = 0; i < designs.size(); ++i) designs[i].place = places[i];
}

void mark_equivalent(std::vector<ListedDesign>& designs, const std::vector<std::size_t>& firsts) {
  for (std::size_t i = 0; i < designs.size(); ++i) {
    if (firsts[i] == i) continue;
    ListedDesign& first = designs[firsts[i]];
    designs[i].same_as = first.ranked.design.word;
    first.equivalent.push_back(designs[i].ranked.design.word);
  }
}

ListedLadder list_ladder(const Ladder& ladder, const std::vector<ListedDesign>& listed,
                         const std::optional<PartPrices>& prices, const Catalogue& catalogue) {
  std::map<std::string_view, const ListedDesign*> by_word;
  for (const Rung& rung : ladder.rungs) by_word[rung.design.word] = nullptr;
  if (ladder.affordable) by_word[ladder.affordable->word] = nullptr;
  for (const ListedDesign& design : listed) {
    const auto found = by_word.find(design.ranked.design.word);
    if (found != by_word.end()) found->second = &design;
  }
  const auto as_listed = [&](const Design& design) -> ListedDesign {
    const ListedDesign* found = by_word.at(design.word);
    if (found != nullptr) return *found;
    const Routing routing = parse_routing(design.word);
    return {{design}, routing, name_of(catalogue, routing), std::nullopt};
  };
  ListedLadder result{ladder, {}, std::nullopt, prices ? prices->unit : ""};
  for (const Rung& rung : ladder.rungs) result.rungs.push_back(as_listed(rung.design));
  if (ladder.affordable) result.affordable = as_listed(*ladder.affordable);
  return result;
}

std::optional<SweptDesigns> swept_designs(const std::vector<ListedDesign>& designs,
                                          const SweepOptions& options,
                                          const StudySupervision& supervision) {
  std::vector<Routing> routings;
  for (const ListedDesign& design : designs) routings.push_back(design.routing);
  auto swept = sweep(routings, options, supervision.during("sweeping"));
  if (!swept) return std::nullopt;
  return SweptDesigns{std::move(*swept), designs};
}

}  // namespace reeve::studies
