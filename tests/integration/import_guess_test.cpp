// `import --guess` from end to end, on the log of a simulated rig as a German logger writes it.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"
#include "tests/support/rig_log.hpp"

namespace reeve::testing {
namespace {

std::string english_log() {
  RigPlan plan;
  plan.strokes = 1;
  const std::vector<RigRun> runs{
      {"1", "TR7", "1", {{0.8, 0.9}, {0.8, 0.9}, {0.8, 0.9}, {0.8, 0.9}}}};
  return rig_csv(rig_log(plan, runs), runs, {.position = true, .speed = false, .labels = false});
}

// The same numbers with decimal commas, between semicolons, under other names.
std::string german_log(const std::string& english) {
  const std::map<std::string, std::string> names{{"time_s", "Zeit [s]"},
                                                 {"position_mm", "Weg [mm]"},
                                                 {"motor_tension_N", "Seilkraft Motor [N]"},
                                                 {"T1_N", "Kraft 1 [N]"},
                                                 {"T2_N", "Kraft 2 [N]"},
                                                 {"T3_N", "Kraft 3 [N]"},
                                                 {"T4_N", "Kraft 4 [N]"}};
  std::istringstream lines(english);
  std::string text;
  bool is_header = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::string changed;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      std::replace(cell.begin(), cell.end(), '.', ',');
      changed += (changed.empty() ? "" : ";") + (is_header ? names.at(cell) : cell);
    }
    text += changed + "\r\n";
    is_header = false;
  }
  return text;
}

ProcessResult in(const TemporaryFolder& folder, const std::string& command) {
  return run_process({"/bin/sh", "-c", command}, {.directory = folder.path()});
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  const std::size_t begin = text.find_last_of('\n', end) + 1;
  return text.substr(begin, end + 1 - begin);
}

std::string readings_alone(const std::string& csv) {
  std::istringstream lines(csv);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('#')) text += line + '\n';
  }
  return text;
}

TEST(ImportGuess, ProposesACommandThatImportsAGermanLog) {
  const TemporaryFolder folder;
  const std::string english = english_log();
  folder.write("english.csv", english);
  folder.write("Messung 1.csv", german_log(english));
  const ProcessResult guess =
      reeve({"import", "Messung 1.csv", "--guess", "--routing", "TR7", "--held", "1"},
            {.directory = folder.path()});
  EXPECT_EQ(guess.exit_code, 0) << guess.out;
  EXPECT_TRUE(has(guess.out, "7 columns separated by semicolons"));
  EXPECT_TRUE(has(guess.out, "First samples as understood"));
  EXPECT_FALSE(has(guess.out, "Problems"));
  const std::string command = last_line(guess.out);
  ASSERT_TRUE(command.starts_with("reeve import 'Messung 1.csv'")) << guess.out;
  const ProcessResult import = in(folder, reeve_path() + command.substr(5));
  ASSERT_EQ(import.exit_code, 0) << command << import.err;
  const ProcessResult same =
      reeve("import english.csv --routing TR7 --held 1 -o same.csv", {.directory = folder.path()});
  ASSERT_EQ(same.exit_code, 0) << same.err;
  const std::string readings = readings_alone(read_text(folder.path() / "readings.csv"));
  EXPECT_EQ(readings, readings_alone(read_text(folder.path() / "same.csv")));
  EXPECT_GT(std::count(readings.begin(), readings.end(), '\n'), 3);
}

TEST(ImportGuess, ListsAllThatIsMissingAtOnce) {
  const TemporaryFolder folder;
  folder.write("log.csv", "Zeit;Kraft 1 [N];Motorstrom [A]\n1.5.2024;1,5;0,2\n1.5.2024;1,6;0,2\n");
  const ProcessResult guess = reeve("import log.csv --guess", {.directory = folder.path()});
  EXPECT_EQ(guess.exit_code, 1);
  for (const char* piece :
       {"expected the time of the sample", "the header has one column of tensions",
        "a current is no tension", "- the routing: --routing", "- all samples are of run 1",
        "- no finger is held", "neither position nor speed", "no motor tension is logged",
        "Problems\n"}) {
    EXPECT_TRUE(has(guess.out, piece)) << piece << " in " << guess.out;
  }
  // No command could import this log.
  EXPECT_FALSE(has(guess.out, "reeve import"));
}

TEST(ImportGuess, TellsEqualFaultsOfSeveralRowsOnce) {
  const TemporaryFolder folder;
  folder.write("log.csv", "time_s;Kraft 1 [N];Kraft 2 [N]\n0;a;1\n1;b;1\n2;c;1\n3;1;d\n");
  const ProcessResult guess =
      reeve("import log.csv --guess --format json", {.directory = folder.path()});
  const Json json = Json::parse(guess.out);
  ASSERT_EQ(json["missing"].size(), 3U) << guess.out;  // the third: the routing
  EXPECT_TRUE(has(json["missing"][0].get<std::string>(), "log.csv:2: column 'Kraft 1 [N]' = 'a'"));
  EXPECT_TRUE(json["missing"][0].get<std::string>().ends_with(" (and 2 further rows)"));
  EXPECT_TRUE(json["command"].is_null());
}

TEST(ImportGuess, FindsTheHeaderBelowATitle) {
  const TemporaryFolder folder;
  folder.write("log.csv", "Messung vom 14.03.2024\r\n" + german_log(english_log()));
  const ProcessResult guess = reeve("import log.csv --guess", {.directory = folder.path()});
  EXPECT_EQ(guess.exit_code, 1);
  EXPECT_TRUE(has(guess.out, "7 columns separated by semicolons"));
  EXPECT_TRUE(has(guess.out, "a title above the header is not read: 'Messung vom 14.03.2024'"));
  const std::string command = last_line(guess.out);
  ASSERT_TRUE(has(command, " --routing ROUTING ")) << guess.out;
  std::string named = reeve_path() + command.substr(5);
  named.replace(named.find("ROUTING"), 7, "TR7");
  const ProcessResult import = in(folder, named);
  EXPECT_EQ(import.exit_code, 0) << import.err;
  EXPECT_TRUE(has(import.out, "Messung vom 14.03.2024"));
}

TEST(ImportGuess, SuggestsTheNearestHeaderForAMappedColumn) {
  const TemporaryFolder folder;
  folder.write("log.csv", "time_s;Kraft F1 [N]\n0;1,5\n1;1,6\n");
  const ProcessResult import =
      reeve({"import", "log.csv", "--map", "Kraft F1=T1_N"}, {.directory = folder.path()});
  EXPECT_EQ(import.exit_code, 2);
  EXPECT_TRUE(has(import.err, "did you mean Kraft F1 [N]?"));
}

TEST(ImportGuess, WritesNothingAndRefusesToBeAskedTo) {
  const TemporaryFolder folder;
  folder.write("log.csv", english_log());
  const ProcessResult both =
      reeve("import log.csv --guess -o readings.csv", {.directory = folder.path()});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_TRUE(has(both.err, "--output excludes --guess")) << both.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "readings.csv"));
}

}  // namespace
}  // namespace reeve::testing
