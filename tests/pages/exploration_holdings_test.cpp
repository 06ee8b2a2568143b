#include "pages/exploration/exploration_holdings.hpp"

#include <gtest/gtest.h>

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
