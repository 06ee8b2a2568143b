// The page of `size --out`.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "reports/output/json.hpp"
#include "tests/support/process.hpp"
#include "tests/support/read_chart.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

struct SizedPage {
  explicit SizedPage(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "size");
    arguments.insert(arguments.end(), {"--out", folder.path().string()});
    result = reeve(arguments);
    html = read_text(folder.path() / "index.html");
    json = Json::parse(read_text(folder.path() / "sizing.json"));
  }

  bool has(const std::string& part) const { return html.find(part) != std::string::npos; }
  std::string figure(const std::string& name) const {
    return read_text(folder.path() / "figures" / name);
  }

  TemporaryFolder folder;
  ProcessResult result;
  std::string html;
  Json json;
};

const SizedPage& hand_page() {
  static const SizedPage page(
      {"M-1b-T-2b-B-3b-M", "--hardware", REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml",
       "--goal", "motor_force", "--vary", "sheath_angle=2..5", "--vary", "tip_angle=2..4",
       "--equal", "tips", "--draws", "10", "--starts", "8"});
  return page;
}

TEST(SizingPage, AnswersWithDimensionsTolerancesAndTheMotor) {
  const SizedPage& page = hand_page();
  ASSERT_EQ(page.result.exit_code, 0) << page.result.err;
  for (const char* part : {"id=\"gain\"", "id=\"summary-table\"",
                           "All at once: ", "Motor force: ", "id=\"dimensions-table\"",
                           "id=\"slopes-table\"", "id=\"motor-table\"", "id=\"hand-table-2\"",
                           "<pre id=\"command\">reeve size M-1b-T-2b-B-3b-M "}) {
    EXPECT_TRUE(page.has(part)) << part;
  }
  for (const Json& dimension : page.json["designs"][0]["dimensions"]) {
    EXPECT_TRUE(page.has(fmt::format(
        "{}</th><td>{:+.4g}</td><td>{:+.4g}</td>", dimension["dimension"].get<std::string>(),
        dimension["slope"]["less"].get<double>(), dimension["slope"]["more"].get<double>())))
        << dimension;
  }
  const auto motor = [&](const char* hand, const char* key) {
    return page.json["details"][hand]["hand"]["motor"][key].get<double>();
  };
  for (const auto& [row, key] :
       {std::pair{"force, nominal</th><td class=\"left short\">N", "force_N"},
        {"speed of the spool</th><td class=\"left short\">rpm", "spool_rpm"}}) {
    EXPECT_TRUE(page.has(fmt::format("{}</td><td>{:.4g}</td><td>{:.4g}</td>", row,
                                     motor("before", key), motor("sized", key))))
        << row;
  }
}

TEST(SizingPage, DrawsTheRoutingBeforeAndSizedAndHasTheFiles) {
  const SizedPage& page = hand_page();
  for (const char* name : {"M-1b-T-2b-B-3b-M-before-held-none", "M-1b-T-2b-B-3b-M-held-none",
                           "M-1b-T-2b-B-3b-M-held-3", "profiles"}) {
    EXPECT_TRUE(page.figure(std::string(name) + ".svg").starts_with("<svg ")) << name;
    EXPECT_TRUE(page.figure(std::string(name) + ".txt").find("not measured") != std::string::npos);
  }
  EXPECT_TRUE(page.has("id=\"schematic-before-held-none\""));
  EXPECT_TRUE(page.has("id=\"schematic-sized-held-2\""));
}

TEST(SizingPage, DrawsTheGoalOfTheFileAgainstEachDimension) {
  const SizedPage& page = hand_page();
  const std::vector<ReadPanel> panels = read_chart(page.figure("profiles.svg"));
  const Json& profiles = page.json["details"]["profiles"];
  const Json& design = page.json["designs"][0];
  ASSERT_EQ(panels.size(), profiles.size());
  for (std::size_t i = 0; i < panels.size(); ++i) {
    EXPECT_EQ(panels[i].texts.front(), profiles[i]["dimension"]);
    const std::vector<ReadMark> points = panels[i].marks("points");
    ASSERT_EQ(points.size(), 1U);
    EXPECT_NEAR(panels[i].y_of(points[0]), design["sized"]["goal"], 0.05);
    const auto values = profiles[i]["values"].get<std::vector<double>>();
    const auto goals = profiles[i]["goals"].get<std::vector<double>>();
    ASSERT_EQ(values.size(), goals.size());
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    const double sized = design["dimensions"][i]["sized"];
    const auto here = std::find(values.begin(), values.end(), sized) - values.begin();
    ASSERT_LT(static_cast<std::size_t>(here), values.size());
    EXPECT_EQ(goals[static_cast<std::size_t>(here)], design["sized"]["goal"]);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const bool inside = values[k] >= design["dimensions"][i]["bounds"][0] &&
                          values[k] <= design["dimensions"][i]["bounds"][1];
      if (!inside) continue;
      EXPECT_GE(goals[k], design["sized"]["goal"].get<double>() - 1e-6);
    }
  }
}

