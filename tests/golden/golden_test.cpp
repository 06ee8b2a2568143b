// What users' scripts read, compared with files in expected/: keys, their order and strings
// exactly, numbers to within 1e-9. Seconds, rates, the version and what hangs on it are left out.
//
// REEVE_UPDATE_GOLDEN=1 in the environment rewrites the files instead; look at the difference
// before you keep it, and at docs/json.md.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path file_of(const std::string& name) {
  return std::filesystem::path(REEVE_SOURCE_DIR) / "tests" / "golden" / "expected" / name;
}

bool updating() {
  const char* value = std::getenv("REEVE_UPDATE_GOLDEN");
  return value != nullptr && std::string(value) == "1";
}

// Relative; or the rounding of the objectives, which a last bit can tip over.
constexpr double computed = 1e-9;
// What a minimiser finds: where the minimum is flat, a last bit moves it further.
constexpr double fitted = 1e-5;

bool near(double a, double b, double tolerance = computed) {
  return std::abs(a - b) <= std::max(tolerance * std::max(std::abs(a), std::abs(b)), 1.5e-10);
}

void leave_out_what_varies(Json& json) {
  for (const char* key : {"seconds", "designs_per_second", "exploration", "version"}) {
    if (json.contains(key)) json[key] = "varies";
  }
}

std::string kind(const Json& json) {
  return json.is_number_integer() ? "integer" : json.type_name();
}

void compare(const Json& actual, const Json& expected, const std::string& path, double tolerance) {
  if (kind(actual) != kind(expected)) {
    ADD_FAILURE() << path << ": " << actual.dump() << ", expected " << expected.dump();
  } else if (actual.is_number()) {
    EXPECT_TRUE(near(actual, expected, tolerance))
        << path << ": " << actual.dump() << ", expected " << expected.dump();
  } else if (actual.is_structured()) {
    ASSERT_EQ(actual.size(), expected.size()) << path;
    for (auto a = actual.begin(), e = expected.begin(); a != actual.end(); ++a, ++e) {
      const std::string at =
          actual.is_object() ? a.key() : std::to_string(std::distance(actual.begin(), a));
      if (actual.is_object()) {
        EXPECT_EQ(a.key(), e.key()) << path;
      }
      compare(*a, *e, path + "/" + at, tolerance);
    }
  } else {
    EXPECT_EQ(actual, expected) << path;
  }
}

