#include <gtest/gtest.h>

#include "studies/catalogue_check.hpp"
#include "tests/studies/checked_publications.hpp"

namespace reeve::testing {
namespace {

const std::string article = "publications/dual_tendon_routing.toml";
const std::string supplement = "publications/exo_glove_ii_supplement.toml";
const std::string measured = "measured/exo_glove_ii.csv";

TEST(PublicationCheck, ReportsAWrongNumber) {
  const CheckReport report = Edited(article, "\"9.21\"", "\"9.28\"").check();
  EXPECT_EQ(report.count(CheckStatus::differs), 1U);
  EXPECT_EQ(item(report, "TR1", balance).status, CheckStatus::differs);
  EXPECT_EQ(
      Edited(article, "mean = \"7.35\"", "mean = \"7.45\"").check().count(CheckStatus::differs),
      1U);
  EXPECT_EQ(Edited(supplement, "\"3.4\"", "\"4.4\"").check().count(CheckStatus::differs), 2U);
}

struct StatusAfterEdit {
  const char* why;
  std::string file, from, to;
  std::string routing;
  CheckedQuantity quantity;
  CheckStatus status = CheckStatus::differs;
};

TEST(PublicationCheck, ExplainsNoMoreThanReadingsAndListedFaultsGive) {
  const std::string slides = "routing = \"TR5\"\nstrand = ", exchanged = "routings = [\"TR3\", ";
  const std::string deviation = "]\ndeviation = [0.033, 0.046, 0.018, 0.037, ";
  const CheckedQuantity transmission{CheckedKind::indicator, 5};
  const CheckedQuantity sum{CheckedKind::tension_sum, 0};
  const CheckedQuantity coefficient{CheckedKind::friction_coefficient, 0};
  const CheckedQuantity designs{CheckedKind::design_count, 3};
  const std::vector<StatusAfterEdit> edits{
      {"the fault is of another strand", article, slides + "4", slides + "1", "TR5", efficiency},
      {"and so the mean differs", article, slides + "4", slides + "1", "TR5", mean},
      {"the fault is of other rows", article, exchanged + "\"TR6\"]", exchanged + "\"TR7\"]", "TR3",
       balance},
      {"the balance still is that of TR6's readings, but the row as a whole is closer to its own",
       article, "\"9.96\", \"9.60\"", "\"10.30\", \"9.60\"", "TR3", balance},
      {"it is beyond the readings of both rows", article, "\"9.60\"", "\"9.80\"", "TR3", balance},
      {"the mean transmission over trials is that of the mean tensions, however they scatter",
       article, "\"3.48\"" + deviation + "0.019]", "\"3.00\"" + deviation + "0.900]", "TR3",
       transmission},
      {"the readings have another sum", measured, "28.65", "29.65", "TR2", sum},
      {"the coefficient is the exponent", article, "printed = \"0.651\"", "printed = \"0.285\"", "",
       coefficient, CheckStatus::agrees},
      {"the coefficient is the ratio", article, "printed = \"0.651\"", "printed = \"0.752\"", "",
       coefficient, CheckStatus::agrees},
      {"no closing makes that rule", article, "odd_factor = 1", "odd_factor = 3", "", designs}};
  for (const StatusAfterEdit& edit : edits) {
    const CheckReport report = Edited(edit.file, edit.from, edit.to).check();
    EXPECT_EQ(item(report, edit.routing, edit.quantity).status, edit.status) << edit.why;
  }
}

struct ErrorAfterEdit {
  std::string file, from, to;
  std::string error;
};

TEST(PublicationCheck, NamesWhatDoesNotFitTogether) {
  const std::string before_tr6 = " },\n]\n\n[[indicators.row]]\nrouting = \"TR6\"";
  const std::string slack = measured + ":9: expected a tension above 0 in every strand, which " +
                            article + " derives from";
  const std::vector<ErrorAfterEdit> edits{
      {article, "slides = \"to motor\"" + before_tr6, "slides = \"to hand\"" + before_tr6,
       article + ": indicators.row of TR5: motor_side: no sheath slides to the hand at strand 4"},
      {article, "motor_side = [{ strand = 1, slides = \"to motor\" }]",
       "motor_side = [{ strand = 64, slides = \"to motor\" }]",
       article + ": indicators.row of TR1: motor_side: no sheath slides to the motor at strand 64"},
      {measured, "28.65", "", slack},
      {measured, "28.65", "0", slack},
      {measured, "28.65", "-1", slack},
      {measured, "7,TR7,1,pull,24.56,25.61,25.07,24.63\n", "",
       article + ": its readings, " + measured +
           ", have no row of TR7 that pulls in the grasp of its published numbers"},
      {article, "routing = \"TR7\"", "routing = \"TR8\"",
       article + ": routing = \"TR8\": expected the name of a routing in the catalogue"},
      {article, "ratio_from = \"TR1\"", "ratio_from = \"TR2\"",
       article +
           ":16:14: indicators.ratio_from = \"TR2\": expected a routing of the table with one "
           "motor-side segment"},
      {article, "slides = \"to motor\"", "slides = \"up\"",
       article +
           ":23:38: indicators.row[1].motor_side[1].slides = \"up\": expected \"to motor\" or "
           "\"to hand\""},
      {supplement, "read_to_N = 0.15\n",
       "read_to_N = 0.15\n\n[coefficient]\nsource = \"Sec. I\"\nprinted = \"0.6\"\n\n",
       supplement + ":7:2: a coefficient needs [indicators] beside it, which imply one"},
      {supplement, "read_to_N = 0.15\n", "read_to_N = 0.15\nsum_N = 100\n",
       supplement + ":6:1: sum_N needs [indicators] beside it"},
      {article, "sum_N = 100\n", "",
       article + ":1:1: missing key 'sum_N': expected the sum of a routing's strands"},
      {article, "routing = \"TR5\"\nstrand = 4", "routing = \"TR99\"\nstrand = 4",
       article + ":84:11: indicators.fault[1].routing = \"TR99\": expected a routing of the table"},
      {article, "[\"TR3\", \"TR6\"]", "[\"TR3\", \"TR99\"]",
       article +
           ":89:20: indicators.fault[2].routings[2] = \"TR99\": expected a routing of the table"},
      {supplement, "lines = \"Fig. 9 (b)\"", "lines = \"Fig. 9 (c)\"",
       supplement + ":19:9: error.lines = \"Fig. 9 (c)\": expected \"table\", or the source of "
                    "[[lines]] in the catalogue"}};
  for (const ErrorAfterEdit& edit : edits) {
    EXPECT_EQ(Edited(edit.file, edit.from, edit.to).error(), edit.error) << edit.to;
  }
}

// In another grasp, or releasing, a routing's strands have other tensions than the published ones.
TEST(PublicationCheck, TakesTheOneReadingThatPullsInTheGraspOfTheRouting) {
  const std::string row = "1,TR1,1,pull,33.89,28.07,22.91,15.01\n";
  const std::string others = "8,TR1,2,pull,40,30,20,10\n9,TR1,1,release,40,30,20,10\n";
  EXPECT_EQ(Edited(measured, row, others + row).check().count(CheckStatus::differs), 0U);
  EXPECT_EQ(Edited(measured, row, others).error(),
            article + ": its readings, " + measured +
                ", have no row of TR1 that pulls in the grasp of its published numbers");
  EXPECT_EQ(Edited(measured, row, row + row).error(),
            measured +
                ":9: expected one row of TR1 that pulls in the grasp of its published numbers, "
                "which " +
                article + " derives from");
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
