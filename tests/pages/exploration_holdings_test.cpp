#include "pages/exploration/exploration_holdings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "pages/exploration/exploration_designs.hpp"
#include "tests/pages/explored.hpp"

namespace reeve {
namespace {

constexpr std::size_t room = 2'000'000;  // bytes

TEST(HeldDesigns, AreAllWhereThereIsRoom) {
  EXPECT_EQ(pages::held_designs(testing::large(500)).listed, 500U);
}

// Neither more than there is room for, nor much less.
TEST(HeldDesigns, FillTheRoomWhereTheyAreFarTooMany) {
  const pages::HeldDesigns held = pages::held_designs(testing::large(100'000));
  EXPECT_LT(held.listed, 80'000U);
  EXPECT_EQ(held.designs.size(), held.listed);
  EXPECT_LE(held.packed.size(), room);
  EXPECT_GT(held.packed.size(), room * 9 / 10);
}

TEST(HeldDesigns, AreCountedInWords) {
  ExploreReport report = testing::large(200);
  EXPECT_EQ(pages::held_text(report, 200),
            "200 of 200 ranked designs are listed. 2 of them are on the front.");
  report.front.resize(1);
  EXPECT_EQ(
      pages::held_text(report, 50),
      "200 of 200 ranked designs are listed; this page holds the first 50. 1 of them is on the front.");
}

ListedDesign unlisted(std::size_t number) {
  ListedDesign design;
  design.routing = testing::numbered_routing(number);
  design.ranked.design.word = to_word(design.routing);
  return design;
}

// The answer and the trade-off name designs beyond the list: the page holds and draws
// them all the same.
TEST(NamedDesigns, AreHeldAndDrawnWhereTheListEndsBeforeThem) {
  ExploreReport report = testing::large(200);
  ListedTradeoff& tradeoff = report.tradeoff;
  tradeoff.affordable = unlisted(1000);
  tradeoff.with_bars = unlisted(1001);
  tradeoff.never_jams = unlisted(1002);
  tradeoff.choice = {unlisted(1003), unlisted(1004)};
  tradeoff.steps = {unlisted(1000), unlisted(1005)};
  report.robust_first = RobustFirst{{unlisted(1006)}, {unlisted(1006)}};
  ExplorationView view = testing::view(report);
  view.details = 0;
  std::vector<std::string> held;
  for (const pages::PageDesign& design : pages::page_designs(report, 10)) {
    held.push_back(design.word);
  }
  std::vector<std::string> drawn;
  for (const Routing* routing : pages::detailed_designs(view).whole) {
    drawn.push_back(to_word(*routing));
  }
  for (std::size_t number = 1000; number <= 1006; ++number) {
    const std::string word = unlisted(number).ranked.design.word;
    EXPECT_EQ(std::count(held.begin(), held.end(), word), 1) << number;
    EXPECT_EQ(std::count(drawn.begin(), drawn.end(), word), 1) << number;
    EXPECT_EQ(pages::standings_json(report)[word],
              "Named in the answer; not among the listed designs.");
  }
}

TEST(Standings, SayWhyAKnownRoutingIsNotInTheList) {
  ExploreReport report;
  report.options.constraints.push_back(parse_constraint("sheaths<=2"));
  ReferenceStanding standing;
  standing.design.word = "M-1-F";
  standing.dominated_by = 7;
  const auto says = [&](const std::string& why) {
    report.result.references = {standing};
    EXPECT_EQ(pages::standings_json(report)["M-1-F"],
              "Known routing, not among the listed designs: " + why + ".");
  };
  standing.generated = false;
  says("these parts, or this shard, do not give it");
  report.result.partial = true;
  says("it was not reached before the exploration stopped");
  standing.generated = true;
  says("its rank is beyond the list, and 7 designs dominate it");
  standing.rejected_by = 0;
  says("it fails sheaths<=2");
}

}  // namespace
}  // namespace reeve
