#include "reports/exploration/explore_report.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/exploration/stored_ranking_report.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

TEST(ExploreDocument, SaysWhatOrdersWithinAFrontWhereItIsTheScore) {
  ExploreReport report;
  report.options.grasps = single_grasps(2);
  EXPECT_FALSE(testing::has(text(explore_document(report)), "the score"));
  report.options.order.by_score = true;
  report.options.score = parse_score("uniformity=2");
  EXPECT_TRUE(testing::has(
      text(explore_document(report)),
      "Sorted by Pareto front (uniformity_mean, efficiency_mean), within a front by the "
      "score, the weighted mean of uniformity_mean=2 (greater is better)\n"));
}

TEST(ExploreDocument, SaysThatSeveralMotorsCountAsOneMachine) {
  ExploreReport report;
  report.options.grasps = single_grasps(2);
  const char* const note = "Note: all motors count as one machine, ";
  EXPECT_FALSE(testing::has(text(explore_document(report)), note));
  report.options.generator.parts.motors = 2;
  EXPECT_TRUE(testing::has(text(explore_document(report)), note));
}

TEST(ExploreDocument, ShowsHowToAskForDesignsOfTheMotorAlone) {
  ExploreReport report;
  report.options.grasps = single_grasps(2);
  report.options.model.hardware.motor.force_N = 60;
  report.options.model.hardware.motor.stroke_mm = 40;
  report.motor = MotorForce{.nominal_N = 50, .p95_N = 90, .draws = 10, .stroke_mm = 30};
  const auto said = [&](const std::string& options) {
    return testing::has(text(explore_document(report)), "Designs for this motor alone:" + options);
  };
  EXPECT_FALSE(said(""));
  report.motor->nominal_N = 70;
  EXPECT_TRUE(said(" --constraint 'motor_force<=60' --constraint 'stroke<=40'\n"));
  report.options.constraints = {parse_constraint("motor_force<=70")};
  EXPECT_FALSE(said(""));
  report.motor->stroke_mm = 41;
  EXPECT_TRUE(said(" --constraint 'stroke<=40'\n"));
}

TEST(ExploreDocument, PutsEachGeneratedRoutingInOneClass) {
  ExploreReport report;
  report.options.grasps = single_grasps(2);
  report.options.constraints = {parse_constraint("sheaths<=2"), parse_constraint("jams<=0")};
  report.result.total = 200;
  report.result.generated = 100;
  report.result.evaluated = 60;
  report.result.rejected = {{std::nullopt, 40}, {0, 20}, {1, 5}};
  report.result.seconds = 0.5;
  EXPECT_EQ(ranked_designs(report), 35U);
  EXPECT_TRUE(testing::has(text(explore_document(report)),
                           "100 of 200 routings generated in 0.50 s: 40 not actuated, 20 fail "
                           "sheaths<=2, 5 fail jams<=0, 35 ranked\n60 evaluated, 120 a second\n"));
  report.result.pruned = 20;
  EXPECT_TRUE(
      testing::has(text(explore_document(report)),
                   "\nOf the 60 that are actuated 20 fail by their parts alone; the other 40 "
                   "evaluated, 80 a second\n"));
  report.result.made_all = true;
  EXPECT_TRUE(testing::has(text(explore_document(report)), "\n60 evaluated, 120 a second\n"));
  EXPECT_EQ(Json::parse(explore_summary_json(report))["designs_per_second"], 120);
}

FingerHardware finger_with(int finger, std::optional<double> FingerHardware::*number,
                           double value) {
  FingerHardware made;
  made.finger = finger;
  made.*number = value;
  return made;
}

FingerHardware jointed(int finger) {
  FingerHardware made;
  made.finger = finger;
  made.parts = {{{10, 90, 50}}, 5.0};
  return made;
}

