#include "tests/support/sound_mechanism.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/support/reference_tree.hpp"
#include "tests/support/reference_walk.hpp"

namespace reeve::testing {

namespace {

// The blocks that one tendon is tied to or passes, and those whose tails it is.
struct Ties {
  std::set<std::string> blocks;
  int tails = 0;
};

std::vector<Ties> ties_of(const std::vector<reference::Tendon>& tendons) {
  std::vector<Ties> ties(tendons.size());
  for (std::size_t t = 0; t < tendons.size(); ++t) {
    for (const auto& pass : tendons[t].passes) ties[t].blocks.insert(pass.block);
    for (const auto& end : tendons[t].ends) {
      ties[t].blocks.insert(end.block);
      ties[t].tails += end.becket ? 0 : 1;
    }
  }
  return ties;
}

// Whether tendons and blocks join in no ring: a tendon meets each piece of what came before it at
// one block.
bool is_without_ring(const std::vector<Ties>& ties) {
  std::vector<std::set<std::string>> pieces;
  for (const Ties& tendon : ties) {
    std::set<std::string> joined = tendon.blocks;
    std::vector<std::set<std::string>> rest;
    for (const auto& piece : pieces) {
      std::vector<std::string> common;
      std::set_intersection(piece.begin(), piece.end(), tendon.blocks.begin(), tendon.blocks.end(),
                            std::back_inserter(common));
      if (common.size() > 1) return false;
      if (common.empty())
        rest.push_back(piece);
      else
        joined.insert(piece.begin(), piece.end());
    }
    rest.push_back(joined);
    pieces = std::move(rest);
  }
  return true;
}

// In a ring a tension may be the difference of others, and with friction none: the mechanism locks.
// Not where each tension is the sum of others from the first tendon on.
bool cannot_lock(const std::vector<reference::Tendon>& tendons) {
  const std::vector<Ties> ties = ties_of(tendons);
  if (is_without_ring(ties)) return true;
  std::map<std::string, int> tails;
  for (const auto& tendon : tendons)
    for (const auto& end : tendon.ends) tails[end.block] += end.becket ? 0 : 1;
  return std::all_of(ties.begin(), ties.end(), [](const Ties& t) { return t.tails < 2; }) &&
         std::all_of(tails.begin(), tails.end(), [](const auto& t) { return t.second == 1; });
}

}  // namespace

bool is_sound_mechanism(const std::string& word, int blocks) {
  const std::vector<reference::Tendon> tendons = reference::read_tendons(word);
  std::set<std::string> names;
  for (const reference::Tendon& tendon : tendons)
    for (const auto& end : tendon.ends) names.insert(end.block);
  if (static_cast<int>(names.size()) != blocks) return false;
  try {
    reference::pose_trees(tendons, {}, ReferenceDirection::pull, {});
    return cannot_lock(tendons);
  } catch (const std::invalid_argument&) {
    return false;
  }
}

}  // namespace reeve::testing
