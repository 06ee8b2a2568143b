// What each command prints and writes, as it stands in expected/ (golden.hpp).
#include "tests/golden/golden.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace reeve::testing {
namespace {

TEST(GoldenShow, OfAGraspInWhichFrictionStopsAFinger) {
  expect_json(output_of({"show", "TR5", "--held", "1", "--format", "json"}),
              "show_tr5_held_1.json");
}

TEST(GoldenShow, OverTheGraspsThatAreTheDefault) {
  expect_json(output_of({"show", "TR2", "--format", "json"}), "show_tr2.json");
}

TEST(GoldenShow, OfAHand) {
  const std::string hardware = REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml";
  const std::vector<std::string> show{"show", "M-1b-T-2b-B-3b-M", "--hardware", hardware};
  const auto in_format = [&](const std::string& format) {
    std::vector<std::string> arguments = show;
    arguments.insert(arguments.end(), {"--format", format});
    return output_of(arguments);
  };
  expect_json(in_format("json"), "show_hand.json");
  expect_text(in_format("table"), file_of("show_hand.txt"));
}

TEST(GoldenShow, OfATestBenchWithoutFingers) {
  expect_json(output_of({"show", "M-F", "--format", "json"}), "show_bench.json");
}

TEST(GoldenShow, OfReleasing) {
  expect_json(output_of({"show", "TR4", "--direction", "release", "--format", "json"}),
              "show_tr4_release.json");
}

TEST(GoldenShow, OfATendonThatJamsBesideAnother) {
  expect_json(output_of({"show", "M-1-F+M-2-F", "--held", "1", "--format", "json"}),
              "show_jam.json");
}

TEST(GoldenRank, OfTheCatalogue) {
  expect_json(output_of({"rank", "--catalogue", "--format", "json"}), "rank_catalog.json");
  expect_csv(output_of({"rank", "--catalogue", "--format", "csv"}), "rank_catalog.csv");
}

TEST(GoldenRank, OfTheCatalogueWithUncertainty) {
  std::vector<std::string> arguments{"rank",   "--catalogue", "--uncertainty", "--draws", "50",
                                     "--seed", "7",           "--format",      "json"};
  expect_json(output_of(arguments), "rank_catalog_uncertain.json");
  arguments.back() = "csv";
  expect_csv(output_of(arguments), "rank_catalog_uncertain.csv");
}

// What a pipe gets: no colour, and lines as long as they are.
TEST(GoldenTables, OfTheCatalogueInEveryFormat) {
  expect_text(output_of({"rank", "--catalogue"}), file_of("rank_catalog.txt"));
  expect_text(output_of({"rank", "--catalogue", "--format", "markdown"}),
              file_of("rank_catalog.md"));
  expect_text(output_of({"rank", "--catalogue", "--format", "latex"}), file_of("rank_catalog.tex"));
}

TEST(GoldenTables, OfOneRoutingAndOfTheCheck) {
  expect_text(output_of({"show", "TR5"}), file_of("show_tr5.txt"));
  expect_text(output_of({"show", "TR5", "--format", "latex"}), file_of("show_tr5.tex"));
  expect_text(output_of({"check"}), file_of("check.txt"));
}

TEST(GoldenRank, WithWhatThePageShows) {
  const TemporaryFolder folder;
  output_of({"rank", "TR4", "TR5", "--grasps", "paper", "--data", "tests/golden/readings.csv",
             "--out", folder.path().string()});
  expect_json(read_text(folder.path() / "ranking.json"), "rank_page.json");
}

TEST(GoldenSize, OfTwoRoutingsForTheBadSideOfTheirGoal) {
  expect_json(output_of({"size", "TR1", "TR7", "--vary", "sheath_angle=3..9", "--vary",
                         "tip_angle=1..4", "--equal", "tips", "--draws", "20", "--format", "json"}),
              "size.json", fitted);
}

TEST(GoldenSize, OfAThumbThatPullsAsTwoFingers) {
  expect_json(output_of({"size", "M-1-P-2-P-3-M", "--target", "1=2,others=1", "--vary",
                         "sheath_angle=1..12", "--equal", "sheath_angle[2,3]", "--draws", "20",
                         "--format", "json"}),
              "size_target.json", fitted);
}

TEST(GoldenExplore, OfTwoFingers) {
  const TemporaryFolder folder;
  output_of({"explore", "--fingers", "2", "--out", folder.path().string()});
  expect_json(read_text(folder.path() / "summary.json"), "explore_summary.json");
  expect_csv(without_id(read_text(folder.path() / "designs.csv")), "explore_designs.csv");
  expect_csv(without_id(read_text(folder.path() / "pareto.csv")), "explore_pareto.csv");
}

TEST(GoldenCount, OfThreeFingers) {
  expect_json(output_of({"count", "--fingers", "3", "--format", "json"}), "count.json");
}

TEST(GoldenCheck, OfTheShippedCatalogue) {
  expect_json(output_of({"check", "--format", "json"}), "check.json");
}

TEST(GoldenCatalogue, OfTheHands) {
  expect_json(output_of({"catalogue", "--family", "hands", "--format", "json"}), "catalogue.json");
}

TEST(GoldenCompare, OfReadingsWithAndWithoutMotorTension) {
  const TemporaryFolder folder;
  expect_json(output_of({"compare", "tests/golden/readings.csv", "--format", "json", "--out",
                         folder.path().string()}),
              "compare.json");
  expect_csv(without_id(read_text(folder.path() / "residuals.csv")), "compare_residuals.csv");
}

TEST(GoldenImport, OfTheLogOfASimulatedRig) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "readings.csv").string();
  expect_json(output_of({"import", "tests/golden/log.csv", "-o", file, "--format", "json"}),
              "import.json");
  const std::string csv = read_text(file);
  expect_csv(csv.substr(csv.find('\n') + 1), "import_readings.csv");  // below the version
}

std::string diagnose(const std::string& data, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"diagnose", "tests/golden/" + data, "--format", "json"});
  return output_of(options);
}

TEST(GoldenDiagnose, OfTubesThatAreSmootherThanTheHardwareSays) {
  const TemporaryFolder folder;
  const std::string out = diagnose("diagnose_cause.csv", {"--out", folder.path().string()});
  expect_json(out, "diagnose_cause.json", fitted);
  expect_csv(without_id(read_text(folder.path() / "residuals.csv")), "diagnose_cause_residuals.csv",
             fitted);
}

TEST(GoldenDiagnose, OfThePublishedReadingsOfTheSevenRoutings) {
  const std::string data = "../../catalog/measured/exo_glove_ii.csv";
  expect_json(diagnose(data), "diagnose_exo_glove_ii.json", fitted);
}

TEST(GoldenDiagnose, OfAModelThatIsRight) {
  expect_json(diagnose("diagnose_none.csv"), "diagnose_none.json", fitted);
}

TEST(GoldenDiagnose, OfCausesThatTheDataCannotTellApart) {
  expect_json(diagnose("diagnose_indistinguishable.csv"), "diagnose_indistinguishable.json",
              fitted);
}

}  // namespace
}  // namespace reeve::testing
