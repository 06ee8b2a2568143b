#include "catalog/number_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "reports/check_report.hpp"
#include "tests/support/edited_catalogue.hpp"

namespace reeve {
namespace {

using testing::TemporaryFolder;

const CheckReport& shipped() {
  static const CheckReport report = check(read_catalogue(REEVE_CATALOG_DIR));
  return report;
}

const CheckItem* find(const CheckReport& report, const std::string& routing,
                      const std::string& source, const std::string& quantity) {
  const auto found =
      std::find_if(report.items.begin(), report.items.end(), [&](const CheckItem& item) {
        return item.routing == routing && item.source == source &&
               quantity_text(item.quantity) == quantity;
      });
  return found == report.items.end() ? nullptr : &*found;
}

CheckItem item(const std::string& routing, const std::string& source, const std::string& quantity) {
  const CheckItem* found = find(shipped(), routing, source, quantity);
  if (found == nullptr) throw std::runtime_error("no item " + source + " " + quantity);
  return *found;
}

struct Edited : testing::EditedCatalogue {
  using EditedCatalogue::EditedCatalogue;

  void write(const std::string& name, const std::string& text) const { folder().write(name, text); }
  CheckReport check() const { return reeve::check(read_catalogue(path())); }
  std::string without_path(const std::string& text) const { return folder().without_path(text); }
};

TEST(CheckOfTheShippedCatalogue, LeavesNoNumberUnexplained) {
  EXPECT_EQ(shipped().count(CheckStatus::differs), 0U);
  EXPECT_EQ(shipped().count(CheckStatus::agrees), 90U);
  EXPECT_EQ(shipped().count(CheckStatus::explained), 30U);
  // 7 tables of 8 numbers and a carriage, 7 closed forms of 4, Eq. 16, 7 lines of Fig. 9 (b) of 4.
  EXPECT_EQ(shipped().items.size(), 7U * 9 + 7 * 4 + 1 + 7 * 4);
}

TEST(CheckOfTheShippedCatalogue, GivesAReasonExactlyWhereANumberDoesNotAgree) {
  for (const CheckItem& item : shipped().items) {
    EXPECT_EQ(item.reason.empty(), item.status == CheckStatus::agrees)
        << quantity_text(item.quantity);
    EXPECT_FALSE(item.source.empty());
  }
}

TEST(CheckOfTheShippedCatalogue, FindsEveryClosedFormInTheSolver) {
  std::size_t equations = 0;
  for (const CheckItem& item : shipped().items) {
    if (!item.printed.empty()) continue;
    ++equations;
    EXPECT_EQ(item.status, CheckStatus::agrees) << item.routing << quantity_text(item.quantity);
    EXPECT_NEAR(item.computed / item.published, 1, 1e-9);
  }
  EXPECT_EQ(equations, 28U);
}

TEST(CheckOfTheShippedCatalogue, ExplainsExactlyTheKnownFaults) {
  std::vector<std::string> explained;
  for (const CheckItem& item : shipped().items) {
    if (item.status != CheckStatus::explained) continue;
    const std::string id = item.routing + " " + item.source;
    if (explained.empty() || explained.back() != id) explained.push_back(id);
  }
  EXPECT_EQ(explained, (std::vector<std::string>{"TR4 Table IV", "TR4 Fig. 9 (b)", "TR4 Table IV",
                                                 "TR5 Table V", "TR5 Fig. 9 (b)", "TR5 Table V",
                                                 "TR5 Eq. 16, last line", "TR7 Table VII"}));
}

TEST(CheckOfTheShippedCatalogue, FindsOneSheathMissingInTableFour) {
  EXPECT_EQ(item("TR4", "Table IV", "T1").status, CheckStatus::agrees);
  EXPECT_EQ(item("TR4", "Table IV", "T3").reason,
            "0.05 is the computed 0.01702 without 1 sheath loss e^(-phi_s) (times 3.099), which "
            "gives 0.05275");
  EXPECT_EQ(item("TR4", "Table IV", "share of T1, %").reason,
            "54 % is the share with T3, T4 without 1 sheath loss e^(-phi_s) (times 3.099), which "
            "gives 53.92 %");
}

TEST(CheckOfTheShippedCatalogue, DerivesTheSharesOfTableFiveButNotItsScale) {
  EXPECT_EQ(item("TR5", "Table V", "share of T3, %").reason,
            "10 % is the share with T3, T4 without 1 sheath loss e^(-phi_s) (times 3.099), which "
            "gives 9.854 %; all 4 shares of Table V repeat those of Table IV, for TR4, digit by "
            "digit");
  EXPECT_EQ(
      item("TR5", "Table V", "T1").reason,
      "0.18 is the 0.29 printed in Table IV for TR4 times one number between 0.593 and 0.649, "
      "as are all 4 tensions of Table V; no one number turns the computed tensions into them, "
      "and where the number comes from is not known");
}

TEST(CheckOfTheShippedCatalogue, WeighsTableSevenAtTheCarriage) {
  EXPECT_EQ(item("TR7", "Table VII", "T1").reason,
            "0.32 is the computed 0.08081 times 4, which gives 0.3232");
  EXPECT_EQ(item("TR7", "Table VII", "T_M that the printed tensions ask for").reason,
            "the printed tensions ask for a motor tension of 3.966 ± 0.062; with the computed T1, "
            "T2, T3, T4 in place of the printed, 1.000; those of the strands that sheaths pull add "
            "up to 1.28, more than T_M, though a sheath only takes tension away");
}

TEST(CheckOfTheShippedCatalogue, FindsTheReversedSheathOfEquation16) {
  const CheckItem found =
      item("TR5", "Eq. 16, last line", "T_M that the equation as printed asks for");
  EXPECT_EQ(found.published, 1);
  EXPECT_NEAR(found.computed, 0.973937, 1e-6);
  EXPECT_EQ(found.reason,
            "with the sheath between T4 and d sliding as printed, the motor-side tensions of Eqs. "
            "17, 18 add up to 0.973937; with that direction reversed, to 1.000000");
}

TEST(CheckOfTheShippedCatalogue, ListsTheMisprintsThatChangeNoNumber) {
  std::vector<std::string> places;
  for (const CheckedMisprint& misprint : shipped().misprints) {
    places.push_back(misprint.routing + " " + misprint.source);
  }
  EXPECT_EQ(places,
            (std::vector<std::string>{"TR2 Table II", "TR4 Eq. 13", "TR6 Eq. 19", "TR7 Eq. 22"}));
}

TEST(Check, ReportsAWrongPrintedNumber) {
  const CheckReport report = Edited("tr2.toml", "\"0.07\"", "\"0.08\"").check();
  EXPECT_EQ(report.count(CheckStatus::differs), 1U);
  const CheckItem* wrong = find(report, "TR2", "Table II", "T3");
  ASSERT_NE(wrong, nullptr);
  EXPECT_EQ(wrong->status, CheckStatus::differs);
  EXPECT_EQ(wrong->reason, "0.08 is printed and 0.06642 computed, and no listed fault explains it");
}

TEST(Check, TakesEveryPrintedDigitSeriously) {
  EXPECT_EQ(Edited("tr1.toml", "\"0.32\"", "\"0.323\"").check().count(CheckStatus::differs), 0U);
  EXPECT_EQ(Edited("tr1.toml", "\"0.32\"", "\"0.320\"").check().count(CheckStatus::differs), 2U);
}

TEST(Check, ReportsAWrongNumberThatAFaultCannotExplain) {
  const CheckReport report = Edited("tr4.toml", "\"0.05\"", "\"0.06\"").check();
  EXPECT_EQ(find(report, "TR4", "Table IV", "T3")->status, CheckStatus::differs);
  EXPECT_EQ(find(report, "TR4", "Table IV", "T4")->status, CheckStatus::explained);
  EXPECT_EQ(find(report, "TR4", "Table IV", "T_M that the printed tensions ask for")->status,
            CheckStatus::differs);
}

TEST(Check, ReportsACarriageThatTheExplainedNumbersDoNotBalance) {
  const CheckReport report = Edited("tr4.toml", "\"0.29\"", "\"0.40\"").check();
  EXPECT_EQ(find(report, "TR4", "Table IV", "T3")->status, CheckStatus::explained);
  const CheckItem* carriage =
      find(report, "TR4", "Table IV", "T_M that the printed tensions ask for");
  EXPECT_EQ(carriage->status, CheckStatus::differs);
  EXPECT_EQ(carriage->reason, "the printed tensions ask for a motor tension of 1.446 ± 0.033");
}

TEST(Check, ReportsAWrongClosedForm) {
  const CheckReport report =
      Edited("tr6.toml", "{ sheath = 1, tube = 1 }", "{ sheath = 1 }").check();
  EXPECT_EQ(report.count(CheckStatus::differs), 1U);
  EXPECT_EQ(find(report, "TR6", "Eqs. 20, 21", "T2")->reason,
            "the closed form gives 0.161613 and the solver 0.0918097");
}

TEST(Check, RejectsAListedFaultWhoseArithmeticFails) {
  const CheckReport report = Edited("tr7.toml", "times = 4", "times = 3").check();
  for (const char* strand : {"T1", "T2", "T3", "T4"}) {
    EXPECT_EQ(find(report, "TR7", "Table VII", strand)->status, CheckStatus::differs);
  }
}

TEST(Check, RejectsAListedFaultAtOtherStrands) {
  const CheckReport report = Edited("tr4.toml", "strands = [3, 4]", "strands = [3]").check();
  EXPECT_EQ(find(report, "TR4", "Table IV", "T3")->status, CheckStatus::explained);
  EXPECT_EQ(find(report, "TR4", "Table IV", "T4")->status, CheckStatus::differs);
}

TEST(Check, RejectsAListedRepetitionThatDoesNotOccur) {
  const std::string repeats = "kind = \"repeats\"\nrouting = \"TR4\"";
  const Edited edited("tr5.toml", repeats, "kind = \"repeats\"\nrouting = \"TR1\"");
  const CheckReport report = edited.check();
  EXPECT_EQ(report.count(CheckStatus::differs), 1U);
  const CheckItem* idle = find(report, "TR5", "Table V", "numbers explained by listed fault 2");
  ASSERT_NE(idle, nullptr);
  EXPECT_EQ(idle->status, CheckStatus::differs);
  EXPECT_EQ(edited.without_path(idle->reason),
            "the listed fault 'repeats' (tr5.toml:49:1) explains no number that differs");
}

TEST(Check, RejectsAListedProportionThatDoesNotHold) {
  const CheckReport report = Edited("tr5.toml", "kind = \"proportional\"\nrouting = \"TR4\"",
                                    "kind = \"proportional\"\nrouting = \"TR1\"")
                                 .check();
  EXPECT_EQ(find(report, "TR5", "Table V", "T1")->status, CheckStatus::differs);
  EXPECT_EQ(find(report, "TR5", "Table V", "share of T1, %")->status, CheckStatus::explained);
}

// Table VII is a multiple of any table of equal numbers, but of the computed tensions as well.
TEST(Check, RejectsAListedProportionWhereAMultipleOfTheComputedTensionsFits) {
  const Edited edited("tr7.toml", "kind = \"factor\"\nstrands = [1, 2, 3, 4]\ntimes = 4",
                      "kind = \"proportional\"\nrouting = \"Even\"");
  edited.write("even.toml",
               "name = \"Even\"\nword = \"M-1b-T-2-F\"\nheld = [1]\n[table]\nsource = \"none\"\n"
               "tension = [\"0.50\", \"0.50\", \"0.50\", \"0.50\"]\n"
               "share_percent = [\"25\", \"25\", \"25\", \"25\"]\n");
  const CheckReport report = edited.check();
  EXPECT_EQ(find(report, "TR7", "Table VII", "T1")->status, CheckStatus::differs);
}

TEST(Check, ReportsAFaultListedForNumbersThatAgree) {
  const CheckReport report =
      Edited("tr1.toml", "carriage = [{}]",
             "carriage = [{}]\n[[fault]]\nkind = \"factor\"\nstrands = [1]\ntimes = 2\n")
          .check();
  EXPECT_EQ(report.count(CheckStatus::differs), 1U);
  EXPECT_NE(find(report, "TR1", "Table I", "numbers explained by listed fault 1"), nullptr);
}

TEST(Check, RejectsAReversedContactThatIsPrintedRight) {
  const CheckReport report =
      Edited("tr5.toml", "printed_higher = \"strand\"", "printed_higher = \"segment\"").check();
  EXPECT_EQ(report.count(CheckStatus::differs), 1U);
  EXPECT_EQ(
      find(report, "TR5", "Eq. 16, last line", "T_M that the equation as printed asks for")->status,
      CheckStatus::differs);
}

TEST(Check, SkipsEntriesWithoutPublishedNumbers) {
  const TemporaryFolder folder;
  folder.write("x.toml", "name = \"X\"\nword = \"M-F\"\n");
  EXPECT_TRUE(check(read_catalogue(folder.path())).items.empty());
}

// The figure in which another routing has the same lines is the one that is meant.
TEST(CheckOfAFault, FindsRepeatedLinesInTheSameFigure) {
  const std::string figure = "[[lines]]\nsource = \"Fig. 9 (b)\"";
  const Edited edited("tr4.toml", figure,
                      "[[lines]]\nsource = \"Fig. 8\"\nmu = 0.09\nshare_percent = [\"30\", "
                      "\"30\", \"20\", \"20\"]\nread_to_percent = 0.3\n\n" +
                          figure);
  const CheckReport report = edited.check();
  const CheckItem* repeated = find(report, "TR5", "Fig. 9 (b)", "share of T3, %");
  ASSERT_NE(repeated, nullptr);
  EXPECT_NE(repeated->reason.find("repeat those of Fig. 9 (b), for TR4"), std::string::npos)
      << repeated->reason;
}

}  // namespace
}  // namespace reeve
