// How many routings meet constraints on parts: against all that there are, made and filtered.
#include "search/limits/limited_counts.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/canonical.hpp"
#include "core/network.hpp"
#include "core/performance.hpp"
#include "core/routing.hpp"
#include "tests/search/generated.hpp"

namespace reeve::testing {
namespace {

double number_of(const PartCount& parts, Objective objective) {
  switch (objective) {
    case Objective::sheaths:
      return parts.sheaths;
    case Objective::pulleys:
      return parts.pulleys;
    case Objective::knots:
      return parts.knots;
    case Objective::blocks:
      return parts.blocks + parts.bars;
    default:
      return parts.total() - parts.anchors;
  }
}

bool is_one_tree(const Routing& routing) {
  for (const std::size_t tree : trees(routing)) {
    if (tree != 0) return false;
  }
  return true;
}

LimitedCounts filtered(const GeneratorOptions& options,
                       const std::vector<Constraint>& constraints) {
  LimitedCounts counts{0, 0, std::vector<std::uint64_t>(constraints.size(), 0)};
  RoutingGenerator generator(options);
  for (Routing routing; generator.next(routing);) {
    if (!is_actuated(routing)) continue;
    const PartCount parts = core::parts(expand(routing));
    std::size_t failed = constraints.size();
    for (std::size_t c = constraints.size(); c-- > 0;) {
      ObjectiveValues values{};
      const Objective objective = constraints[c].objective;
      value(values, objective) = number_of(parts, objective);
      if (!constraints[c].admits(values)) failed = c;
    }
    if (failed < constraints.size()) {
      ++counts.rejected[failed];
    } else {
      ++counts.meeting;
      counts.one_tendon += is_one_tree(routing) ? 1 : 0;
    }
  }
  return counts;
}

TEST(LimitedCounts, AreThoseOfAllRoutingsFiltered) {
  for (const PartSet& parts : {paper_parts(), full_parts(), all_parts(),
                               linked(in_series(with_blocks(anchored(paper_parts()), 3))),
                               barred(in_series(with_blocks(anchored(paper_parts()), 2))),
                               becketed(passed_twice(with_blocks(anchored(paper_parts()), 2)))}) {
    for (int fingers = 1; fingers <= (parts.blocks > 0 ? 3 : 4); ++fingers) {
      const GeneratorOptions options{parts, fingers};
      for (const std::vector<std::string>& texts : {std::vector<std::string>{"sheaths<=2"},
                                                    {"pulleys>=2", "sheaths<3"},
                                                    {"knots<=0", "parts<=5"},
                                                    {"blocks>=1"},
                                                    {"sheaths==1"}}) {
        SCOPED_TRACE(texts.front() + " of " + std::to_string(fingers));
        const std::vector<Constraint> constraints = constraints_of(texts);
        const LimitedCounts counted = count_limited(options, constraints);
        const LimitedCounts expected = filtered(options, constraints);
        EXPECT_EQ(counted.meeting, expected.meeting);
        EXPECT_EQ(counted.one_tendon, expected.one_tendon);
        EXPECT_EQ(counted.rejected, expected.rejected);
      }
    }
  }
}

TEST(LimitedCounts, RefuseWhatTheyCannotCount) {
  GeneratorOptions options{full_parts(), 3};
  EXPECT_THROW(count_limited(options, constraints_of({"sheaths<=2", "uniformity>=0.5"})),
               InputError);
  EXPECT_THROW(count_limited(options, constraints_of({"sheaths<=20", "pulleys<=20", "knots<=20"})),
               InputError);
  options.identity = FingerIdentity::distinct;
  EXPECT_THROW(count_limited(options, constraints_of({"sheaths<=2"})), InputError);
}

}  // namespace
}  // namespace reeve::testing
