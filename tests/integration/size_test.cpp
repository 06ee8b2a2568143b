// `reeve size` from end to end: what it says, writes, and how it ends.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

using namespace std::chrono_literals;

struct Sized {
  TemporaryFolder folder;
  ProcessResult result;

  explicit Sized(Arguments arguments, ProcessOptions options = {}) {
    run(std::move(arguments), std::move(options));
  }

  void run(Arguments arguments, ProcessOptions options = {}) {
    options.directory = folder.path();
    arguments.insert(arguments.begin(), "size");
    result = reeve(arguments, options);
  }
  Json json() const { return Json::parse(result.out); }
};

TEST(Size, WritesAHardwareFileThatGivesTheSameFigures) {
  const Sized sized({"TR5", "--vary", "sheath_angle=3..9", "--vary", "contact_angle[T1-T2]=1..4",
                     "--draws", "10", "--save-hardware", "h.toml", "--format", "json"});
  ASSERT_EQ(sized.result.exit_code, 0) << sized.result.err;
  const std::string file = (sized.folder.path() / "h.toml").string();
  const Json ranked =
      Json::parse(reeve({"rank", "TR5", "--hardware", file, "--format", "json"}).out);
  const Json design = sized.json()["designs"][0];
  EXPECT_EQ(ranked["designs"][0]["uniformity"], design["sized"]["uniformity"]);
  EXPECT_EQ(ranked["designs"][0]["efficiency"], design["sized"]["efficiency"]);
  EXPECT_EQ(ranked["settings"]["hardware"], design["hardware"]);
  EXPECT_TRUE(read_text(file).starts_with("# Sized by reeve "));
}

TEST(Size, TakesTravelsOfTheMotorsAsRankDoes) {
  const Sized sized({"M-1-B-2-M2", "--grasps", "none@1,0.5", "--vary", "sheath_angle=3..9",
                     "--nominal", "--starts", "1", "--format", "json"});
  ASSERT_EQ(sized.result.exit_code, 0) << sized.result.err;
  const Json ranked =
      Json::parse(reeve({"rank", "M-1-B-2-M2", "--grasps", "none@1,0.5", "--format", "json"}).out);
  const Json design = sized.json()["designs"][0];
  EXPECT_EQ(ranked["designs"][0]["uniformity"], design["before"]["uniformity"]);
  EXPECT_EQ(ranked["designs"][0]["efficiency"], design["before"]["efficiency"]);
}

// Joints can still be given to the fingers: nobody has said how far they close.
TEST(Size, SavesWhatWasGivenOrSizedAndNothingElse) {
  Sized sized({"TR1", "--vary", "tip_angle=1..4", "--nominal", "--starts", "1", "--save-hardware",
               "h.toml"});
  ASSERT_EQ(sized.result.exit_code, 0) << sized.result.err;
  const std::string saved = read_text(sized.folder.path() / "h.toml");
  EXPECT_TRUE(has(saved, "tip_angle_rad"));
  EXPECT_FALSE(has(saved, "closing"));
  sized.folder.write("hand.toml",
                     saved +
                         "[hand]\nforce_N = 5\njoints = [{ arm_mm = 8, range_deg = 90, "
                         "lever_mm = 60 }]\n");
  const std::string file = (sized.folder.path() / "hand.toml").string();
  const ProcessResult shown = reeve({"show", "TR1", "--hardware", file});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  sized.run(
      "TR1 --vary closing[2]=0.5..2 --goal round_trip_efficiency --nominal "
      "--starts 1 --save-hardware c.toml");
  const std::string closes = read_text(sized.folder.path() / "c.toml");
  EXPECT_EQ(closes.find("closing"), closes.rfind("closing"));
  EXPECT_TRUE(has(closes, "[finger.2]\nclosing"));
}

TEST(Size, TakesItsBoundsFromTheHardwareFileAndGivesThemBack) {
  Sized sized({});
  sized.folder.write("h.toml", "[vary]\ntip_angle = [1, 4]\nequal = [\"tips\"]\n");
  sized.run("TR1 --hardware h.toml --nominal --save-hardware sized.toml");
  ASSERT_EQ(sized.result.exit_code, 0) << sized.result.err;
  EXPECT_TRUE(has(sized.result.out, "tip_angle[1,2]"));
  EXPECT_TRUE(has(sized.result.out, "\nHardware file: sized.toml\n"));
  const std::string once = sized.result.out.substr(0, sized.result.out.find("\nHardware"));
  sized.run("TR1 --hardware sized.toml --nominal");
  EXPECT_EQ(sized.result.exit_code, 0);
  EXPECT_TRUE(has(sized.result.out, "(+0.0 %)"));
  EXPECT_NE(once, sized.result.out);
}

TEST(Size, OfATargetOutOfReachSaysByHowMuchAndExitsWithOne) {
  const Sized sized(
      {"TR1", "--target", "1=0.4,2=0.6", "--vary", "contact_angle[T2-T3]=1..9", "--nominal"});
  EXPECT_EQ(sized.result.exit_code, 1);
  EXPECT_EQ(sized.result.err, "");
  EXPECT_TRUE(has(sized.result.out,
                  "shares miss it by 0.3934 at best, where finger 1 has 0.6782 "
                  "of all pull instead of 0.4"));
}

