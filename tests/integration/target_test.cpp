// `explore --target` from end to end, and how many distinct designs a front has.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

const std::string thumb_hardware = REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml";

TEST(ExploredTarget, IsFoundByStaticsWithAFloatingPulley) {
  const Explored thumb(Arguments{"--fingers", "3", "--parts", "all", "--hardware", thumb_hardware,
                                 "--target", "1=2,others=1"});
  ASSERT_EQ(thumb.result.exit_code, 0) << thumb.result.err;
  const Json target = thumb.summary()["target"];
  const Json& first = target["designs"][0];
  EXPECT_EQ(first["by_statics"], true);
  EXPECT_EQ(first["hangs_on_friction"], false);
  EXPECT_NEAR(first["shares"][0], 0.5, 0.01);
  for (const char* moved : {"shares_at_half_friction", "shares_at_one_and_a_half_friction"}) {
    EXPECT_NEAR(first[moved][0], 0.5, 0.01) << moved;
  }
  EXPECT_LT(first["motor"]["nominal_N"], 56);
  EXPECT_TRUE(has(thumb.result.out, "by statics"));
  EXPECT_TRUE(has(thumb.result.out, "\nApart from the target:\nBest: "));
  EXPECT_TRUE(has(thumb.file("index.html"), "Target 2.00:1.00:1.00: "));
}

TEST(ExploredTarget, IsTheMotorForceOfShowOfTheSizedHardware) {
  const Explored thumb(
      Arguments{"--fingers", "3", "--hardware", thumb_hardware, "--target", "1=2,others=1"});
  const Json first = thumb.summary()["target"]["designs"][0];
  EXPECT_EQ(first["hangs_on_friction"], true);
  EXPECT_GT(std::abs(first["shares_at_half_friction"][0].get<double>() - 0.5), 0.05);
  const Json sized =
      Json::parse(reeve(Arguments{"size", first["routing"], "--hardware", thumb_hardware, "--vary",
                                  "sheath_angle=1.55..6.2", "--target", "1=2,others=1", "--nominal",
                                  "--starts", "2", "--format", "json"})
                      .out)["designs"][0]["sized"];
  EXPECT_EQ(first["motor"], sized["motor"]);
}

TEST(ExploredTarget, OutOfReachIsExitCodeOne) {
  const Explored far(
      Arguments{"--parts", "paper", "--target", "1=200,2=1", "--constraint", "sheaths<=1"});
  EXPECT_EQ(far.result.exit_code, 1);
  EXPECT_TRUE(has(far.result.out, "No design reaches the target 200.00:1.00; the nearest is "));
  EXPECT_TRUE(has(far.result.out,
                  "\nA whiffletree gives this ratio by statics: "
                  "M-W1+1x-W1/200:1-2x, arms 1:200 at W1\n"));
}

TEST(Front, SaysHowManyDistinctDesignsItHas) {
  for (const std::vector<std::string>& objectives :
       {std::vector<std::string>{"efficiency_worst", "sheaths"}, {"travel", "sheaths"}}) {
    const Explored explored(
        Arguments{"--fingers", "3", "--objectives", objectives[0] + "," + objectives[1]});
    std::set<std::vector<std::string>> sets;
    for (const auto& row : rows_of(explored.file("pareto.csv"))) {
      sets.insert({row.at(objectives[0]), row.at(objectives[1])});
    }
    const Json summary = explored.summary();
    const std::size_t distinct = sets.size();
    EXPECT_EQ(summary["front_distinct"], distinct);
    EXPECT_LT(distinct, summary["front"].size());
    EXPECT_TRUE(has(explored.result.out, std::to_string(distinct) + " distinct set"));
  }
}

}  // namespace
}  // namespace reeve::testing
