// Tables as an author takes them, and what routings cost.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"
#include "tests/support/svg.hpp"

namespace reeve::testing {
namespace {

std::string printed(Arguments arguments) {
  const TemporaryFolder folder;
  ProcessOptions options{.directory = folder.path()};
  const ProcessResult result = reeve(std::move(arguments), options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result.out;
}

// In 3.5 in, the column of a two-column paper.
std::vector<Arguments> tables_of_a_column() {
  const std::string list = "rank,name,routing,uniformity_mean,efficiency_mean,sheaths";
  return {{"rank", "--catalogue", "--columns", list},
          {"rank", "--catalogue"},
          {"explore", "--fingers", "5", "--parts", "full", "--columns",
           "rank,routing,uniformity_mean,travel,sheaths"},
          {"explore", "--fingers", "4", "--parts", "full"},
          {"size", "M-1-P-2-P-3-M", "--target", "1=2,others=1", "--vary", "sheath_angle=1..12",
           "--nominal", "--columns", "dimension,unit,sized,less,more,together_less,together_more"}};
}

std::string in_a_column(Arguments arguments) {
  arguments.insert(arguments.end(), {"--format", "latex", "--text-width", "3.5in"});
  return printed(arguments);
}

TEST(TablesForPapers, HaveTheChosenColumnsInEveryFormatAndNoOtherTable) {
  const Arguments rank("rank --catalogue --columns routing,uniformity_worst,rank");
  const auto in = [&](const char* format) {
    Arguments arguments = rank;
    arguments.insert(arguments.end(), {"--format", format});
    return printed(arguments);
  };
  EXPECT_TRUE(has(in("table"),
                  "\nrouting    uniformity, worst  rank\n1-P-2-P-1              0.997     1\n"))
      << in("table");
  EXPECT_TRUE(has(in("markdown"), "| routing   | uniformity, worst | rank |\n"));
  EXPECT_EQ(count(in("latex"), "\\begin{tabular}{lrr}"), 1U);
  EXPECT_EQ(count(in("latex"), "\\begin{tabular}"), 1U);
}

TEST(TablesForPapers, HaveMeanAndWorstInColumnsOfTheirOwn) {
  const std::string latex = printed({"rank", "--catalogue", "--format", "latex"});
  EXPECT_TRUE(has(latex, "uniformity, mean & uniformity, worst & efficiency, mean"));
  EXPECT_TRUE(has(latex, " & 0.998 & 0.997 & "));
  EXPECT_TRUE(has(printed({"rank", "--catalogue"}), "0.998/0.997"));
}

// So that nobody waits for a table that cannot be.
TEST(TablesForPapers, ThatCannotBeAsNarrowAsAskedForAreRefusedBeforeTheWork) {
  const TemporaryFolder folder;
  ProcessOptions options{.directory = folder.path()};
  for (const Arguments command :
       {"rank --catalogue --out page", "explore --out page",
        "explore --out page --columns routing,uniformity_mean,efficiency_mean",
        "size TR5 --vary sheath_angle=3..9 --nominal --out page"}) {
    const auto with = [&](const std::string& width) {
      Arguments arguments = command;
      arguments.insert(arguments.end(), {"--format", "latex", "--text-width", width});
      return reeve(arguments, options);
    };
    const ProcessResult refused = with("20mm");
    SCOPED_TRACE(refused.err);
    EXPECT_EQ(refused.exit_code, 2);
    ASSERT_TRUE(refused.err.starts_with("reeve: --text-width '20 mm': expected "));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "page"));
    const std::string takes = refused.err.substr(refused.err.find("expected ") + 9);
    const ProcessResult wide = with(takes.substr(0, takes.find(' ')) + "mm");
    EXPECT_EQ(wide.exit_code, 0) << wide.err;
    if (command.front() != "explore") {
      EXPECT_EQ(wide.err, "");
    }
    std::filesystem::remove_all(folder.path() / "page");
  }
}

TEST(TablesForPapers, OfSizesHaveThoseOfTheDimensionsOrOfTheRoutings) {
  const Arguments size("size TR1 TR7 --vary sheath_angle=3..9 --nominal --columns");
  Arguments dimensions = size;
  dimensions.emplace_back("sized,dimension,slope_more");
  EXPECT_TRUE(has(printed(dimensions), "\nsized  dimension        slope, more\n"));
  Arguments routings = size;
  routings.emplace_back("name,goal_sized,efficiency_worst");
  EXPECT_TRUE(has(printed(routings), "\nname  goal sized  efficiency, worst\n"));
}

TEST(TablesForPapers, OfCharactersFitIntoThem) {
  const std::string text = printed({"rank", "--catalogue", "--text-width", "60"});
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) EXPECT_LE(line.size(), 62U) << line;
}

// With the LaTeX of Debian's texlive-latex-recommended, where it is installed.
TEST(TablesForPapers, AreTypesetWithinTheColumn) {
  // Some hundred megabytes for one test: nothing of ours installs it. Widths are tested without it
  // in tests/reports/latex_table_test.cpp.
  if (run_process({"pdflatex", "--version"}).exit_code != 0) {
    GTEST_SKIP() << "no pdflatex: texlive-latex-recommended has it, and booktabs";
  }
  const TemporaryFolder folder;
  std::string document =
      "\\documentclass[10pt]{article}\\usepackage{booktabs}\\begin{document}\\parindent=0pt\n";
  const std::vector<Arguments> tables = tables_of_a_column();
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string name = "t" + std::to_string(i);
    folder.write(name + ".tex", in_a_column(tables[i]));
    document +=
        "\\setbox0=\\vbox{\\hsize=252.945pt\\linewidth=\\hsize\\input{" + name + "}}\\box0\n";
  }
  folder.write("paper.tex", document + "\\end{document}\n");
  ProcessOptions options{.directory = folder.path()};
  const ProcessResult result =
      run_process({"pdflatex", "-interaction=nonstopmode", "-halt-on-error", "paper.tex"}, options);
  EXPECT_EQ(result.exit_code, 0) << result.out;
  EXPECT_FALSE(has(result.out, "Overfull \\hbox")) << result.out;
}

TEST(ShowCost, IsThatOfTheRanking) {
  const std::string price_file = REEVE_CATALOG_DIR "/prices/example.toml";
  const Json shown =
      Json::parse(printed({"show", "TR3", "--cost", price_file, "--format", "json"}));
  const Json ranked =
      Json::parse(printed({"rank", "TR3", "--cost", price_file, "--format", "json"}));
  EXPECT_EQ(shown["cost"], ranked["designs"][0]["cost"]);
  EXPECT_EQ(shown["prices"], ranked["settings"]["prices"]);
  const std::string table = printed({"show", "TR3", "--cost", price_file});
  EXPECT_TRUE(has(table, "\ncost ") && has(table, " EUR ")) << table;
  EXPECT_FALSE(has(printed({"show", "TR3"}), "\ncost "));
  // As little as a sheath weighs in tonnes, of which three decimals tell nothing.
  const TemporaryFolder folder;
  folder.write("tonnes.toml", "unit = \"t\"\nsheath = 2.1e-6\n");
  const std::string weighed =
      printed({"show", "TR3", "--cost", (folder.path() / "tonnes.toml").string()});
  EXPECT_TRUE(has(weighed, " 0.0000042  t ")) << weighed;
}

}  // namespace
}  // namespace reeve::testing