// Shares that are met at the nominal coefficients and missed by what suits all of them.
TEST(Size, OfATargetForAllCoefficientsDoesNotSayOneNumberInsteadOfItself) {
  const Sized sized({"M-1-P-2-F", "--target", "1=2,others=1", "--vary", "sheath_angle=1..12",
                     "--draws", "10", "--starts", "1"});
  const std::string& out = sized.result.out;
  const std::size_t instead = out.find(" of all pull instead of ");
  if (instead == std::string::npos) {
    EXPECT_TRUE(has(out, "there are dimensions that meet it; those above, sized for the quantile"));
  } else {
    const std::string has = out.substr(out.rfind(' ', instead - 1) + 1);
    const std::string wanted = out.substr(instead + 24);
    EXPECT_NE(has.substr(0, has.find(' ')), wanted.substr(0, wanted.find_first_of(";\n"))) << out;
  }
}

TEST(Size, SaysUnitsAndWhatAnyMeans) {
  const std::string hand = REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml";
  const Sized force({"M-1b-T-2b-B-3b-M", "--hardware", hand, "--goal", "motor_force", "--vary",
                     "tip_angle=2..4", "--nominal", "--starts", "1"});
  const std::string headline = force.result.out.substr(force.result.out.find("M-1b"));
  EXPECT_TRUE(has(headline.substr(0, headline.find('\n')), " N (")) << headline;
  EXPECT_TRUE(
      has(force.result.out,
          "any: no limit within the bounds and their width beyond; ≥: no limit up to this "));
  // No number that reads as a limit stands beside "any".
  const std::string row = headline.substr(headline.find("\ntip_angle["));
  EXPECT_TRUE(has(row.substr(0, row.find('\n', 1)), "any")) << row;
  EXPECT_TRUE(has(row.substr(0, row.find('\n', 1)), " ≥ ")) << row;
}

// Longer arms ask for less force and more stroke than this motor has.
TEST(Size, SaysWhereItsMotorIsNotEnoughForWhatWasSized) {
  const std::string hand = REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml";
  const auto out = [&](const char* arms) {
    return Sized({"M-1b-T-2b-B-3b-M", "--hardware", hand, "--goal", "motor_force", "--vary", arms,
                  "--equal", "arms", "--nominal", "--starts", "1"})
        .result.out;
  };
  const std::string longer = out("arm_mm=10..14");
  EXPECT_TRUE(has(longer, "\nThe motor's stroke of 90 mm is not enough: "));
  EXPECT_TRUE(has(longer, ". The motor's 80 N is "));
  EXPECT_TRUE(has(longer, "\nstroke                 mm "));
  const std::string shorter = out("arm_mm=9..10");
  EXPECT_TRUE(has(shorter, "\nThe motor's stroke of 90 mm is enough: "));
  // Nominally 69.2 N would do.
  EXPECT_TRUE(has(shorter, ". The motor's 80 N is too little: 95 % of the draws need up to "));
}

TEST(Size, OfTheBestOfAnExplorationRanksThemAgain) {
  Sized sized({});
  ProcessOptions options{.directory = sized.folder.path()};
  ASSERT_EQ(reeve("explore --out explored --grasps paper", options).exit_code, 0);
  const Arguments size("--from explored --top 3 --vary sheath_angle=3..9 --nominal --format json");
  sized.run(size);
  ASSERT_EQ(sized.result.exit_code, 0) << sized.result.err;
  Json json = sized.json();
  ASSERT_EQ(json["designs"].size(), 3U);
  std::vector<std::size_t> before;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(json["designs"][i]["rank"], i + 1);
    before.push_back(json["designs"][i]["rank_before"]);
  }
  std::sort(before.begin(), before.end());
  EXPECT_EQ(before, (std::vector<std::size_t>{1, 2, 3}));
  // It was made with another set of grasps.
  ASSERT_EQ(json["notes"].size(), 1U);
  EXPECT_EQ(json["notes"][0],
            "the exploration in explored was made with other settings than these: grasps");
  Arguments same = size;
  same.insert(same.end(), {"--grasps", "paper"});
  sized.run(same);
  EXPECT_TRUE(sized.json()["notes"].empty());
}

TEST(Size, WritesTheSameBytesForAnyNumberOfThreads) {
  const Arguments line(
      "TR5 TR6 --vary sheath_angle=3..9 --vary strand_mm=50..90 --draws 8 --format json --threads");
  const auto with = [&](const std::string& threads) {
    Arguments arguments = line;
    arguments.push_back(threads);
    return Sized(arguments).result.out;
  };
  const std::string one = with("1");
  EXPECT_FALSE(one.empty());
  EXPECT_TRUE(with("3") == one);
}

TEST(Size, StoppedGivesTheBestSoFarAndSaysPartial) {
  ProcessOptions options{.disturbance = Disturbance{SIGINT, after_it_catches(SIGINT, 500ms)}};
  const Sized sized({"M-1-P-2-P-3-P-4-P-5-F", "--vary", "sheath_angle=3..9", "--vary",
                     "tip_angle=1..4", "--draws", "10000", "--evaluations", "1000000", "--threads",
                     "2", "--save-hardware", "h.toml"},
                    options);
  ASSERT_FALSE(sized.result.timed_out);
  EXPECT_EQ(sized.result.exit_code, 3);
  EXPECT_TRUE(sized.result.out.starts_with("PARTIAL: stopped; the best so far"))
      << sized.result.out;
  EXPECT_TRUE(has(read_text(sized.folder.path() / "h.toml"), "# The search was stopped"));
}

}  // namespace
}  // namespace reeve::testing
