// Tests the parts that explore and count allow if none are named.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

#include "tests/cli/bad_line.hpp"
#include "tests/support/has.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::cli {
namespace {

using testing::has;
using Json = nlohmann::json;

Json counted(testing::Arguments arguments) {
  arguments.insert(arguments.begin(), "count");
  arguments.insert(arguments.end(), {"--format", "json"});
  const testing::ProcessResult result = testing::reeve(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Json::parse(result.out);
}

TEST(DefaultParts, AreThoseOfTheField) {
  EXPECT_EQ(counted({"--fingers", "3"}), counted({"--fingers", "3", "--parts", "field"}));
  EXPECT_EQ(counted({"--fingers", "4"})["parts"]["blocks"], 3);
  EXPECT_TRUE(counted({"--fingers", "4"})["parts"]["anchored"]);
  EXPECT_EQ(counted({"--fingers", "4", "--parts", "paper"})["parts"]["blocks"], 0);
}

TEST(DefaultParts, GiveWayToPartsThatAreNamed) {
  EXPECT_EQ(counted({"--fingers", "5", "--blocks", "2"})["parts"]["blocks"], 2);
  EXPECT_EQ(counted({"--fingers", "3", "--blocks", "0"})["parts"]["blocks"], 0);
  EXPECT_EQ(counted({"--fingers", "3", "--tips", "tube"})["parts"]["tips"], "tube");
  // Fewer kinds leave room for more blocks.
  EXPECT_GT(counted({"--fingers", "5", "--tips", "bearing", "--joins", "B"})["parts"]["blocks"], 1);
}

TEST(DefaultParts, SayWhatTheyLeaveOut) {
  const std::string said = testing::reeve({"count", "--fingers", "5"}).out;
  EXPECT_TRUE(has(said, "anchored tips; up to 1 floating block\n")) << said;
  EXPECT_TRUE(has(said, "2 to 4 floating blocks are left out: with --blocks 2 there are")) << said;
}

// The hands of the catalogue with one sheath, with pulleys and with bars.
TEST(DefaultParts, AnswerInTwoLines) {
  const testing::TemporaryFolder folder;
  const std::string said =
      testing::reeve({"explore", "--fingers", "2", "--out", folder.path().string()}).out;
  EXPECT_TRUE(has(said,
                  "\nWithout floating blocks, fewest sheaths within 2 % of the best: "
                  "M-1b-B-2x: 1 sheath, "))
      << said;
  EXPECT_TRUE(has(said,
                  "; at the hand no moving part, 3 strands\n"
                  "With floating blocks, fewest sheaths within 2 % of the best: "
                  "M-Y1+1x-Y1-2x: 1 sheath, "))
      << said;
  EXPECT_TRUE(has(said,
                  "; at the hand 1 moving part, 2 strands; with rigid bars in place of its "
                  "pulleys it is M-W1+1x-W1-2x: "))
      << said;
}

TEST(DefaultParts, AreTooManyToCountWithTooManyFingers) {
  const testing::ProcessResult result = testing::reeve({"count", "--fingers", "64"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "--fingers 64: these parts and fingers make more than 2^63 routings"))
      << result.err;
}

}  // namespace
}  // namespace reeve::cli
