#include "search/rank/ladder_archive.hpp"

#include <algorithm>
#include <utility>

#include "search/rank/ladder.hpp"

namespace reeve::search {
namespace {

Order with_measure(const Order& order, Objective by) {
  std::vector<Objective> objectives = ranked_by(order);
  if (std::find(objectives.begin(), objectives.end(), by) == objectives.end()) {
    objectives.push_back(by);
  }
  return {std::move(objectives), order.by_score};
}

}  // namespace

LadderArchive::LadderArchive(const Order& order, Objective by)
    : archive_(with_measure(order, by), 1) {}

void LadderArchive::add(Design design) { archive_.add(std::move(design)); }

std::vector<Design> LadderArchive::candidates() {
  std::vector<Design> designs;
  for (RankedDesign& ranked : archive_.content().ranked)
    designs.push_back(std::move(ranked.design));
  return designs;
}

}  // namespace reeve::search
