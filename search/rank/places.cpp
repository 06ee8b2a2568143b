#include "search/rank/places.hpp"

#include <map>

#include "search/rank/ladder.hpp"

namespace reeve::search {
namespace {

// Equal designs stand together in a front, but for others with the same of what orders there.
bool stand_together(const RankedDesign& a, const RankedDesign& b, const Order& order) {
  return a.front == b.front &&
         decisive_value(a.design.values, order) == decisive_value(b.design.values, order);
}

std::vector<double> values_of(const RankedDesign& ranked, const std::vector<Objective>& by) {
  std::vector<double> values;
  for (const Objective objective : by) values.push_back(value(ranked.design.values, objective));
  return values;
}

}  // namespace

std::vector<std::size_t> places(const std::vector<RankedDesign>& ranked, const Order& order) {
  const std::vector<Objective> by = ranked_by(order);
  std::vector<std::size_t> result;
  for (const RankedDesign& entry : ranked) result.push_back(entry.rank);
  for (std::size_t begin = 0; begin < ranked.size();) {
    std::size_t end = begin + 1;
    while (end < ranked.size() && stand_together(ranked[begin], ranked[end], order)) ++end;
    std::map<std::vector<double>, std::size_t> seen;
    for (std::size_t i = begin; i < end && end - begin > 1; ++i) {
      result[i] = seen.try_emplace(values_of(ranked[i], by), result[i]).first->second;
    }
    begin = end;
  }
  return result;
}

}  // namespace reeve::search
