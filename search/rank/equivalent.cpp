#include "search/rank/equivalent.hpp"

#include <map>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/notation.hpp"
#include "search/rank/ladder.hpp"

namespace reeve::search {
namespace {

// Equal values stand together in a front: it is ordered by the last of them.
using Standing = std::pair<int, double>;

Standing standing(const RankedDesign& ranked, const Order& order) {
  return {ranked.front, decisive_value(ranked.design.values, order)};
}

std::vector<double> ranked_values(const RankedDesign& ranked, const Order& order) {
  std::vector<double> values;
  for (const Objective objective : ranked_by(order)) {
    values.push_back(value(ranked.design.values, objective));
  }
  return values;
}

// Designs that are equal in what is ranked, in the order of the ranking.
using Equals = std::vector<std::size_t>;

void mark_firsts(const Equals& equals, const std::vector<Routing>& routings,
                 FingerIdentity identity, std::vector<std::size_t>& firsts) {
  if (equals.size() < 2) return;
  std::unordered_map<std::string, std::size_t> seen;
  for (const std::size_t i : equals) {
    std::string plain = to_word(without_bearings(routings[i], identity));
    firsts[i] = seen.try_emplace(std::move(plain), i).first->second;
  }
}

}  // namespace

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
  for (std::size_t begin = 0; begin < ranked.size();) {
    std::size_t end = begin + 1;
    const Standing here = standing(ranked[begin], order);
    while (end < ranked.size() && standing(ranked[end], order) == here) ++end;
    std::map<std::vector<double>, Equals> all;
    for (std::size_t i = begin; i < end && end - begin > 1; ++i) {
      all[ranked_values(ranked[i], order)].push_back(i);
    }
    for (const auto& [values, equals] : all) mark_firsts(equals, routings, identity, firsts);
    begin = end;
  }
  return firsts;
}

}  // namespace reeve::search
