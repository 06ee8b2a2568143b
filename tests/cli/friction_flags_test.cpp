#include "cli/flags/friction_flags.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/cli/bad_line.hpp"
#include "tests/support/input_error.hpp"

namespace reeve::cli {
namespace {

using std::numbers::pi;
using testing::has;
using testing::input_fault;
using Json = nlohmann::json;

TEST(Angle, IsInDegreesOrRadians) {
  EXPECT_DOUBLE_EQ(parse_angle("180deg"), pi);
  EXPECT_DOUBLE_EQ(parse_angle(" 90 deg "), pi / 2);
  EXPECT_DOUBLE_EQ(parse_angle("45°"), pi / 4);
  EXPECT_EQ(parse_angle("3.5rad"), 3.5);
  EXPECT_EQ(parse_angle("3.5"), 3.5);
  EXPECT_EQ(parse_angle("0"), 0);
}

TEST(Angle, IsRefusedWithoutANumberOrInAnotherUnit) {
  for (const char* text : {"", "deg", "180grad", "-1", "nan", "inf", "180 deg rad", "1e999"}) {
    EXPECT_EQ(input_fault([&] { parse_angle(text); }),
              std::string("- |  | ") + text + " | an angle such as 180deg or 3.14rad");
  }
}

Json tensions(const testing::Arguments& arguments) {
  const testing::ProcessResult result = testing::reeve(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Json::parse(result.out)["grasps"][0]["tensions"];
}

// One sheath of 90 degrees, then a tube of 180: the capstan law by hand.
TEST(QuickFriction, StandsInPlaceOfTheHardwares) {
  const Json both = tensions("show M-1-F --held none --mu 0.1 --sheath-bend 90deg --format json");
  EXPECT_NEAR(both["T1"].get<double>(), std::exp(-0.1 * pi / 2), 1e-12);
  EXPECT_NEAR(both["T2"].get<double>(), std::exp(-0.1 * pi / 2 - 0.1 * pi), 1e-12);
  const Json each =
      tensions("show M-1-F --held none --mu 0.1 --sheath-mu 0.05 --sheath-bend 2 --format json");
  EXPECT_NEAR(each["T1"].get<double>(), std::exp(-0.05 * 2), 1e-12);
  EXPECT_NEAR(each["T2"].get<double>(), std::exp(-0.05 * 2 - 0.1 * pi), 1e-12);
  const Json tube = tensions("show M-1-F --held none --tube-mu 0.02 --format json");
  EXPECT_NEAR(tube["T1"].get<double>(), std::exp(-0.18 * 2 * pi), 1e-12);
  EXPECT_NEAR(tube["T2"].get<double>(), std::exp(-0.18 * 2 * pi - 0.02 * pi), 1e-12);
}

// A mechanism with coefficients of its own keeps those that are not given.
TEST(QuickFriction, StandsInPlaceOfAMechanismsOwn) {
  const Json own = tensions("show PulleyTurn --held none --format json");
  const Json rough =
      tensions("show PulleyTurn --held none --sheath-mu 0.1 --sheath-bend 90deg --format json");
  EXPECT_NEAR(own["T1"].get<double>(), 0.842, 1e-12);
  EXPECT_NEAR(rough["T1"].get<double>(), 0.842 * std::exp(-0.1 * pi / 2), 1e-12);
}

TEST(QuickFriction, GivesRankExploreAndSizeWhatAFileGives) {
  const testing::TemporaryFolder folder;
  folder.write("h.toml", "[tube]\nmu = 0.07\n[sheath]\nmu = 0.07\nbend_deg = 120\n");
  const testing::ProcessOptions there{.directory = folder.path()};
  const auto printed = [&](const std::string& line) {
    const testing::ProcessResult result = testing::reeve(line.c_str(), there);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  };
  const std::string quick = " --mu 0.07 --sheath-bend 120deg";
  const std::string file = " --hardware h.toml";
  EXPECT_EQ(printed("rank --catalogue --format csv" + quick),
            printed("rank --catalogue --format csv" + file));
  const std::string size =
      "size TR7 --vary tip_angle=1..4 --nominal --starts 1 --evaluations 30 "
      "--format json";
  EXPECT_EQ(printed(size + quick), printed(size + file));
  printed("explore --out quick" + quick);
  printed("explore --out file" + file);
  const std::string designs = testing::read_text(folder.path() / "quick/designs.csv");
  EXPECT_EQ(designs, testing::read_text(folder.path() / "file/designs.csv"));
  EXPECT_TRUE(has(designs, "1-P-2-P-1,TR7"));
}

TEST(QuickFriction, IsPrintedOnTheFirstScreenOfAnExploration) {
  const testing::TemporaryFolder folder;
  const testing::ProcessResult result = testing::reeve(
      "explore --fingers 2 --mu 0.1 --sheath-bend 90deg", {.directory = folder.path()});
  EXPECT_TRUE(has(
      result.out,
      "Assumed, by default with --mu 0.1 --sheath-bend 90deg: tubes mu 0.1 over 180 deg, bearings mu 0.001 over 180 deg, sheaths mu "
      "0.1 over 90 deg; only capstan friction\nParts: tips tube, bearing; joins T, B, "
      "P; ends M, F; anchored tips; up to 1 floating block; any number of tendons; identical "
      "fingers\n"))
      << result.out;
}

TEST(SheathLength, IsSaidToHaveNoEffect) {
  const testing::TemporaryFolder folder;
  folder.write("h.toml", "[sheath]\nlength_mm = 800\n");
  for (const char* line : {"show TR1 --hardware h.toml", "explore --hardware h.toml",
                           "rank TR1 TR7 --hardware h.toml"}) {
    const testing::ProcessResult result = testing::reeve(line, {.directory = folder.path()});
    EXPECT_TRUE(has(result.out,
                    "Note: the sheath length of 800 mm has no effect: capstan friction depends on "
                    "the sum of the bends, not on the length"))
        << line << result.out;
  }
}

TEST(SpringsAndSlack, AreSaidToBeLackingWhereTheirCommonKeysStandAlone) {
  const testing::TemporaryFolder folder;
  folder.write("h.toml", "[tendon]\nEA_N = 2e4\ntravel_mm = 30\n[tendon.1]\n");
  const testing::ProcessResult result =
      testing::reeve("show TR1 --hardware h.toml", {.directory = folder.path()});
  for (
      const char* note :
      {"Note: EA_N in [tendon] of the hardware changes nothing: no tendon has a stiffness_N_mm\n",
       "Note: travel_mm in [tendon] of the hardware changes nothing: no tendon has a slack_mm\n"}) {
    EXPECT_TRUE(has(result.out, note)) << result.out;
  }
}

TEST(BadFriction, IsNamedWithItsOption) {
  const std::string angle = "expected an angle such as 180deg or 3.14rad";
  testing::expect_all_bad({
      {"show TR1 --mu nan",
       "--mu: Value 'nan': expected a number from 0 to 10; see reeve show --help"},
      {"show TR1 --tube-mu -1", "--tube-mu: Value '-1': expected a number from 0 to 10"},
      {"rank TR1 TR7 --sheath-mu 11", "--sheath-mu: Value '11': expected a number from 0 to 10"},
      {"show TR1 --sheath-bend 180", "--sheath-bend '180': " + angle},
      {"explore --sheath-bend 180grad", "--sheath-bend '180grad': " + angle},
      {"size TR1 --vary tip_angle=1..4 --sheath-bend ''", "--sheath-bend '': " + angle},
      {"show TR1 --sheath-mu 5 --sheath-bend 360deg",
       "--sheath-mu 5 --sheath-bend 360deg: hardware: sheath: mu * angle = 31.4"},
      {"show TR1 --model cause.toml --mu 0.1", "--model excludes --mu"},
  });
}

// Values of one finger stand in place of an option's: --sheath-mu then changes no number.
class OwnFriction : public ::testing::Test {
 protected:
  OwnFriction() {
    const std::string joints =
        "[hand]\nforce_N = 4\njoints = [{ arm_mm = 12, range_deg = 90, lever_mm = 90 }]\n";
    const std::string first = "[finger.1]\nsheath_mu = 0.1\ntip_mu = 0.1\n";
    folder_.write("part.toml", joints + first);
    folder_.write("all.toml", joints + first + "[finger.2]\nsheath_mu = 0.1\ntip_mu = 0.1\n");
  }

  testing::ProcessResult run(const std::string& line) const {
    return testing::reeve(line.c_str(), {.directory = folder_.path()});
  }

 private:
  testing::TemporaryFolder folder_;
};

TEST_F(OwnFriction, RefusesAnOptionThatChangesNothing) {
  const std::string why =
      ": it changes nothing, since sheaths of fingers 1, 2 have values of their own; expected a "
      "hardware file without them\n";
  for (const std::string command : {"show TR5", "rank TR5 TR7", "size TR5 --vary tip_angle=1..4"}) {
    const auto result = run(command + " --hardware all.toml --sheath-mu 0.3");
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "reeve: --sheath-mu" + why);
  }
  EXPECT_EQ(run("rank TR5 TR7 --hardware all.toml --sweep sheath_mu=0.05..0.3").err,
            "reeve: --sweep sheath_mu" + why);
  EXPECT_EQ(run("show M-1b-M --tube-mu 0.2").err,
            "reeve: --tube-mu: it changes nothing, since there are no tubes; expected a routing "
            "with them\n");
}

TEST_F(OwnFriction, IsNamedWhereAnOptionLeavesIt) {
  const std::string left = " leaves sheaths of finger 1 alone, which have values of their own";
  EXPECT_TRUE(has(run("show TR5 --hardware part.toml --sheath-mu 0.3").out,
                  "Assumed, by part.toml with --sheath-mu 0.3 (--sheath-mu" + left + "): "));
  EXPECT_TRUE(has(run("rank TR5 TR7 --hardware part.toml --sweep sheath_mu=0.05..0.3").out,
                  "\nNote: sheath_mu" + left + "\n"));
}

TEST_F(OwnFriction, IsNotListedAsDrawn) {
  const std::string whose = " have friction coefficients of their own, which are not drawn\n";
  const std::string all = run("rank TR5 TR7 --hardware all.toml --uncertainty").out;
  EXPECT_TRUE(has(all, "Note: tips of fingers 1, 2 and sheaths of fingers 1, 2" + whose)) << all;
  EXPECT_TRUE(has(all, "draws: bearings mu ± 50 %, bends ± 20 %, each bearing ± 10 %\n")) << all;
  const std::string part = run("rank TR5 TR7 --hardware part.toml --uncertainty").out;
  EXPECT_TRUE(has(part, "Note: tips of finger 1 and sheaths of finger 1" + whose)) << part;
  EXPECT_TRUE(has(part, "draws: tubes mu 0.05 to 0.2, sheaths mu 0.05 to 0.2, bearings")) << part;
  EXPECT_TRUE(has(run("show TR5 --hardware all.toml").out, "sheaths of fingers 1, 2" + whose));
}

TEST(UnknownOption, OfFrictionIsKnownByItsMeaning) {
  testing::expect_all_bad({
      {"explore --friction 0.1",
       "explore: unexpected --friction 0.1; did you mean --mu? See reeve explore --help"},
      {"show TR1 --bend 90", "show: unexpected --bend 90; did you mean --sheath-bend?"},
      // There is no such option to mean.
      {"check --friction 0.1", "check: unexpected --friction 0.1; see reeve check --help"},
  });
}

}  // namespace
}  // namespace reeve::cli
