// One sheet, three writers.
#include "reports/document/document.hpp"

#include <gtest/gtest.h>

#include "reports/document/document_latex.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

Document document() {
  Table table{{text_column("name"), number_column("travel", "mm/mm")}, {}};
  table.add({"a_b | c", "-1.25"});
  table.add({"longer", "-"});
  return {{{"", std::nullopt, {{"3 of 4 routings"}, {"PARTIAL: 100 % of none", true}}},
           {"Top 2,\nby travel", table, {{"… 1 more"}}},
           {"Notes", std::nullopt, {{"- first_thing"}, {"- 2nd"}}}}};
}

TEST(DocumentText, KeepsSectionsApart) {
  EXPECT_EQ(text(document()),
            "3 of 4 routings\n"
            "PARTIAL: 100 % of none\n"
            "\n"
            "Top 2,\n"
            "by travel\n"
            "name     travel\n"
            "a_b | c   -1.25\n"
            "longer        -\n"
            "… 1 more\n"
            "\n"
            "Notes\n"
            "- first_thing\n"
            "- 2nd\n");
}

TEST(DocumentText, WrapsTitlesAndGoesOnBelowTheEntryOfAList) {
  const Document wide{
      {{"Top 2,\nby travel", std::nullopt, {{"- the first entry"}, {"  ab cd ef gh"}}}}};
  EXPECT_EQ(text(wide, {10, false}),
            "Top 2, by\ntravel\n- the\n  first\n  entry\n  ab cd ef\n  gh\n");
}

TEST(DocumentText, ShowsCaveatsAndTitlesInColour) {
  const std::string coloured = text(document(), {0, true});
  EXPECT_TRUE(testing::has(coloured, "\x1b[33mPARTIAL: 100 % of none\x1b[0m\n"));
  EXPECT_TRUE(testing::has(coloured, "\x1b[1mTop 2,\x1b[0m\n\x1b[1mby travel\x1b[0m\n"));
}

TEST(DocumentMarkdown, HasTablesWithPipesUnitsAndCaveats) {
  EXPECT_EQ(markdown(document()),
            "3 of 4 routings\n"
            "\n"
            "**PARTIAL: 100 % of none**\n"
            "\n"
            "**Top 2, by travel**\n"
            "\n"
            "| name     | travel (mm/mm) |\n"
            "| -------- | -------------: |\n"
            "| a_b \\| c |          -1.25 |\n"
            "| longer   |              - |\n"
            "\n"
            "… 1 more\n"
            "\n"
            "**Notes**\n"
            "\n"
            "- first_thing\n"
            "- 2nd\n");
}

TEST(DocumentMarkdown, EscapesWhatWouldBeAMark) {
  Document marks;
  marks.add({"", std::nullopt, {{"_a_ *b* <c> `d` [e](f) \\g ~h uniformity_mean"}}});
  EXPECT_EQ(markdown(marks),
            "\\_a\\_ \\*b\\* \\<c> \\`d\\` \\[e\\](f) \\\\g \\~h uniformity_mean\n");
}

TEST(DocumentLatex, HasWholeTabularsAndTypesetsCaveats) {
  EXPECT_EQ(latex(document()),
            "% Tables for \\input; they need \\usepackage{booktabs} in the preamble.\n"
            "\n"
            "% 3 of 4 routings\n"
            "\\noindent PARTIAL: 100 \\% of none\\par\n"
            "\n"
            "% Top 2, by travel\n"
            "\\begin{tabular}{lr}\n"
            "  \\toprule\n"
            "  name & travel (mm/mm) \\\\\n"
            "  \\midrule\n"
            "  a\\_b \\textbar{} c & $-$1.25 \\\\\n"
            "  longer & -- \\\\\n"
            "  \\bottomrule\n"
            "\\end{tabular}\n"
            "% … 1 more\n"
            "\n"
            "% Notes\n"
            "% - first_thing\n"
            "% - 2nd\n");
}

TEST(DocumentLatex, EscapesEveryCharacterThatLatexReads) {
  EXPECT_EQ(latex_escaped("_ % & # $ { } ~ ^ \\"),
            "\\_ \\% \\& \\# \\$ \\{ \\} \\textasciitilde{} \\textasciicircum{} \\textbackslash{}");
  EXPECT_EQ(latex_escaped("5–95 % at µ = 0.18, μ, θ…"),
            "5--95 \\% at $\\mu$ = 0.18, $\\mu$, $\\theta$\\ldots{}");
  EXPECT_EQ(latex_escaped("T1->a, sheaths<=2, --format, gain[T3]"),
            "T1$\\to$a, sheaths$\\leq$2, -{}-format, gain{[}T3{]}");
  EXPECT_EQ(latex_escaped("M-1-F by -0.5 to -0.1 (-1)"), "M-1-F by $-$0.5 to $-$0.1 ($-$1)");
}

// A line end in a user's text must not end the comment.
TEST(DocumentLatex, KeepsACommentOnOneLine) {
  Document broken;
  broken.add({"", std::nullopt, {{"a\n\\input{b}\r"}}});
  EXPECT_TRUE(latex(broken).ends_with("\n% a \\input{b}\n"));
}

TEST(Documents, LeaveOutSectionsThatHoldNothing) {
  Document empty;
  empty.add({"Notes", std::nullopt, {}});
  EXPECT_EQ(text(empty), "");
}

}  // namespace
}  // namespace reeve
