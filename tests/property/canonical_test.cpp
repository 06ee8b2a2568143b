#include "core/canonical.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "tests/property/any_routing.hpp"
#include "tests/property/rewritten.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::disguised;
using testing::renamed;

Dice any_dice() { return Dice(*rc::gen::arbitrary<std::uint64_t>()); }

// Without wrap angles routings have more symmetries, with them more to keep apart.
RC_GTEST_PROP(CanonicalProperty, DoesNotDependOnHowTendonsAreWalkedAndListedNorOnNames, ()) {
  Dice dice = any_dice();
  for (const Routing& routing : {*testing::any_routing(), *testing::any_angled_routing()}) {
    for (const FingerIdentity identity : {FingerIdentity::identical, FingerIdentity::distinct}) {
      const Routing once = canonical(routing, identity);
      RC_ASSERT(canonical(once, identity) == once);
      RC_ASSERT(canonical(disguised(routing, dice), identity) == once);
    }
    RC_ASSERT(canonical(disguised(renamed(routing, dice), dice), FingerIdentity::identical) ==
              canonical(routing, FingerIdentity::identical));
  }
}

RC_GTEST_PROP(CanonicalProperty, OfSecondTendonsDoesNotDependOnHowTheyAreWritten, ()) {
  Dice dice = any_dice();
  const Routing routing = testing::with_several_motors(dice, testing::random_shared_routing(dice));
  RC_ASSERT(parse_routing(to_word(routing)) == routing);
  for (const FingerIdentity identity : {FingerIdentity::identical, FingerIdentity::distinct}) {
    const Routing once = canonical(routing, identity);
    RC_ASSERT(canonical(once, identity) == once);
    RC_ASSERT(canonical(disguised(routing, dice), identity) == once);
  }
  RC_ASSERT(canonical(disguised(renamed(routing, dice), dice), FingerIdentity::identical) ==
            canonical(routing, FingerIdentity::identical));
}

RC_GTEST_PROP(CanonicalProperty, OfIdenticalFingersNumbersMotorsInTheOrderOfTheWord, ()) {
  const Routing routing = canonical(*testing::any_routing(), FingerIdentity::identical);
  int highest = 0;
  for (const Tendon& tendon : routing.tendons) {
    for (const Token& token : tendon.walk) {
      if (!is_on_carriage(token.kind)) continue;
      RC_ASSERT(token.carriage <= highest + 1);
      highest = std::max<int>(highest, token.carriage);
    }
  }
}

// The angles in the order of the canonical word are as many, and the same.
RC_GTEST_PROP(CanonicalProperty, KeepsWrapAngles, ()) {
  const Routing routing = *testing::any_angled_routing();
  const auto angles = [](const Routing& of) {
    std::vector<WrapAngle> all;
    for (const Tendon& tendon : of.tendons) {
      for (const Token& token : tendon.walk) all.push_back(token.angle);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  RC_ASSERT(angles(canonical(routing, FingerIdentity::identical)) == angles(routing));
}

// What stands next to each finger, in either order.
using Neighbours = std::map<int, std::vector<std::tuple<TokenKind, int, int>>>;

void add_neighbours(const Tendon& tendon, Neighbours& neighbours) {
  const std::size_t n = tendon.walk.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (tendon.walk[i].kind != TokenKind::finger) continue;
    for (const std::size_t j : {(i + n - 1) % n, (i + 1) % n}) {
      neighbours[tendon.walk[i].finger].emplace_back(tendon.walk[j].kind, tendon.walk[j].finger,
                                                     tendon.walk[j].carriage);
    }
    auto& both = neighbours[tendon.walk[i].finger];
    std::sort(both.begin(), both.end());
    both.emplace_back(TokenKind::finger, static_cast<int>(tendon.walk[i].tip), 1);
  }
}

Neighbours neighbours_of(const Routing& routing) {
  Neighbours neighbours;
  for (const Tendon& tendon : routing.tendons) add_neighbours(tendon, neighbours);
  return neighbours;
}

RC_GTEST_PROP(CanonicalProperty, OfDistinctFingersKeepsEachFingerBetweenItsParts, ()) {
  const Routing routing = *testing::any_routing();
  RC_ASSERT(neighbours_of(canonical(routing, FingerIdentity::distinct)) == neighbours_of(routing));
}

RC_GTEST_PROP(CanonicalProperty, OfIdenticalFingersNumbersThemInTheOrderOfTheWord, ()) {
  const Routing routing = canonical(*testing::any_routing(), FingerIdentity::identical);
  int next = 1;
  for (const Tendon& tendon : routing.tendons) {
    for (const Token& token : tendon.walk) {
      if (token.kind == TokenKind::finger) RC_ASSERT(token.finger == next++);
    }
  }
}

RC_GTEST_PROP(CanonicalProperty, ATendonIsCanonicalOnlyAsTheCanonicalFormHasIt, ()) {
  for (const Tendon& tendon : (*testing::any_routing()).tendons) {
    const Routing least = canonical(Routing{{tendon}}, FingerIdentity::distinct);
    RC_ASSERT(is_canonical(tendon) == (least.tendons[0] == tendon));
  }
}

}  // namespace
}  // namespace reeve
