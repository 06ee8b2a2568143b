// What changes where stdout is a terminal: colour and width; and that nothing does where it is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "reports/document/text_width.hpp"
#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

using Environment = std::map<std::string, std::string>;

std::string on_terminal(const Arguments& arguments, unsigned short width,
                        Environment environment = {}) {
  const TemporaryFolder folder;
  ProcessOptions options;
  options.directory = folder.path();
  options.stdout_terminal_width = width;
  options.environment = {{"TERM", "xterm"}, {"NO_COLOR", ""}, {"COLUMNS", ""}};
  for (const auto& [name, value] : environment) options.environment[name] = value;
  const ProcessResult result = reeve(arguments, options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result.out;
}

std::string piped(const Arguments& arguments, Environment environment = {}) {
  ProcessOptions options{.environment = std::move(environment)};
  return reeve(arguments, options).out;
}

bool has_colour(const std::string& text) { return text.find("\x1b[") != std::string::npos; }

std::string without_colour(const std::string& text) {
  return std::regex_replace(text, std::regex("\x1b\\[[0-9;]*m"), "");
}

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream lines(without_colour(text));
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, text_width(line));
  return widest;
}

std::vector<Arguments> commands() {
  return {{"rank", "--catalogue"},
          {"rank", "--catalogue", "--uncertainty", "--draws", "5", "--margin"},
          {"explore", "--fingers", "4", "--parts", "full"},
          {"show", "M-1b-P-2b-P-3-T-4-M"},
          {"show", "TR5", "--model", std::string(REEVE_CATALOG_DIR) + "/model/example.toml"},
          {"count"},
          {"check"},
          {"compare", readings},
          {"diagnose", std::string(REEVE_SOURCE_DIR) + "/tests/golden/diagnose_cause.csv",
           "--alpha", "0.1", "--replicates", "99"}};
}

TEST(Colour, IsThereOnATerminalAndNowhereElse) {
  EXPECT_TRUE(has_colour(on_terminal({"check"}, 200)));
  EXPECT_FALSE(has_colour(piped({"check"}, {{"TERM", "xterm"}})));
}

TEST(Colour, IsLeftOutWhereItIsNotWanted) {
  EXPECT_FALSE(has_colour(on_terminal({"check"}, 200, {{"NO_COLOR", "1"}})));
  EXPECT_FALSE(has_colour(on_terminal({"check"}, 200, {{"NO_COLOR", "0"}})));
  EXPECT_FALSE(has_colour(on_terminal({"check"}, 200, {{"TERM", "dumb"}})));
  EXPECT_FALSE(has_colour(on_terminal({"check"}, 200, {{"TERM", ""}})));
}

TEST(Colour, IsNeverTheOnlySign) {
  for (const Arguments& command :
       {Arguments{"check"}, Arguments("show TR5"), Arguments{"compare", readings}}) {
    const std::string coloured = on_terminal(command, 1000);
    EXPECT_TRUE(has_colour(coloured));
    EXPECT_EQ(without_colour(coloured), piped(command));
  }
}

TEST(Colour, IsNoPartOfAnExport) {
  for (const char* format : {"json", "csv", "markdown", "latex"}) {
    const Arguments command{"rank", "--catalogue", "--format", format};
    EXPECT_EQ(on_terminal(command, 40), piped(command)) << format;
  }
}

TEST(Width, OfTheWindowIsKept) {
  for (const Arguments& command : commands()) {
    for (const unsigned short width : std::vector<unsigned short>{60, 35}) {
      EXPECT_LE(widest_line(on_terminal(command, width)), width) << command[0];
    }
  }
}

TEST(Width, IsAskedOfTheWindowThenOfColumnsThenTaken) {
  const Arguments check{"check"};
  const std::size_t at_60 = widest_line(on_terminal(check, 60, {{"COLUMNS", "40"}}));
  EXPECT_LE(at_60, 60U);
  EXPECT_GT(at_60, 40U);
  EXPECT_EQ(on_terminal(check, 0, {{"COLUMNS", "60"}}), on_terminal(check, 60));
  for (const char* columns : {"", "0", "wide", "-5", "60x"}) {
    EXPECT_EQ(on_terminal(check, 0, {{"COLUMNS", columns}}), on_terminal(check, 80)) << columns;
  }
}

TEST(Width, LimitsNothingInAPipe) {
  EXPECT_EQ(piped({"check"}, {{"COLUMNS", "40"}}), piped({"check"}));
  EXPECT_GT(widest_line(piped({"check"})), 100U);
}

TEST(Width, ThatLeavesColumnsOutSaysWhichAndWhereTheyAre) {
  const std::string narrow = without_colour(on_terminal({"rank", "--catalogue"}, 60));
  EXPECT_TRUE(has(narrow, "\nLeft out for want of room: "));
  EXPECT_TRUE(has(narrow, "knots"));
  EXPECT_FALSE(has(on_terminal({"rank", "--catalogue"}, 200), "Left out"));
}

TEST(Progress, FitsTheWindow) {
  ProcessOptions options{.stderr_is_terminal = true};
  options.environment["TERM"] = "xterm";
  options.disturbance = Disturbance{SIGINT, [](const RunningProcess& process) {
                                      return process.err.find(" s left") != std::string::npos;
                                    }};
  const Explored explored("--fingers 9 --top 10", options);
  const std::string& err = explored.result.err;
  const std::string line = err.substr(1, err.find('\x1b') - 1);
  EXPECT_TRUE(
      std::regex_match(line, std::regex(R"(exploring \[=*> *\] +\d+ %, \d+ a second, \d+ s left)")))
      << line;
  EXPECT_LT(text_width(line), 80U);
  EXPECT_GT(text_width(line), 50U);
}

TEST(Pages, AreAnnounced) {
  const Explored explored({});
  EXPECT_TRUE(has(explored.result.out, "\nPage: out/index.html\n"));
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "page").string();
  const std::string data = std::string(REEVE_SOURCE_DIR) + "/tests/golden/diagnose_none.csv";
  for (const Arguments& arguments :
       {Arguments("show TR7"), {"rank", "TR1", "TR7"}, {"diagnose", data}}) {
    const std::string alone = reeve(arguments).out;
    Arguments with_page = arguments;
    with_page.insert(with_page.end(), {"--out", out});
    const std::string announced = reeve(with_page).out;
    EXPECT_TRUE(announced.starts_with(alone)) << announced;
    EXPECT_TRUE(announced.ends_with("\nPage: " + out + "/index.html\n")) << announced;
  }
}

}  // namespace
}  // namespace reeve::testing