void expect_json(const std::string& text, const std::string& name, double tolerance = computed) {
  Json actual = Json::parse(text);
  leave_out_what_varies(actual);
  if (updating()) std::ofstream(file_of(name)) << actual.dump(2) << '\n';
  compare(actual, Json::parse(read_text(file_of(name))), name, tolerance);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

bool read_number(const std::string& text, double& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

void expect_same_field(const std::string& actual, const std::string& expected, double tolerance) {
  double a = 0;
  double e = 0;
  if (read_number(actual, a) && read_number(expected, e)) {
    EXPECT_TRUE(near(a, e, tolerance)) << actual << ", expected " << expected;
  } else {
    EXPECT_EQ(actual, expected);
  }
}

void expect_csv(const std::string& text, const std::string& name, double tolerance = computed) {
  if (updating()) std::ofstream(file_of(name)) << text;
  const std::vector<std::string> lines = split(text, '\n');
  const std::vector<std::string> expected = split(read_text(file_of(name)), '\n');
  ASSERT_EQ(lines.size(), expected.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    SCOPED_TRACE(name + ":" + std::to_string(i + 1));
    const std::vector<std::string> fields = split(lines[i], ',');
    const std::vector<std::string> expected_fields = split(expected[i], ',');
    ASSERT_EQ(fields.size(), expected_fields.size());
    for (std::size_t k = 0; k < fields.size(); ++k) {
      expect_same_field(fields[k], expected_fields[k], tolerance);
    }
  }
}

// The last column of an exploration's tables, which hangs on the version.
std::string without_id(const std::string& csv) {
  return std::regex_replace(csv, std::regex(",[0-9a-f]{16}\n"), ",varies\n");
}

std::string output_of(const std::vector<std::string>& arguments) {
  const ProcessResult result = reeve(arguments);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  return result.out;
}

void expect_text(const std::string& text, const std::filesystem::path& file) {
  if (updating()) std::ofstream(file, std::ios::binary) << text;
  EXPECT_EQ(text, read_text(file)) << file;
}

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
  expect_json(output_of({"rank", "--catalog", "--format", "json"}), "rank_catalog.json");
  expect_csv(output_of({"rank", "--catalog", "--format", "csv"}), "rank_catalog.csv");
}

TEST(GoldenRank, OfTheCatalogueWithUncertainty) {
  std::vector<std::string> arguments{"rank",   "--catalog", "--uncertainty", "--draws", "50",
                                     "--seed", "7",         "--format",      "json"};
  expect_json(output_of(arguments), "rank_catalog_uncertain.json");
  arguments.back() = "csv";
  expect_csv(output_of(arguments), "rank_catalog_uncertain.csv");
}

// What a pipe gets: no colour, and lines as long as they are.
TEST(GoldenTables, OfTheCatalogueInEveryFormat) {
  expect_text(output_of({"rank", "--catalog"}), file_of("rank_catalog.txt"));
  expect_text(output_of({"rank", "--catalog", "--format", "markdown"}), file_of("rank_catalog.md"));
  expect_text(output_of({"rank", "--catalog", "--format", "latex"}), file_of("rank_catalog.tex"));
}

TEST(GoldenTables, OfOneRoutingAndOfTheCheck) {
  expect_text(output_of({"show", "TR5"}), file_of("show_tr5.txt"));
  expect_text(output_of({"show", "TR5", "--format", "latex"}), file_of("show_tr5.tex"));
  expect_text(output_of({"check"}), file_of("check.txt"));
}

TEST(GoldenRank, WithWhatThePageShows) {
  const TemporaryFolder folder;
  ProcessOptions options;
  options.directory = REEVE_SOURCE_DIR;  // the file's name is printed as it was given
  const ProcessResult result = reeve({"rank", "TR4", "TR5", "--grasps", "paper", "--data",
                                      "tests/golden/readings.csv", "--out", folder.path().string()},
                                     options);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  expect_json(read_text(folder.path() / "ranking.json"), "rank_page.json");
}

TEST(GoldenSize, OfTwoRoutingsForTheBadSideOfTheirGoal) {
  expect_json(output_of({"size", "TR1", "TR7", "--vary", "sheath_angle=3..9", "--vary",
                         "tip_angle=1..4", "--same", "tips", "--draws", "20", "--format", "json"}),
              "size.json", fitted);
}

TEST(GoldenSize, OfAThumbThatPullsAsTwoFingers) {
  expect_json(output_of({"size", "M-1-P-2-P-3-M", "--target", "1=2,others=1", "--vary",
                         "sheath_angle=1..12", "--same", "sheath_angle[2,3]", "--draws", "20",
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

TEST(GoldenCompare, OfReadingsWithAndWithoutMotorTension) {
  const TemporaryFolder folder;
  ProcessOptions options;
  options.directory = REEVE_SOURCE_DIR;  // the file's name is printed as it was given
  const ProcessResult result = reeve(
      {"compare", "tests/golden/readings.csv", "--format", "json", "--out", folder.path().string()},
      options);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  expect_json(result.out, "compare.json");
  expect_csv(read_text(folder.path() / "residuals.csv"), "compare_residuals.csv");
}

TEST(GoldenImport, OfTheLogOfASimulatedRig) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "readings.csv").string();
  ProcessOptions options;
  options.directory = REEVE_SOURCE_DIR;
  const ProcessResult result =
      reeve({"import", "tests/golden/log.csv", "-o", file, "--format", "json"}, options);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  expect_json(result.out, "import.json");
  const std::string csv = read_text(file);
  expect_csv(csv.substr(csv.find('\n') + 1), "import_readings.csv");  // below the version
}

TEST(GoldenSchematic, OfTheSevenInThePapersGrasp) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  for (const char* name : {"tr1", "tr2", "tr3", "tr4", "tr5", "tr6", "tr7"}) {
    output_of({"show", name, "--held", "1", "--svg", file});
    expect_text(read_text(file), file_of(std::string("schematic_") + name + ".svg"));
  }
}

TEST(GoldenSchematic, OfFiveFingersReleasing) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  output_of(
      {"show", "M-1b-T-4-B-2-P-5-T-3-F", "--held", "2,3", "--direction", "release", "--svg", file});
  expect_text(read_text(file), file_of("schematic_five_fingers.svg"));
}

TEST(GoldenSchematic, OfFloatingBlocksBarsAndAnchoredTips) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  const std::vector<std::vector<std::string>> drawings{
      {"tree_of_blocks", "M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x", "1"},
      {"bars", "1x-W1/2:1-2x+3x-W2-4x+W1-Y1-W2+Y1-M+5x-M", "3"},
      {"tackle", "M-Y1-B-Y1-B-Y1-B-Y1k+Y1-1x", "none"},
      {"tackle_on_tackle", "M-Y2-Y3k+Y2-Y1-Y3k+Y3-B-Y1k+Y1-1x", "none"},
      {"tail_at_a_finger", "M-1-Y1+2-Y1-3-T-2", "2"},
      {"slider", "1x-P-2x", "none"}};
  for (const std::vector<std::string>& drawing : drawings) {
    output_of({"show", drawing[1], "--held", drawing[2], "--svg", file});
    expect_text(read_text(file), file_of("schematic_" + drawing[0] + ".svg"));
  }
}

