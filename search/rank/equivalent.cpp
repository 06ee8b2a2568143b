#include "search/rank/equivalent.hpp"

#include <map>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/notation.hpp"
#include "search/rank/tradeoff.hpp"

namespace reeve::search {
namespace {

// Equal values stand together in a front: it is ordered by the last of them.
bool stand_together(const RankedDesign& a, const RankedDesign& b, const Order& order) {
  return a.front == b.front &&
         decisive_value(a.design.values, order) == decisive_value(b.design.values, order);
}

std::vector<double> ranked_values(const RankedDesign& ranked, const std::vector<Objective>& by) {
  std::vector<double> values;
  for (const Objective objective : by) values.push_back(value(ranked.design.values, objective));
  return values;
}

// Calls `visit` with each two or more designs that are equal, by their indices in rising order.
template <typename Visit>
void for_each_equals(const std::vector<RankedDesign>& ranked, const Order& order, Visit visit) {
  const std::vector<Objective> by = ranked_by(order);
  for (std::size_t begin = 0; begin < ranked.size();) {
    std::size_t end = begin + 1;
    while (end < ranked.size() && stand_together(ranked[begin], ranked[end], order)) ++end;
    std::map<std::vector<double>, std::vector<std::size_t>> all;
    for (std::size_t i = begin; i < end && end - begin > 1; ++i) {
      all[ranked_values(ranked[i], by)].push_back(i);
    }
    for (const auto& [values, equals] : all) {
      if (equals.size() > 1) visit(equals);
    }
    begin = end;
  }
}

}  // namespace

std::vector<std::size_t> places(const std::vector<RankedDesign>& ranked, const Order& order) {
  std::vector<std::size_t> result;
  for (const RankedDesign& entry : ranked) result.push_back(entry.rank);
  for_each_equals(ranked, order, [&](const std::vector<std::size_t>& equals) {
    for (const std::size_t i : equals) result[i] = result[equals.front()];
  });
  return result;
}

std::vector<std::size_t> places_of(std::vector<Design> designs, const Order& order) {
  const std::vector<RankedDesign> ranked = rank(std::move(designs), order);
  const std::vector<std::size_t> shared = places(ranked, order);
  std::vector<std::size_t> result(ranked.size());
  for (std::size_t i = 0; i < ranked.size(); ++i) result[ranked[i].given] = shared[i];
  return result;
}

Routing without_bearings(Routing routing, FingerIdentity identity) {
  for (Tendon& tendon : routing.tendons) {
    for (Token& token : tendon.walk) {
      token.tip = TipKind::tube;
      if (token.kind == TokenKind::bearing_join) token.kind = TokenKind::tube_join;
    }
  }
  return canonical(routing, identity);
}

std::vector<std::size_t> first_equivalent(const std::vector<RankedDesign>& ranked,
                                          const std::vector<Routing>& routings, const Order& order,
                                          FingerIdentity identity) {
  std::vector<std::size_t> firsts(ranked.size());
  std::iota(firsts.begin(), firsts.end(), std::size_t{0});
  for_each_equals(ranked, order, [&](const std::vector<std::size_t>& equals) {
    std::unordered_map<std::string, std::size_t> seen;
    for (const std::size_t i : equals) {
      std::string plain = to_word(without_bearings(routings[i], identity));
      firsts[i] = seen.try_emplace(std::move(plain), i).first->second;
    }
  });
  return firsts;
}

}  // namespace reeve::search
