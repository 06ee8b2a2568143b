// The reference model on random mechanisms with blocks: against its solver of single tendons,
// against pulling in small steps, and against what holds for any of them. The library solves none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "core/notation.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/random_routing.hpp"
#include "tests/support/reference_comparison.hpp"
#include "tests/support/reference_loading.hpp"
#include "tests/support/reference_model.hpp"
#include "tests/support/reference_tree_solve.hpp"
#include "tests/support/reference_walk.hpp"

namespace reeve {
namespace {

using testing::Dice;
using testing::ReferenceDirection;
using testing::ReferenceHardware;
using testing::ReferenceResult;
using testing::work_on_fingers;

TEST(ReferenceMechanisms, SingleTendonsAreSolvedAlikeByBothSolvers) {
  int jams = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Dice dice(seed);
    const std::string word = to_word(testing::random_routing(dice));
    const ReferenceHardware hardware = testing::random_reference_hardware(dice, word);
    std::set<int> held;
    for (int finger = 1; finger <= 6; ++finger)
      if (dice.chance(0.4)) held.insert(finger);
    const auto direction =
        dice.chance(0.5) ? ReferenceDirection::pull : ReferenceDirection::release;
    const ReferenceResult single = testing::reference_tensions(word, held, direction, hardware);
    const ReferenceResult tree = testing::reference::solve_trees(
        testing::reference::read_tendons(word), held, direction, hardware);
    EXPECT_EQ(testing::disagreement(word, single, tree, {1e-9, 0, 1e-12}), "")
        << seed << " " << word;
    jams += single.jams;
  }
  EXPECT_GT(jams, 50);
  EXPECT_LT(jams, 450);
}

struct Tally {
  int moving = 0, jammed = 0, slack = 0, refused = 0;
};

// Strands and beckets of each block less its tails, by the tensions of the result.
void expect_blocks_in_balance(const std::string& word, const ReferenceResult& result) {
  std::map<std::string, double> pull, size;
  for (const auto& tendon : testing::reference::read_tendons(word)) {
    const auto add = [&](const std::string& block, std::size_t segment, double sign) {
      const double tension = result.tension.at(tendon.segments[segment].name);
      pull[block] += sign * tension;
      size[block] += tension;
    };
    for (const auto& pass : tendon.passes) {
      add(pass.block, pass.contact, 1);
      add(pass.block, (pass.contact + 1) % tendon.segments.size(), 1);
    }
    for (const auto& end : tendon.ends) add(end.block, end.segment, end.becket ? 1 : -1);
  }
  for (const auto& [block, off] : pull) EXPECT_LE(std::abs(off), 1e-12 * size[block]) << block;
}

void expect_contacts_in_their_cones(const ReferenceResult& result) {
  for (const auto& contact : result.contacts) {
    const double left = result.tension.at(contact.left), right = result.tension.at(contact.right);
    if (contact.kind == "bar" || left == 0) continue;
    const double difference = std::log(left / right);
    EXPECT_LE(std::abs(difference), contact.phi + 1e-9) << contact.left << "-" << contact.right;
    if (contact.slip == 0) continue;
    EXPECT_NEAR(difference, std::copysign(contact.phi, -contact.slip), 1e-9)
        << contact.left << "-" << contact.right;
  }
}

void try_mechanism(std::uint64_t seed, bool friction, Tally& tally) {
  Dice dice(seed);
  const std::string word = testing::random_mechanism(dice);
  ReferenceHardware hardware = testing::random_reference_hardware(dice, word);
  if (!friction)
    hardware.phi_override = [](const std::string&, const std::string&, double) { return 0.0; };
  std::set<int> held;
  for (int finger = 1; finger <= 5; ++finger)
    if (dice.chance(0.3)) held.insert(finger);
  const auto direction = dice.chance(0.5) ? ReferenceDirection::pull : ReferenceDirection::release;
  SCOPED_TRACE(std::to_string(seed) + " " + word);
  ReferenceResult result;
  try {
    result = testing::reference_tensions(word, held, direction, hardware);
  } catch (const std::invalid_argument&) {
    ++tally.refused;
    return;
  }
  expect_blocks_in_balance(word, result);
  expect_contacts_in_their_cones(result);
  const bool slack = std::any_of(result.tension.begin(), result.tension.end(),
                                 [](const auto& segment) { return segment.second == 0; });
  ++(result.jams ? tally.jammed : slack ? tally.slack : tally.moving);
  if (result.jams || slack) return;
  const double work = work_on_fingers(result);
  if (!friction) {
    EXPECT_NEAR(work, 1, 1e-9);
  } else if (direction == ReferenceDirection::pull) {
    EXPECT_LE(work, 1 + 1e-12);
  } else {
    EXPECT_GE(work, 1 - 1e-12);
  }
}

TEST(ReferenceMechanisms, AnyMechanismIsSolvedWithBlocksInBalanceAndNoWorkWon) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) try_mechanism(seed, true, tally);
  EXPECT_GT(tally.moving, 2000);
  EXPECT_GT(tally.jammed, 200);
  EXPECT_LT(tally.refused, 30);
}

TEST(ReferenceMechanisms, WithoutFrictionAllWorkArrivesAtTheFingers) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) try_mechanism(seed, false, tally);
  EXPECT_GT(tally.moving, 1300);
  EXPECT_LT(tally.refused, 20);
}

double greatest_difference(const ReferenceResult& limit,
                           const std::map<std::string, double>& loaded) {
  double greatest = 0;
  for (const auto& [segment, tension] : limit.tension)
    greatest = std::max(greatest, std::abs(loaded.at(segment) - tension) / std::max(1.0, tension));
  return greatest;
}

// Four times the steps leave a quarter of what the start of the loading has left.
TEST(ReferenceMechanisms, PullingInSmallStepsLeadsToTheLimitInProportionToTheStep) {
  int compared = 0, approached = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Dice dice(seed);
    const std::string word = testing::random_mechanism(dice);
    const ReferenceHardware hardware = testing::random_reference_hardware(dice, word);
    std::set<int> held;
    for (int finger = 1; finger <= 5; ++finger)
      if (dice.chance(0.3)) held.insert(finger);
    SCOPED_TRACE(std::to_string(seed) + " " + word);
    const ReferenceResult limit =
        testing::reference_tensions(word, held, ReferenceDirection::pull, hardware);
    if (limit.jams) continue;
    try {
      const double coarse =
          greatest_difference(limit, testing::loaded_tensions(word, held, hardware, 20));
      const double fine =
          greatest_difference(limit, testing::loaded_tensions(word, held, hardware, 80));
      EXPECT_LE(fine, 0.35 * coarse + 1e-9);
      ++compared;
      approached += coarse > 1e-6;
    } catch (const std::logic_error&) {
    }
  }
  EXPECT_GT(compared, 80);
  EXPECT_GT(approached, 10);
}

}  // namespace
}  // namespace reeve
