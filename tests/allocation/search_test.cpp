// Evaluating routing after routing, and generating them, allocates nothing once warm: memory that
// is asked for in the inner loop of an exploration would cost more than the tensions.
#include <cstdint>
#include <vector>

#include "causes/library.hpp"
#include "search/enumerate/generator.hpp"
#include "search/evaluate/deciding_evaluation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "tests/allocation/allocations.hpp"
#include "tests/support/example_hand.hpp"

namespace reeve {
namespace {

using testing::Allocation;
using testing::allocations_in;

GeneratorOptions all_of_four_fingers() {
  return {full_parts(), 4, FingerIdentity::identical, false};
}

std::vector<Routing> actuated() {
  RoutingGenerator generator(all_of_four_fingers());
  std::vector<Routing> routings;
  for (Routing routing; generator.next(routing);) {
    if (is_actuated(routing)) routings.push_back(routing);
  }
  return routings;
}

void expect_no_allocation_once_warm(const Model& model, const std::vector<Routing>& routings) {
  DesignEvaluator evaluator(model, single_grasps(4));
  double sum = 0;
  const auto pass = [&] {
    for (const Routing& routing : routings) {
      sum += value(evaluator.evaluate(routing), Objective::uniformity_mean);
    }
  };
  const std::uint64_t warming = allocations_in(pass);
  const std::uint64_t warm = allocations_in(pass);
  EXPECT_GT(warming, 0U);
  EXPECT_LT(warming, 1000U);
  EXPECT_EQ(warm, 0U) << "for " << routings.size() << " routings";
  EXPECT_GT(sum, 0);
}

TEST_F(Allocation, HappensInNoEvaluationOnceTheEvaluatorIsWarm) {
  const std::vector<Routing> routings = actuated();
  ASSERT_GT(routings.size(), 2000U);
  expect_no_allocation_once_warm(Model{}, routings);
}

TEST_F(Allocation, DoesNotHappenWhenKnownTreesAreSolved) {
  const std::vector<Routing> routings = actuated();
  DecidingEvaluator evaluator({}, single_grasps(4), authors_score(), std::nullopt,
                              {Objective::uniformity_mean, Objective::efficiency_mean});
  double sum = 0;
  const auto pass = [&] {
    for (const Routing& routing : routings) {
      sum += value(evaluator.evaluate(routing), Objective::uniformity_mean);
    }
  };
  pass();
  EXPECT_EQ(allocations_in(pass), 0U);
  EXPECT_GT(sum, 0);
}

TEST_F(Allocation, HappensInNoEvaluationOfAHandEither) {
  Model model;
  model.hardware.finger_parts = testing::three_joint_finger();
  std::vector<Routing> routings = actuated();
  routings.resize(2000);
  ASSERT_TRUE(has_hand(DesignEvaluator(model, single_grasps(4)).evaluate(routings.front())));
  expect_no_allocation_once_warm(model, routings);
}

TEST_F(Allocation, HappensInNoEvaluationUnderAModelEither) {
  Model model;
  add_effect(model, {find_cause("load_dependent_friction"), {}, {0.1}});
  add_effect(model, {find_cause("wear"), {}, {0.1, 100}});
  std::vector<Routing> routings = actuated();
  routings.resize(2000);
  expect_no_allocation_once_warm(model, routings);
}

void expect_no_allocation_once_warm(const GeneratorOptions& options) {
  RoutingGenerator generator(options);
  Routing routing;
  std::uint64_t given = 0;
  const auto pass = [&] {
    while (generator.next(routing)) ++given;
  };
  const std::uint64_t warming = allocations_in(pass);
  const std::uint64_t seeking = allocations_in([&] { generator.seek(0); });
  const std::uint64_t warm = allocations_in(pass);
  EXPECT_GT(warming, 0U);
  EXPECT_LT(warming, 1000U);
  EXPECT_EQ(seeking, 0U);
  EXPECT_EQ(warm, 0U);
  EXPECT_EQ(given, 2 * generator.total());
}

TEST_F(Allocation, HappensInNoGenerationOnceTheGeneratorIsWarm) {
  expect_no_allocation_once_warm(all_of_four_fingers());
  expect_no_allocation_once_warm({all_parts(), 4, FingerIdentity::identical, false});
}

void expect_no_allocation(const GeneratorOptions& options) {
  RoutingGenerator generator(options);
  ASSERT_GT(generator.total(), 110000U);
  Routing routing;
  generator.seek(generator.total() - 1);  // a tendon for each finger
  generator.next(routing);
  generator.seek(generator.total() / 3);
  for (int i = 0; i < 1000; ++i) generator.next(routing);
  EXPECT_EQ(allocations_in([&] {
              for (int i = 0; i < 100000; ++i) generator.next(routing);
            }),
            0U);
}

TEST_F(Allocation, DoesNotGrowWithTheNumberOfRoutingsGenerated) {
  expect_no_allocation({full_parts(), 6, FingerIdentity::identical, false});
  expect_no_allocation({full_parts(), 8, FingerIdentity::identical, true});
  expect_no_allocation({paper_parts(), 6, FingerIdentity::distinct, false});
  PartSet anchored = full_parts();
  anchored.anchored = true;
  expect_no_allocation({anchored, 5, FingerIdentity::identical, false});
}

}  // namespace
}  // namespace reeve
