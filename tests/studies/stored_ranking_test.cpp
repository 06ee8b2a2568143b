#include "studies/stored_ranking.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace reeve::testing {
namespace {

ExploreOptions ranked(const std::string& objectives, const std::vector<std::string>& constraints,
                      std::size_t top, const std::string& score = "uniformity=1") {
  ExploreOptions options;
  options.order.objectives = parse_objectives(objectives);
  for (const std::string& text : constraints) {
    options.constraints.push_back(parse_constraint(text));
  }
  options.top = top;
  options.score = parse_score(score);
  return options;
}

// A store of the best forty by uniformity, with at most six sheaths.
TEST(StoredRanking, IsInexactForEachGapBetweenWhatIsStoredAndAsked) {
  const ExploreOptions stored = ranked("uniformity,jams", {"sheaths<=6"}, 40);
  const auto of = [&](const ExploreOptions& asked) { return gaps(stored, asked); };
  using Gaps = std::vector<Gap>;
  EXPECT_EQ(of(stored), Gaps{});
  EXPECT_EQ(of(ranked("uniformity,jams", {"sheaths<=6"}, 41)), Gaps{Gap::more_than_kept});
  EXPECT_EQ(of(ranked("uniformity,jams", {}, 40)), Gaps{Gap::constraint_dropped});
  EXPECT_EQ(of(ranked("jams", {"sheaths<=6"}, 40)), Gaps{Gap::other_order});
  // Another score decides nothing here.
  EXPECT_EQ(of(ranked("uniformity,jams", {"sheaths<=6"}, 40, "jams=1")), Gaps{});
  // What is better than a design meets these two too, and perhaps not the others.
  for (const char* bound : {"uniformity>=0.8", "jams<=1"}) {
    EXPECT_EQ(of(ranked("uniformity,jams", {"sheaths<=6", bound}, 40)), Gaps{}) << bound;
  }
  for (const char* bound : {"uniformity<=0.8", "jams>=1", "pulleys<=0"}) {
    EXPECT_EQ(of(ranked("uniformity,jams", {"sheaths<=6", bound}, 40)),
              Gaps{Gap::constraint_elsewhere})
        << bound;
  }
}

}  // namespace
}  // namespace reeve::testing