// "alone: 2 to 2.05"
std::pair<double, double> ends(const ReadMark& band) {
  const std::string text = band.title.substr(band.title.find(": ") + 2);
  return {std::stod(text), std::stod(text.substr(text.find(" to ") + 4))};
}

// A tolerance of nothing, and one of all at once, reach to the end of the profile at most.
void expect_tolerances_drawn(const SizedPage& page) {
  const std::vector<ReadPanel> panels = read_chart(page.figure("profiles.svg"));
  const Json& design = page.json["designs"][0];
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Json& dimension = design["dimensions"][i];
    const Json& values = page.json["details"]["profiles"][i]["values"];
    const double sized = dimension["sized"];
    const auto end = [&](const Json& way, double sign, const Json& last) {
      return way.is_null() ? last.get<double>() : sized + sign * way.get<double>();
    };
    const auto [low, high] = ends(panels[i].marks("bands", "tolerance alone").at(0));
    EXPECT_NEAR(low, end(dimension["tolerance"]["less"], -1, values.front()), 1e-3 * sized);
    EXPECT_NEAR(high, end(dimension["tolerance"]["more"], 1, values.back()), 1e-3 * sized);
    const Json& ways = dimension["tolerance_together"];
    const auto [least, most] = ends(panels[i].marks("bands", "all at once").at(0));
    EXPECT_NEAR(least, std::max<double>(sized - ways["less"].get<double>(), values.front()),
                1e-3 * sized);
    EXPECT_NEAR(most, std::min<double>(sized + ways["more"].get<double>(), values.back()),
                1e-3 * sized);
  }
}

// At a bound, and in between, where they are farther on one side than on the other.
TEST(SizingPage, DrawsTheTolerancesOfTheFileOnEachSide) {
  expect_tolerances_drawn(hand_page());
  expect_tolerances_drawn(SizedPage({"TR4", "--target", "1=2,others=1", "--vary", "tip_angle=1..4",
                                     "--vary", "sheath_angle=3..9", "--nominal"}));
}

TEST(SizingPage, HasTheMotorThatShowGivesWithTheSizedHardware) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "h.toml").string();
  const SizedPage page({"M-1-P-2-P-3-M", "--hardware",
                        REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml", "--target",
                        "1=2,others=1", "--vary", "sheath_angle=1..12", "--nominal",
                        "--save-hardware", file});
  ASSERT_EQ(page.result.exit_code, 0) << page.result.err;
  const Json shown =
      Json::parse(reeve({"show", "M-1-P-2-P-3-M", "--hardware", file, "--format", "json"}).out);
  EXPECT_EQ(page.json["details"]["sized"]["grasps"].size(), 4U);
  for (const char* key : {"force_N", "stroke_mm", "power_W"}) {
    EXPECT_NEAR(page.json["details"]["sized"]["hand"]["motor"][key],
                shown["hand"]["motor"][key].get<double>(), 1e-6)
        << key;
  }
}

TEST(SizingPage, WithoutAHandOrTolerancesHasNoSuchSections) {
  const SizedPage page({"TR1", "TR7", "--vary", "sheath_angle=3..9", "--nominal"});
  EXPECT_EQ(page.result.exit_code, 0);
  EXPECT_FALSE(page.has("id=\"motor-table\""));
  EXPECT_TRUE(page.has("id=\"ranking-table\""));
  const SizedPage nothing({"F-1-P-2-F", "TR1", "--vary", "contact_angle[T2-T3]=1..2", "--nominal"});
  EXPECT_EQ(nothing.result.exit_code, 0) << nothing.result.err;
}

TEST(SizingPage, IsTheSameForAnyNumberOfThreads) {
  const auto page = [](const char* threads) {
    SizedPage sized({"TR6", "--vary", "sheath_angle=3..9", "--draws", "10", "--threads", threads});
    const std::size_t command = sized.html.find("<pre id=\"command\">");
    return sized.html.substr(0, command);
  };
  EXPECT_TRUE(page("1") == page("3"));
}

}  // namespace
}  // namespace reeve::testing
