#include "studies/publication_check.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/results/check_words.hpp"
#include "studies/check.hpp"
#include "tests/studies/shipped_catalogue.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/edited_catalogue.hpp"

namespace reeve {
namespace {

using testing::shipped_catalogue;
using testing::shipped_folder;

struct Edited : testing::EditedCatalogue {
  using EditedCatalogue::EditedCatalogue;

  CheckReport check() const {
    return check_all(read_catalogue(path()), CatalogueFiles::in(path()));
  }
  std::string error() const {
    return folder().error_of([&] { check(); });
  }
};

const CheckReport& shipped() {
  static const CheckReport report =
      check_all(shipped_catalogue(), CatalogueFiles::in(shipped_folder));
  return report;
}

const CheckItem& item(const CheckReport& report, const std::string& routing,
                      CheckedQuantity quantity) {
  for (const CheckItem& item : report.items) {
    if (item.routing == routing && item.quantity == quantity) return item;
  }
  throw std::runtime_error("no item " + routing + " " + quantity_text(quantity));
}

constexpr CheckedQuantity balance{CheckedKind::indicator, 2};
constexpr CheckedQuantity efficiency{CheckedKind::indicator, 4};
constexpr CheckedQuantity mean{CheckedKind::indicator_mean, 0};

TEST(CheckOfTheArticle, CoversItsThirtyFiveIndicatorsSevenMeansAndSevenSums) {
  std::size_t indicators = 0, means = 0, sums = 0;
  for (const CheckItem& item : shipped().items) {
    indicators += item.quantity.kind == CheckedKind::indicator ? 1 : 0;
    means += item.quantity.kind == CheckedKind::indicator_mean ? 1 : 0;
    sums += item.quantity.kind == CheckedKind::tension_sum ? 1 : 0;
    EXPECT_NE(item.status, CheckStatus::differs) << item.source << quantity_text(item.quantity);
  }
  EXPECT_EQ(indicators, 35U);
  EXPECT_EQ(means, 7U);
  EXPECT_EQ(sums, 7U);
}

// Closely, not only within what the readings allow: but for the numbers with a listed fault, and
// for balances of TR6 and TR7, whose means over trials lie below what the mean readings give.
TEST(CheckOfTheArticle, FindsItsTableToFourHundredths) {
  for (const CheckItem& item : shipped().items) {
    if (item.quantity.kind != CheckedKind::indicator) continue;
    const bool below = item.quantity == balance && (item.routing == "TR6" || item.routing == "TR7");
    if (item.status == CheckStatus::explained) continue;
    EXPECT_NEAR(item.computed, item.published + (below ? 0.06 : 0), below ? 0.01 : 0.035)
        << item.routing << quantity_text(item.quantity);
  }
}

TEST(CheckOfTheArticle, ExplainsExactlyTheseNumbers) {
  std::vector<std::string> explained;
  for (const CheckItem& item : shipped().items) {
    if (item.status != CheckStatus::explained) continue;
    if (item.source.rfind("Dual", 0) == 0 || item.source.rfind("Exo", 0) == 0) {
      explained.push_back(item.routing + " " + quantity_text(item.quantity));
    }
  }
  EXPECT_EQ(explained,
            (std::vector<std::string>{"TR3 torsional balance", "TR5 authors' efficiency",
                                      "TR5 transmission", "TR5 mean of the five indicators",
                                      " friction coefficient", " designs of 3 fingers",
                                      " designs of 5 fingers", " error of the equations' shares, %",
                                      " error of the equations' shares, %"}));
}

// T_M with d pulled: 36.46/r + 2 · 31.67 r + 14.92/r, r from TR1: 33.89 · 4 · 5.54 / (10 · 99.88).
TEST(CheckOfTheArticle, TurnsSheathDOfTr5Round) {
  const double r = 33.89 * 4 * 5.54 / (10 * 99.88);
  const double sum = 36.46 + 31.67 + 16.92 + 14.92;
  const CheckItem& found = item(shipped(), "TR5", efficiency);
  EXPECT_NEAR(found.computed, 10 * sum / (36.46 / r + 2 * 31.67 * r + 14.92 / r), 1e-9);
  EXPECT_NEAR(found.computed, 8.62, 0.005);
  EXPECT_EQ(found.reason,
            "9.31 follows if the tendon is taken to slide out of the sheath at T4, from the motor "
            "to the hand (9.314); it is pulled into it, so that T_M has T4 / 0.752 and not T4 x "
            "0.752");
}

TEST(CheckOfTheArticle, WeighsExchangedRows) {
  EXPECT_EQ(item(shipped(), "TR3", balance).reason,
            "9.60 is beyond what the readings of TR3 allow (9.534) and what those of TR6 give; the "
            "rows of TR3 and TR6 fit each other's readings better than their own (sum of squared "
            "differences 0.0009 instead of 0.0108); exchanged, TR3 has the mean 7.80 and TR6 7.82");
}

TEST(CheckOfTheArticle, SaysThatTheCoefficientOfTheSheathsIsNeitherRatioNorExponent) {
  const CheckItem& found = item(shipped(), "", {CheckedKind::friction_coefficient, 0});
  EXPECT_NEAR(found.computed, 0.285, 0.0005);
  EXPECT_EQ(found.reason,
            "the indicators need a sheath that lets 0.752 ± 0.009 through, which is an exponent of "
            "0.285; 0.651 is neither: as the ratio it would make TR1's transmission 4.80, as the "
            "exponent 3.84, where 5.54 is printed");
}

TEST(CheckOfTheArticle, CountsDesignsOfOddNumbersOfFingersLikeEvenOnes) {
  for (const int fingers : {2, 3, 4, 5, 6}) {
    const CheckItem& found = item(shipped(), "", {CheckedKind::design_count, fingers});
    EXPECT_EQ(found.computed, std::ldexp(2, fingers) - 1);
    EXPECT_EQ(found.published, std::ldexp(fingers % 2 == 0 ? 2 : 1, fingers) - 1);
  }
}

double share_error_by_hand(double mu, bool one_sheath) {
  const auto model = testing::closed_forms(mu, one_sheath ? mu / 2 : mu);
  const double read[7][4] = {{33.89, 28.07, 22.91, 15.01}, {28.65, 25.35, 20.52, 25.35},
                             {22.63, 27.29, 26.78, 23.20}, {36.11, 30.84, 18.35, 14.54},
                             {36.46, 31.67, 16.92, 14.92}, {27.07, 23.07, 22.85, 26.94},
                             {24.56, 25.61, 25.07, 24.63}};
  double error = 0;
  for (std::size_t r = 0; r < 7; ++r) {
    double sum = 0, whole = 0, squares = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      sum += model[r].tension[i];
      whole += read[r][i];
    }
    for (std::size_t i = 0; i < 4; ++i) {
      squares += std::pow(model[r].tension[i] / sum - read[r][i] / whole, 2);
    }
    error += 100 * std::sqrt(squares) / 7;
  }
  return error;
}

TEST(CheckOfTheSupplement, FindsItsErrorsInItsLinesAndNotInItsEquations) {
  std::vector<CheckItem> found;
  for (const CheckItem& item : shipped().items) {
    if (item.quantity.kind == CheckedKind::share_error ||
        item.quantity.kind == CheckedKind::share_error_of_equations) {
      found.push_back(item);
    }
  }
  ASSERT_EQ(found.size(), 4U);
  EXPECT_NEAR(found[0].computed, 13.53, 0.005);
  EXPECT_EQ(found[0].status, CheckStatus::agrees);
  EXPECT_NEAR(found[1].computed, share_error_by_hand(0.18, false), 1e-9);
  EXPECT_NEAR(found[1].computed, 16.18, 0.005);
  EXPECT_NEAR(share_error_by_hand(0.18, true), 13.51, 0.005);
  EXPECT_NEAR(found[2].computed, 3.37, 0.005);
  EXPECT_EQ(found[2].status, CheckStatus::agrees);
  EXPECT_NEAR(found[3].computed, share_error_by_hand(0.09, false), 1e-9);
  EXPECT_NEAR(found[3].computed, 6.00, 0.005);
  EXPECT_EQ(found[3].reason,
            "the equations leave 6.0 %; with the losses that the lines of TR4 and TR5 leave out, "
            "3.4 %, and so the 3.4 % are reached with lines that are not those of the equations");
}

// "rms error" taken by the letter, over the 28 shares, gives neither of the printed numbers: of the
// tables 7.6 %, of the lines of Fig. 9 (b) 1.8 %. What docs/diagnosis.md says so holds of the
// readings as printed; the arithmetic is the test's own.
TEST(PrintedShares, AreOffByTheRootMeanSquareThatTheDocumentsState) {
  const MeasuredData readings = testing::the_seven();
  double tables = 0, figure = 0;
  for (const Reading& reading : readings.readings) {
    const CatalogueEntry& entry =
        *shipped_catalogue().find_word(readings.routings[reading.routing].routing);
    double whole = 0;
    for (const auto& tension : reading.tension_N) whole += *tension;
    for (std::size_t i = 0; i < 4; ++i) {
      const double share = 100 * *reading.tension_N[i] / whole;
      tables += std::pow(share - entry.table->share_percent[i].value, 2) / 28;
      figure += std::pow(share - entry.lines.front().share_percent[i].value, 2) / 28;
    }
  }
  EXPECT_NEAR(std::sqrt(tables), 7.6, 0.05);
  EXPECT_NEAR(std::sqrt(figure), 1.8, 0.05);
}

TEST(PublicationCheck, ReportsAWrongNumber) {
  const std::string file = "publications/dual_tendon_routing.toml";
  const CheckReport report = Edited(file, "\"9.21\"", "\"9.28\"").check();
  EXPECT_EQ(report.count(CheckStatus::differs), 1U);
  EXPECT_EQ(item(report, "TR1", balance).status, CheckStatus::differs);
  EXPECT_EQ(Edited(file, "mean = \"7.35\"", "mean = \"7.45\"").check().count(CheckStatus::differs),
            1U);
  EXPECT_EQ(Edited("publications/exo_glove_ii_supplement.toml", "\"3.4\"", "\"4.4\"")
                .check()
                .count(CheckStatus::differs),
            2U);
}

TEST(PublicationCheck, ExplainsNothingWithoutAListedFault) {
  const std::string file = "publications/dual_tendon_routing.toml";
  const CheckReport turned =
      Edited(file, "routing = \"TR5\"\nstrand = 4", "routing = \"TR5\"\nstrand = 1").check();
  EXPECT_EQ(item(turned, "TR5", efficiency).status, CheckStatus::differs);
  EXPECT_EQ(item(turned, "TR5", mean).status, CheckStatus::differs);
  const CheckReport other =
      Edited(file, "routings = [\"TR3\", \"TR6\"]", "routings = [\"TR3\", \"TR7\"]").check();
  EXPECT_EQ(item(other, "TR3", balance).status, CheckStatus::differs);
}

// The balance still is that of TR6's readings, but the row as a whole is closer to its own.
TEST(PublicationCheck, CallsNoRowsExchangedThatFitTheirOwnReadingsBetter) {
  const CheckReport report =
      Edited("publications/dual_tendon_routing.toml", "\"9.96\", \"9.60\"", "\"10.30\", \"9.60\"")
          .check();
  EXPECT_EQ(item(report, "TR3", balance).status, CheckStatus::differs);
}

// It is beyond the readings of both.
TEST(PublicationCheck, CallsNoNumberExchangedThatTheOtherRowDoesNotGive) {
  const CheckReport report =
      Edited("publications/dual_tendon_routing.toml", "\"9.60\"", "\"9.80\"").check();
  EXPECT_EQ(item(report, "TR3", balance).status, CheckStatus::differs);
}

// The mean transmission over trials is that of the mean tensions, however they scatter.
TEST(PublicationCheck, AllowsForScatterOverTrialsOnlyWhereTheMeanIsBelow) {
  const std::string file = "publications/dual_tendon_routing.toml";
  const CheckReport report =
      Edited(file, "\"3.48\"]\ndeviation = [0.033, 0.046, 0.018, 0.037, 0.019]",
             "\"3.00\"]\ndeviation = [0.033, 0.046, 0.018, 0.037, 0.900]")
          .check();
  EXPECT_EQ(item(report, "TR3", {CheckedKind::indicator, 5}).status, CheckStatus::differs);
}

TEST(PublicationCheck, HoldsReadingsAgainstTheirSum) {
  const CheckReport report = Edited("measured/exo_glove_ii.csv", "28.65", "29.65").check();
  EXPECT_EQ(item(report, "TR2", {CheckedKind::tension_sum, 0}).status, CheckStatus::differs);
}

TEST(PublicationCheck, AcceptsACoefficientThatIsTheExponentOrTheRatio) {
  for (const char* printed : {"0.285", "0.752"}) {
    const CheckReport report =
        Edited("publications/dual_tendon_routing.toml", "printed = \"0.651\"",
               std::string("printed = \"") + printed + "\"")
            .check();
    EXPECT_EQ(item(report, "", {CheckedKind::friction_coefficient, 0}).status, CheckStatus::agrees)
        << printed;
  }
}

TEST(PublicationCheck, CallsNoRuleExplainedThatNoClosingMakes) {
  const CheckReport report =
      Edited("publications/dual_tendon_routing.toml", "odd_factor = 1", "odd_factor = 3").check();
  EXPECT_EQ(item(report, "", {CheckedKind::design_count, 3}).status, CheckStatus::differs);
}

TEST(PublicationCheck, RefusesSheathsThatSlideTheOtherWay) {
  EXPECT_EQ(Edited("publications/dual_tendon_routing.toml",
                   "{ strand = 4, slides = \"to motor\" },\n]\n\n[[indicators.row]]\nrouting = "
                   "\"TR6\"",
                   "{ strand = 4, slides = \"to hand\" },\n]\n\n[[indicators.row]]\nrouting = "
                   "\"TR6\"")
                .error(),
            "publications/dual_tendon_routing.toml: indicators.row of TR5: motor_side: no sheath "
            "slides to the hand at strand 4");
}

TEST(PublicationCheck, NamesWhatTheReadingsOrTheCatalogueLack) {
  EXPECT_EQ(Edited("measured/exo_glove_ii.csv", "28.65", "").error(),
            "measured/exo_glove_ii.csv:9: expected a tension above 0 in every strand, which "
            "publications/dual_tendon_routing.toml derives from");
  EXPECT_EQ(
      Edited("measured/exo_glove_ii.csv", "7,TR7,1,pull,24.56,25.61,25.07,24.63\n", "").error(),
      "publications/dual_tendon_routing.toml: its readings, measured/exo_glove_ii.csv, have "
      "no row of TR7 that pulls in the grasp of its published numbers");
  EXPECT_EQ(
      Edited("publications/dual_tendon_routing.toml", "routing = \"TR7\"", "routing = \"TR8\"")
          .error(),
      "publications/dual_tendon_routing.toml: routing = \"TR8\": expected the name of a "
      "routing in the catalogue");
  EXPECT_EQ(
      Edited("publications/dual_tendon_routing.toml", "ratio_from = \"TR1\"",
             "ratio_from = \"TR2\"")
          .error(),
      "publications/dual_tendon_routing.toml:16:14: indicators.ratio_from = \"TR2\": expected "
      "a routing of the table with one motor-side segment");
  EXPECT_EQ(
      Edited("publications/dual_tendon_routing.toml", "slides = \"to motor\"", "slides = \"up\"")
          .error(),
      "publications/dual_tendon_routing.toml:23:38: "
      "indicators.row[1].motor_side[1].slides = \"up\": expected \"to motor\" or \"to hand\"");
}

const std::string article = "publications/dual_tendon_routing.toml";
const std::string supplement = "publications/exo_glove_ii_supplement.toml";

TEST(Publication, NeedsIndicatorsForWhatIsReadWithThemAlone) {
  EXPECT_EQ(Edited(supplement, "read_to_N = 0.15\n",
                   "read_to_N = 0.15\n\n[coefficient]\nsource = \"Sec. I\"\nprinted = \"0.6\"\n\n")
                .error(),
            supplement + ":7:2: a coefficient needs [indicators] beside it, which imply one");
  EXPECT_EQ(Edited(supplement, "read_to_N = 0.15\n", "read_to_N = 0.15\nsum_N = 100\n").error(),
            supplement + ":6:1: sum_N needs [indicators] beside it");
  EXPECT_EQ(Edited(article, "sum_N = 100\n", "").error(),
            article + ":1:1: missing key 'sum_N': expected the sum of a routing's strands");
}

TEST(PublicationCheck, RefusesARatioFromAStrandThatTheRoutingLacks) {
  EXPECT_EQ(Edited(article, "motor_side = [{ strand = 1, slides = \"to motor\" }]",
                   "motor_side = [{ strand = 64, slides = \"to motor\" }]")
                .error(),
            article +
                ": indicators.row of TR1: motor_side: no sheath slides to the motor at "
                "strand 64");
}

// In another grasp, or releasing, a routing's strands have other tensions than the published ones.
TEST(PublicationCheck, TakesTheOneReadingThatPullsInTheGraspOfTheRouting) {
  const std::string file = "measured/exo_glove_ii.csv";
  const std::string row = "1,TR1,1,pull,33.89,28.07,22.91,15.01\n";
  const std::string others = "8,TR1,2,pull,40,30,20,10\n9,TR1,1,release,40,30,20,10\n";
  EXPECT_EQ(Edited(file, row, others + row).check().count(CheckStatus::differs), 0U);
  EXPECT_EQ(Edited(file, row, others).error(),
            article + ": its readings, " + file +
                ", have no row of TR1 that pulls in the grasp of its published numbers");
  EXPECT_EQ(Edited(file, row, row + row).error(),
            file +
                ":9: expected one row of TR1 that pulls in the grasp of its published numbers, "
                "which " +
                article + " derives from");
}

TEST(PublicationCheck, RefusesFaultsOfRoutingsThatAreNotInTheTable) {
  EXPECT_EQ(
      Edited(article, "routing = \"TR5\"\nstrand = 4", "routing = \"TR99\"\nstrand = 4").error(),
      article + ":84:11: indicators.fault[1].routing = \"TR99\": expected a routing of the table");
  EXPECT_EQ(Edited(article, "[\"TR3\", \"TR6\"]", "[\"TR3\", \"TR99\"]").error(),
            article +
                ":89:20: indicators.fault[2].routings[2] = \"TR99\": expected a routing of the "
                "table");
}

TEST(PublicationCheck, ReportsAFaultListedForNumbersThatAgree) {
  const CheckReport report =
      Edited(article, "[coefficient]",
             "[[indicators.fault]]\nkind = \"slides_to_hand\"\nrouting = \"TR1\"\nstrand = 1\n\n"
             "[coefficient]")
          .check();
  EXPECT_EQ(report.count(CheckStatus::differs), 1U);
  const CheckItem& idle = item(report, "", {CheckedKind::idle_fault, 3});
  EXPECT_EQ(idle.status, CheckStatus::differs);
  EXPECT_EQ(idle.source, "Dual-Tendon Routing, Table I");
  EXPECT_NE(idle.reason.find("the listed fault 'slides_to_hand' ("), std::string::npos);
  EXPECT_NE(idle.reason.find(article + ":92:1) explains no number that differs"), std::string::npos)
      << idle.reason;
}

TEST(PublicationCheck, RefusesAnErrorOfLinesThatNobodyDrew) {
  EXPECT_EQ(Edited(supplement, "lines = \"Fig. 9 (b)\"", "lines = \"Fig. 9 (c)\"").error(),
            supplement +
                ":19:9: error.lines = \"Fig. 9 (c)\": expected \"table\", or the source of "
                "[[lines]] in the catalogue");
}

TEST(PublicationCheck, ConcludesNothingFromErrorsThatItCannotExplain) {
  const CheckReport report = Edited(supplement, "printed = \"3.4\"", "printed = \"4.4\"").check();
  const auto found =
      std::find_if(report.items.begin(), report.items.end(), [](const CheckItem& item) {
        return item.quantity.kind == CheckedKind::share_error_of_equations && item.printed == "4.4";
      });
  ASSERT_NE(found, report.items.end());
  EXPECT_EQ(found->status, CheckStatus::differs);
  EXPECT_EQ(found->reason,
            "the equations leave 6.0 %; with the losses that the lines of TR4 and TR5 leave out, "
            "3.4 %");
}

}  // namespace
}  // namespace reeve
