// The page of `show --out`.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reports/output/json.hpp"
#include "tests/support/process.hpp"
#include "tests/support/read_chart.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

struct Shown {
  explicit Shown(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "show");
    plain = reeve(arguments);
    arguments.insert(arguments.end(), {"--out", folder.path().string()});
    result = reeve(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    html = read_text(folder.path() / "index.html");
  }

  bool has(const std::string& part) const { return html.find(part) != std::string::npos; }

  TemporaryFolder folder;
  ProcessResult plain;
  ProcessResult result;
  std::string html;
};

TEST(RoutingPage, LiesBesideTheUsualResult) {
  const Shown shown({"TR5", "--format", "json"});
  EXPECT_EQ(shown.result.out, shown.plain.out);
  EXPECT_EQ(read_text(shown.folder.path() / "routing.json"), shown.plain.out);
}

TEST(RoutingPage, SaysOnTheFirstScreenWhatWasAssumed) {
  const Shown shown({"TR5", "--tube-mu", "0.1"});
  EXPECT_TRUE(shown.has("id=\"assumed\">Assumed, by default with --tube-mu 0.1: tubes mu 0.1 "));
}

TEST(RoutingPage, HasTheTensionsOfEachGrasp) {
  const Shown shown({"TR5"});
  const std::vector<ReadPanel> panels =
      read_chart(read_text(shown.folder.path() / "figures" / "tensions.svg"));
  const Json json = Json::parse(read_text(shown.folder.path() / "routing.json"));
  const std::vector<std::string> titles{"no finger held", "finger 1 held", "finger 2 held"};
  ASSERT_EQ(panels.size(), 3U);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    EXPECT_EQ(panels[i].texts.front(), titles[i]);
    const std::vector<ReadMark> bars = panels[i].marks("bars");
    ASSERT_EQ(bars.size(), 4U);
    for (const ReadMark& bar : bars) {
      const std::string strand = panels[i].category_of(bar);
      EXPECT_NEAR(panels[i].y_of(bar), json["grasps"][i]["tensions"][strand], 1e-4);
      EXPECT_EQ(bar.title.substr(0, 3), strand + ":");
    }
  }
}

TEST(RoutingPage, DrawsTheSchematicOfEachGraspHereAndAsAFile) {
  const Shown shown({"TR5"});
  for (const char* id : {"schematic-held-none", "schematic-held-1", "schematic-held-2"}) {
    EXPECT_TRUE(shown.has(std::string("<figure class=\"schematic\" id=\"") + id + "\"")) << id;
    const std::string file =
        "TR5" + std::string(id).substr(std::string("schematic").size()) + ".svg";
    EXPECT_TRUE(read_text(shown.folder.path() / "figures" / file).starts_with("<svg "));
  }
  EXPECT_TRUE(read_text(shown.folder.path() / "figures" / "tensions.svg").starts_with("<svg "));
}

TEST(RoutingPage, SaysHowUniformAndEfficientItIsOnAverageAndAtWorst) {
  const Shown shown({"TR5"});
  EXPECT_NE(shown.html.find("Over the grasps below its mean uniformity is 0.356 (worst 0.034) and "
                            "its mean efficiency 0.142 (worst 0.052)."),
            std::string::npos);
}

TEST(RoutingPage, SaysHowItIsWrittenAndMade) {
  const Shown shown({"F-2-T-1-M"});
  EXPECT_TRUE(shown.has("<h1><code>F-2-T-1-M</code></h1>"));
  EXPECT_TRUE(shown.has("<p>It is the routing of TR1 in the catalogue.</p>"));
  EXPECT_TRUE(shown.has("<code id=\"canonical\">M-1-T-2-F</code>"));
  EXPECT_TRUE(shown.has("<pre id=\"command\">reeve show F-2-T-1-M --out "));
}

TEST(RoutingPage, SaysWhatTendonsOfOneCarriageShare) {
  const Shown two({"M-1-F+M-2-F"});
  EXPECT_TRUE(
      two.has("id=\"shared\">2 tendons hang on one carriage: their shares of its pull "
              "assume"));
  EXPECT_NE(two.plain.out.find("\n2 tendons hang on one carriage: "), std::string::npos);
  EXPECT_TRUE(Shown({"M-Y1+1x-Y1-2x+M-3-F"}).has(">2 trees of tendons hang on one carriage: "));
  EXPECT_FALSE(Shown({"M-Y1+1x-Y1-2x"}).has("id=\"shared\""));
}

TEST(RoutingPage, SaysWhereItJams) {
  EXPECT_TRUE(Shown({"M-1-F+M-2-F", "--held", "1"}).has("With finger 1 held the routing jams"));
  EXPECT_TRUE(Shown({"1x-M+2x-M2", "--held", "1"}).has("With finger 1 held M stalls"));
}

// No strands: nothing to draw bars of.
TEST(RoutingPage, TakesATestBench) {
  const Shown bench({"M-F"});
  EXPECT_FALSE(bench.has("<figure class=\"chart\""));
  EXPECT_EQ(bench.html.substr(0, bench.html.find("</main>")).find("nan"), std::string::npos);
  EXPECT_TRUE(bench.has("id=\"contacts-table\""));
}

TEST(RoutingPage, SaysWhichModelAndDirection) {
  const Shown shown({"TR5", "--direction", "release", "--model",
                     std::string(REEVE_CATALOG_DIR) + "/model/example.toml"});
  EXPECT_TRUE(shown.has("lets the fingers draw them out"));
  EXPECT_TRUE(shown.has("<p class=\"model\">Model with tube_friction (mu 0.09)"));
}

TEST(RoutingPage, SaysWhatTheRoutingMakesOfAHand) {
  const Shown shown(
      {"M-1b-T-2b-B-3b-M", "--hardware", REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml"});
  EXPECT_TRUE(shown.has("<h2>Hand</h2>"));
  EXPECT_TRUE(shown.has("id=\"hand-table-2\""));
  EXPECT_TRUE(
      shown.has("Motor force: 65.8 N nominal, 102.1 N in 95 % of 1000 draws. The "
                "motor&apos;s 80 N is too little: "));
  EXPECT_TRUE(shown.has(">motor force<"));
  EXPECT_TRUE(
      shown.has("<strong>Hand.</strong> finger 1: 2 joints, arms 11/8 mm, ranges 60/70 °, "
                "levers 58/28 mm, springs 15/10 N mm/rad, slack at -15/-10 °, 10 N wanted "
                "at the tip; other fingers: 3 joints, arms 10/8/6 mm"));
  EXPECT_TRUE(
      shown.has("motor: closes in 0.8 s, spool radius 8 mm, can pull 80 N, can travel 90 mm"));
  const Shown blocked(
      {"M-1-M+M-2-M+M-3-M", "--hardware", REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml"});
  EXPECT_TRUE(blocked.has("<p class=\"note\">No motor force is enough"));
}

TEST(RoutingPage, HasNoHandWhereTheHardwareHasNone) {
  const Shown shown({"TR5"});
  EXPECT_FALSE(shown.has("<h2>Hand</h2>"));
  EXPECT_FALSE(shown.has("fingertip force"));
  EXPECT_FALSE(shown.has("class=\"hand\""));
}

}  // namespace
}  // namespace reeve::testing
