// Tables for papers: chosen columns, decimal marks below each other, and a stated width.

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "reports/document/chosen_columns.hpp"
#include "reports/document/document_latex.hpp"
#include "tests/support/has.hpp"
#include "tests/support/svg.hpp"

namespace reeve::testing {
namespace {

Table list() {
  Table table{{number_column("rank"), text_column("routing"), number_column("way", "mm", 2),
               number_column("share of all")},
              {}};
  table.columns[2].key = "way_mm";
  table.add({"1", "M-1b-B-2b+F-3b-F", "-1.25", "7"});
  table.add({"12", "1-P-2-P-1", "any", "0.5"});
  return table;
}

std::string typeset(const Table& table, double width_mm = 0) {
  return latex(Document{{{"", table, {}}}}, width_mm * pt_in_mm);
}

TEST(ChosenColumns, AreThoseAndInThatOrder) {
  const Table chosen = with_columns(list(), {"way_mm", "rank"});
  ASSERT_EQ(chosen.columns.size(), 2U);
  EXPECT_EQ(chosen.columns[0].heading, "way");
  EXPECT_EQ(chosen.rows[1].cells, (std::vector<std::string>{"any", "12"}));
  EXPECT_EQ(chosen.columns[0].dispensable, 0U);
  EXPECT_TRUE(chosen.chosen);
}

TEST(ChosenColumns, ThatAreNotThereAreNamedWithWhatIs) {
  const auto fault_of = [](const std::string& text) {
    try {
      parse_columns(text, {"rank", "routing"});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(fault_of(" rank, routing "), "");
  EXPECT_EQ(fault_of("rank,way"),
            "columns 'rank,way': there is no column 'way'; expected any of rank, routing");
  EXPECT_EQ(fault_of("rank,rank"), "columns 'rank,rank': 'rank' is there twice");
  EXPECT_EQ(fault_of("rank,"),
            "columns 'rank,': nothing stands before or behind a comma; expected a name of a column "
            "there, or no comma");
}

TEST(LatexTables, HaveDecimalMarksBelowEachOther) {
  const std::string text = typeset(list());
  EXPECT_TRUE(has(text, "1 & M-1b-B-2b+F-3b-F & $-$1.25 & 7\\phantom{.0} \\\\\n")) << text;
  EXPECT_TRUE(has(text, "12 & 1-P-2-P-1 & any & 0.5 \\\\\n")) << text;
  EXPECT_TRUE(has(text, "\\begin{tabular}{rlrr}"));
  EXPECT_FALSE(has(text, "footnotesize"));
}

TEST(LatexTables, OfAWidthHaveHeadingsInSeveralLines) {
  const std::string text = typeset(list(), 88);
  EXPECT_TRUE(
      has(text, "{\\footnotesize\\setlength{\\tabcolsep}{3pt}%\n\\begin{tabular}{@{}rlrr@{}}"))
      << text;
  EXPECT_TRUE(has(text, "   &  & way & share \\\\\n  rank & routing & (mm) & of all \\\\\n"))
      << text;
}

TEST(LatexTables, TooWideWrapRoutingsAtTheirDashes) {
  const std::string text = typeset(with_columns(list(), {"rank", "routing", "way_mm"}), 37);
  EXPECT_TRUE(has(text, "@{}rp{")) << text;
  EXPECT_TRUE(
      has(text, "\\raggedright M-1b-B-2b+\\allowbreak{}F-3b-F & $-$1.25 \\tabularnewline\n"))
      << text;
  EXPECT_FALSE(has(text, "\\\\\n"));
}

TEST(LatexTables, StillTooWideAreRefusedBeforehandWithWhatFits) {
  const Table chosen = with_columns(list(), {"rank", "routing", "way_mm", "share of all"});
  const auto complaint = [](const Table& table, double width_mm) -> std::string {
    try {
      require_fits(Document{{{"", table, {}}}}, width_mm * pt_in_mm);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string refused = complaint(chosen, 26);
  EXPECT_EQ(refused.find("--text-width '26 mm': expected "), 0U) << refused;
  EXPECT_TRUE(has(refused, "or fewer of them: rank,routing fit")) << refused;
  const double takes_mm = least_width_pt(Document{{{"", chosen, {}}}}) / pt_in_mm;
  EXPECT_EQ(complaint(chosen, takes_mm + 0.01), "");
  EXPECT_NE(complaint(chosen, takes_mm - 0.01), "");
  // Of columns that nobody chose it is enough that each stands beside the first.
  EXPECT_EQ(complaint(list(), 26), "");
  EXPECT_EQ(complaint(list(), 5).find("--text-width '5 mm': expected "), 0U)
      << complaint(list(), 5);
  // What only the results show to be too wide goes on below.
  EXPECT_EQ(count(typeset(chosen, 26), "\\begin{tabular}"), 2U);
}

TEST(LatexTables, StillTooWideLeaveColumnsOutOrGoOnBelow) {
  const std::string left_out = typeset(list(), 34);
  EXPECT_TRUE(has(left_out, "% Left out for want of room: way\n")) << left_out;
  EXPECT_EQ(count(left_out, "\\begin{tabular}"), 1U);
  Table wanted = list();
  for (TableColumn& column : wanted.columns) column.dispensable = 0;
  const std::string parts = typeset(wanted, 26);
  EXPECT_EQ(count(parts, "\\begin{tabular}"), 2U) << parts;
  EXPECT_EQ(count(parts, "rank & "), 2U);
}

// As pdflatex measures them in \footnotesize.
TEST(LatexWidths, AreThoseOfComputerModern) {
  EXPECT_NEAR(latex_width_pt("Mm0"), 19.117, 0.4);
  EXPECT_NEAR(latex_width_pt("uniformity"), 38.966, 0.4);
  EXPECT_NEAR(latex_width_pt("all at once"), 38.723, 0.4);
  EXPECT_NEAR(latex_width_pt("M-1b-B-2b+F-3b-F"), 72.584, 0.7);
  EXPECT_NEAR(latex_width_pt("0.998"), 19.361, 0.2);
  EXPECT_GT(latex_width_pt("μ"), 4);
  EXPECT_LT(latex_width_pt("μ"), 9);
}

}  // namespace
}  // namespace reeve::testing