TEST(ExploreNotes, SayThatFingersDifferWhereTheyDo) {
  ExploreReport report;
  report.options.generator.fingers = 2;
  report.options.grasps = single_grasps(2);
  Hardware& hardware = report.options.model.hardware;
  const auto notes_of = [&](const std::vector<FingerHardware>& fingers) {
    hardware.fingers = fingers;
    return notes(report).size();
  };
  const auto tip_mu = &FingerHardware::tip_mu;
  EXPECT_EQ(notes_of({}), 0U);
  ASSERT_EQ(notes_of({finger_with(5, tip_mu, 0.5)}), 1U);
  EXPECT_EQ(notes(report).front(),
            "[finger.5] of the hardware changes nothing: no routing here has a finger 5");
  EXPECT_EQ(notes_of({finger_with(1, &FingerHardware::closing, 1)}), 0U);
  EXPECT_EQ(notes_of({finger_with(1, &FingerHardware::strand_mm, hardware.strand_mm)}), 0U);
  EXPECT_EQ(notes_of({finger_with(1, tip_mu, 0.5), finger_with(2, tip_mu, 0.5)}), 0U);
  EXPECT_EQ(notes_of({jointed(1), jointed(2)}), 0U);
  EXPECT_EQ(notes_of({finger_with(1, tip_mu, 0.5)}), 1U);
  // As a tube has it; a bearing has less.
  EXPECT_EQ(notes_of({finger_with(2, tip_mu, hardware.tube.mu)}), 1U);
  EXPECT_EQ(notes_of({finger_with(2, &FingerHardware::closing, 2)}), 1U);
  EXPECT_EQ(notes_of({jointed(1)}), 1U);
  hardware.contacts = {{"a", "T1", 0.1, {}}};
  EXPECT_EQ(notes_of({}), 1U);
}

TEST(StoredRankingDocument, HasTheNotesOfItsExploration) {
  StoredRanking ranking;
  ranking.report.options.generator.fingers = 2;
  ranking.report.options.grasps = single_grasps(2);
  const auto tip_mu = &FingerHardware::tip_mu;
  ranking.report.options.model.hardware.fingers = {finger_with(1, tip_mu, 0.5),
                                                   finger_with(7, tip_mu, 0.5)};
  const std::string said = text(stored_ranking_document(ranking, {}));
  EXPECT_TRUE(testing::has(said, "Note: the grasps, the hardware or a law tell the fingers apart"));
  EXPECT_TRUE(testing::has(said, "Note: [finger.7] of the hardware changes nothing"));
  EXPECT_EQ(Json::parse(stored_ranking_json(ranking))["notes"].size(), 2U);
}

TEST(StoredRankingDocument, SaysThatGraspsTellMotorsApart) {
  StoredRanking ranking;
  ExploreOptions& options = ranking.report.options;
  options.generator.fingers = 2;
  options.grasps = parse_grasps("none@1,0.5", 2, 2);
  const char* note = "Note: the grasps tell the motors apart";
  EXPECT_TRUE(testing::has(text(stored_ranking_document(ranking, {})), note));
  options.generator.identity = FingerIdentity::distinct;
  EXPECT_FALSE(testing::has(text(stored_ranking_document(ranking, {})), note));
}

// What statics say of one tendon, and what they do not say of two.
TEST(ExploreDocument, SaysWhichDesignsRestOnHowTheirTendonsShare) {
  ExploreReport report;
  report.options.grasps = single_grasps(2);
  const auto listed = [](const char* word, std::size_t rank) {
    ListedDesign design;
    design.ranked.design.word = word;
    design.ranked.rank = rank;
    return design;
  };
  report.top = {listed("M-1-T-2-F", 1), listed("M-Y1+1x-Y1-2x", 2)};
  EXPECT_FALSE(testing::has(text(explore_document(report)), "on one carriage"));
  report.top.push_back(listed("M-1-F+M-2-F", 3));
  EXPECT_TRUE(testing::has(text(explore_document(report)),
                           "\nRank 3 has several tendons on one carriage: their "
                           "shares of its pull assume equal stiffness and no slack;"));
  report.top.push_back(listed("M-1-M+M-2-F", 4));
  EXPECT_TRUE(testing::has(text(explore_document(report)), "\nRanks 3 and 4 have several tendons"));
}

}  // namespace
}  // namespace reeve
