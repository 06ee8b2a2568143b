// The same tables in every format, and nothing that a reader must know left out of one.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"
#include "tests/support/svg.hpp"

namespace reeve::testing {
namespace {

std::string output(Arguments arguments, const std::string& format) {
  const TemporaryFolder folder;
  ProcessOptions options{.directory = folder.path()};
  arguments.insert(arguments.end(), {"--format", format});
  const ProcessResult result = reeve(arguments, options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  return result.out;
}

std::vector<std::pair<Arguments, std::size_t>> commands_and_their_tables() {
  const std::string data = std::string(REEVE_SOURCE_DIR) + "/tests/golden/diagnose_none.csv";
  return {{{"rank", "--catalogue"}, 2},
          {{"rank", "--catalogue", "--margin", "--uncertainty", "--draws", "5"}, 4},
          {{"explore", "--parts", "full"}, 4},
          {{"show", "TR5"}, 4},
          {{"count"}, 1},
          {{"check"}, 6},
          {{"compare", readings}, 2},
          {{"diagnose", data, "--alpha", "0.1", "--replicates", "99"}, 1},
          {{"simulate", "--routings", "TR1,TR7", "--power", "1"}, 1},
          {{"size", "TR1", "TR7", "--vary", "sheath_angle=3..9", "--nominal"}, 3}};
}

TEST(Formats, HaveTheSameTablesInMarkdownAndLatex) {
  for (const auto& [arguments, tables] : commands_and_their_tables()) {
    SCOPED_TRACE(arguments[0]);
    const std::string markdown = output(arguments, "markdown");
    const std::string latex = output(arguments, "latex");
    EXPECT_EQ(count(markdown, "\n| --") + markdown.starts_with("| --"), tables);
    EXPECT_EQ(count(latex, "\\begin{tabular}{"), tables);
    EXPECT_EQ(count(latex, "\\end{tabular}\n"), tables);
    for (const char* rule : {"\\toprule\n", "\\midrule\n", "\\bottomrule\n"}) {
      EXPECT_EQ(count(latex, rule), tables);
    }
    // One line for each row, under one for the headings and in Markdown one for the rule.
    EXPECT_EQ(count(latex, " \\\\\n"), count("\n" + markdown, "\n| ") - tables);
    EXPECT_TRUE(latex.starts_with("% ") && latex.find("booktabs") < latex.find('\n'));
  }
}

TEST(Formats, PutUnitsIntoTheHeadings) {
  EXPECT_TRUE(has(output({"compare", readings}, "markdown"), " mean measured (N) "));
  EXPECT_TRUE(has(output({"show", "TR5"}, "latex"), "held & T1 (\\%) & T2 (\\%)"));
}

TEST(Formats, SayThatDataAreSimulated) {
  EXPECT_TRUE(has(output({"compare", readings}, "table"), "\nThe data are simulated: "));
  EXPECT_TRUE(has(output({"compare", readings}, "markdown"), "\n**The data are simulated: "));
  EXPECT_TRUE(has(output({"compare", readings}, "latex"), "\n\\noindent The data are simulated: "));
}

TEST(Formats, SayThatFingersAreToldApart) {
  EXPECT_TRUE(has(output({"explore", "--grasps", "paper"}, "markdown"), "\n**Note: "));
  EXPECT_TRUE(has(output({"explore", "--grasps", "paper"}, "latex"), "\n\\noindent Note: "));
}

TEST(Formats, SayThatAnExplorationWasStopped) {
  for (const auto& [format, note] :
       {std::pair{"table", "\nPARTIAL: stopped after "}, std::pair{"markdown", "\n**PARTIAL: "},
        std::pair{"latex", "\n\\noindent PARTIAL: "}}) {
    ProcessOptions options{
        .disturbance = Disturbance{SIGINT, after_it_catches(SIGINT, std::chrono::seconds(1))}};
    const Explored explored({"--fingers", "9", "--top", "10", "--format", format}, options);
    EXPECT_EQ(explored.result.exit_code, 3);
    EXPECT_TRUE(has(explored.result.out, note));
  }
}

TEST(Formats, AreThoseOfTheHelp) {
  for (const auto& [command, formats] : std::vector<std::pair<std::string, std::string>>{
           {"rank", "{table,json,csv,markdown,latex}"},
           {"show", "{table,json,dot,markdown,latex}"},
           {"explore", "{table,json,markdown,latex}"},
           {"count", "{table,json,markdown,latex}"},
           {"check", "{table,json,markdown,latex}"},
           {"catalogue", "{table,json,markdown,latex}"},
           {"compare", "{table,json,markdown,latex}"},
           {"diagnose", "{table,json,markdown,latex}"},
           {"simulate", "{table,json,markdown,latex}"},
           {"size", "{table,json,markdown,latex}"}}) {
    EXPECT_TRUE(has(reeve({command, "--help"}).out, formats)) << command;
  }
}

// Only the tables and what belongs to them: files are announced on the terminal alone.
TEST(Formats, AnnounceNoFilesInAnExport) {
  EXPECT_FALSE(has(output({"explore"}, "latex"), "Written"));
  EXPECT_TRUE(has(output({"explore"}, "table"), "\nWritten: "));
}

}  // namespace
}  // namespace reeve::testing
