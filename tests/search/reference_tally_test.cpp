#include "search/reference_tally.hpp"

#include <gtest/gtest.h>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"

namespace reeve::testing {
namespace {

class TallyOfTwo : public ::testing::Test {
 protected:
  TallyOfTwo() {
    options.grasps = single_grasps(2);
    options.references = {parse_routing("M-1-T-2-F"), loop};
    references.resize(2);
  }

  std::uint64_t dominators(const ReferenceTally& tally) {
    tally.add_up(references);
    return references[0].dominated_by;
  }

  const Routing loop = parse_routing("1-P-2-P-1");
  ExploreOptions options;
  std::vector<ReferenceCount> references;
};

// What was evaluated behind the end of a stopped search was not seen.
TEST_F(TallyOfTwo, IsAsBeforeWhenARoutingIsTakenOff) {
  ReferenceTally tally(options, 2);
  DesignEvaluator evaluator(options.model, options.grasps, options.score, options.prices);
  const ObjectiveValues values = evaluator.evaluate(loop);
  const EvaluatedRouting evaluated{loop, values, 0};
  tally.count(evaluated, 1, references);
  EXPECT_EQ(dominators(tally), 1U);
  EXPECT_TRUE(references[1].generated);
  tally.take_off(evaluated, references);
  EXPECT_EQ(dominators(tally), 0U);
  EXPECT_FALSE(references[1].generated);
}

}  // namespace
}  // namespace reeve::testing