TEST(GoldenSchematic, OfThePulleyAtTheHandIsTheFigureOfTheDocuments) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  output_of({"show", "M-Y1+F-1-Y1-2-F", "--held", "1", "--svg", file});
  expect_text(read_text(file), std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "figures" /
                                   "pulley-at-the-hand.svg");
}

// The sheet in the README is what the program draws.
TEST(GoldenSchematic, OfTheCatalogueIsTheSheetOfTheReadme) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "sheet.svg").string();
  output_of({"check", "--svg", file});
  expect_text(read_text(file),
              std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "figures" / "schematics.svg");
}

ProcessResult diagnose(const std::string& data, std::vector<std::string> options) {
  options.insert(options.begin(), {"diagnose", "tests/golden/" + data, "--format", "json"});
  ProcessOptions process;
  process.directory = REEVE_SOURCE_DIR;
  const ProcessResult result = reeve(options, process);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  return result;
}

TEST(GoldenDiagnose, OfTubesThatAreSmootherThanTheHardwareSays) {
  const TemporaryFolder folder;
  const std::string out = diagnose("diagnose_cause.csv", {"--out", folder.path().string()}).out;
  expect_json(out, "diagnose_cause.json", fitted);
  expect_csv(read_text(folder.path() / "residuals.csv"), "diagnose_cause_residuals.csv", fitted);
}

TEST(GoldenDiagnose, OfThePublishedReadingsOfTheSevenRoutings) {
  const std::string data = "../../catalog/measured/exo_glove_ii.csv";
  expect_json(diagnose(data, {}).out, "diagnose_exo_glove_ii.json", fitted);
}

TEST(GoldenDiagnose, OfAModelThatIsRight) {
  expect_json(diagnose("diagnose_none.csv", {}).out, "diagnose_none.json", fitted);
}

TEST(GoldenDiagnose, OfCausesThatTheDataCannotTellApart) {
  expect_json(diagnose("diagnose_indistinguishable.csv", {}).out, "diagnose_indistinguishable.json",
              fitted);
}

}  // namespace
}  // namespace reeve::testing
