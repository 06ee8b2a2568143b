#include <gtest/gtest.h>

#include "studies/catalogue_check.hpp"
#include "tests/studies/checked_publications.hpp"

namespace reeve::testing {
namespace {

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
  for (const char* slack : {"", "0", "-1"}) {
    EXPECT_EQ(Edited("measured/exo_glove_ii.csv", "28.65", slack).error(),
              "measured/exo_glove_ii.csv:9: expected a tension above 0 in every strand, which "
              "publications/dual_tendon_routing.toml derives from");
  }
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
}  // namespace reeve::testing
