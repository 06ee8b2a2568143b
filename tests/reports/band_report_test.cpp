#include "reports/exploration/band_report.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/exploration/design_list.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/exploration/sweep_report.hpp"
#include "reports/model_text.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

ListedDesign placed(const std::string& word, std::size_t rank, std::size_t place) {
  ListedDesign design;
  design.ranked.design.word = word;
  design.ranked.rank = rank;
  design.ranked.front = 1;
  design.place = place;
  return design;
}

ListedDesign drawn_design(const std::string& word, std::size_t rank, std::size_t place) {
  ListedDesign design = placed(word, rank, place);
  design.distribution = RankDistribution{0.75, 1, 1, 2, 0.25};
  design.bands = {{Objective::uniformity_mean, {0.9854, 0.9612, 0.9931}},
                  {Objective::efficiency_mean, {0.32204, 0.32201, 0.32209}}};
  return design;
}

TEST(BandText, IsTheMedianWithItsBand) {
  EXPECT_EQ(band_text({0.9854, 0.9612, 0.9931}, 3), "0.985 (0.961–0.993)");
  EXPECT_EQ(band_text({-1.2, -3.51, 0.35}, 2), "-1.20 (-3.51 to 0.35)");
  // No wider than the last decimal.
  EXPECT_EQ(band_text({0.32204, 0.32201, 0.32209}, 3), "0.322");
  EXPECT_EQ(band_text({40.2, 38, std::numeric_limits<double>::infinity()}, 1),
            "40.2 (38.0 or more)");
}

TEST(FirstShareText, SaysHowMuchIsShared) {
  EXPECT_EQ(first_share_text({0.75, 1, 1, 2, 0}), "75.0 %");
  EXPECT_EQ(first_share_text({0.75, 1, 1, 2, 0.25}), "75.0 %, 25.0 % shared");
  EXPECT_EQ(first_share_text({1, 1, 1, 1, 1}), "100.0 %, shared");
  EXPECT_EQ(first_share_text({1, 1, 1, 1, 0.9996}), "100.0 %, over 99.9 % shared");
}

TEST(ShareText, DoesNotRoundSomeToNoneOrMostToAll) {
  EXPECT_EQ(share_text(0), "0.0 %");
  EXPECT_EQ(share_text(0.0004), "under 0.1 %");
  EXPECT_EQ(share_text(0.0006), "0.1 %");
  EXPECT_EQ(share_text(0.9994), "99.9 %");
  EXPECT_EQ(share_text(0.9996), "over 99.9 %");
  EXPECT_EQ(share_text(1), "100.0 %");
}

TEST(BandTable, SaysHowOftenAllConstraintsAreMet) {
  ListedDesign design = drawn_design("1-P-2-P-1", 1, 1);
  EXPECT_FALSE(testing::has(text(band_table({design}, {})), "meets all"));
  design.constraints_met = 0.375;
  const std::string table = text(band_table({design}, {}));
  EXPECT_TRUE(testing::has(table, "meets all"));
  EXPECT_TRUE(testing::has(table, "     37.5 %  75.0 %, 25.0 % shared"));
  EXPECT_EQ(to_json(design)["constraints_met"], 0.375);
  EXPECT_TRUE(design_csv({design}).ends_with(",0.32209,0.375\n"));
}

// The first need not be the one that holds in nearly all draws.
TEST(BandSection, SaysHowConstraintsAreEvaluatedAndWhichDesignHoldsInNearlyAllDraws) {
  std::vector<ListedDesign> shown{drawn_design("A", 1, 1), drawn_design("B", 2, 2)};
  const auto lines = [&] {
    const std::string all = text(Document{{band_section(shown, {}, {})}});
    const std::size_t begin = all.find("Meets all: ");
    return begin == std::string::npos ? "" : all.substr(begin);
  };
  EXPECT_EQ(lines(), "");
  const std::string evaluated =
      "Meets all: in how many of the draws a design meets all constraints; which designs are "
      "listed, the nominal coefficients decide\n";
  shown[0].constraints_met = 0.56;
  shown[1].constraints_met = 0.9499;
  EXPECT_EQ(lines(), evaluated +
                         "A meets all of them in 56.0 % of the draws; none of those shown does "
                         "in 95.0 % or more\n");
  shown[1].constraints_met = 0.95;
  EXPECT_EQ(lines(), evaluated +
                         "A meets all of them in 56.0 % of the draws; the first that does in "
                         "95.0 % or more is B, rank 2\n");
  shown[0].constraints_met = 0.96;
  EXPECT_EQ(lines(), evaluated);
}

// Draws of another material than the hardware's say nothing of it.
TEST(RangeNotes, NameACoefficientThatItsRangeLeavesOut) {
  Hardware hardware;
  UncertaintyRanges ranges;
  hardware.tube.mu = ranges.tube_mu.high;
  hardware.sheath.mu = ranges.sheath_mu.low;
  EXPECT_TRUE(range_notes(hardware, ranges).empty());
  hardware.tube.mu = 0.3;
  EXPECT_EQ(
      range_notes(hardware, ranges),
      std::vector<std::string>{
          "the nominal friction coefficient of tubes, 0.3, is outside its range, 0.05 to "
          "0.2, which is widened to hold it: [uncertainty] of the hardware file gives another"});
  hardware.sheath.mu = 0.04;
  EXPECT_EQ(range_notes(hardware, ranges).size(), 2U);
  hardware.tube.known = true;
  EXPECT_EQ(range_notes(hardware, ranges).size(), 1U);
  hardware.tube.known = false;
  ExploreReport report;
  report.options.model.hardware = hardware;
  report.options.grasps = single_grasps(2);
  EXPECT_TRUE(notes(report).empty());
  report.uncertainty = UncertaintyOptions{};
  EXPECT_EQ(notes(report), range_notes(hardware, ranges));
}

TEST(DesignTable, HasBandsWhereTheyAreChosen) {
  ListedDesign design = drawn_design("1-P-2-P-1", 1, 1);
  design.constraints_met = 0.375;
  const ListColumns chosen{{"routing", "uniformity_mean_p5", "rank_p95", "first_shared",
                            "constraints_met", "motor_force_median"}};
  EXPECT_EQ(
      text(design_table({design, placed("B", 2, 2)}, {}, chosen)),
      "routing    uniformity, mean, 5 %  place, 95 %  first, shared  meets all  nominal motor, "
      "median (N)\n"
      "1-P-2-P-1                  0.961            2         25.0 %     37.5 %                  "
      "        -\n"
      "B                              -            -              -          -                  "
      "        -\n");
  const auto names = [](const ListedWith& with) {
    const std::vector<std::string> list = list_column_names(with);
    return std::set<std::string>(list.begin(), list.end());
  };
  EXPECT_FALSE(names({}).contains("uniformity_mean_p5"));
  EXPECT_TRUE(names({.draws = true}).contains("uniformity_mean_p5"));
  EXPECT_FALSE(names({.draws = true}).contains("motor_force_p5"));
  EXPECT_FALSE(names({.draws = true}).contains("constraints_met"));
  EXPECT_TRUE(names({.hand = true, .draws = true, .constraints = true}).contains("motor_force_p5"));
  EXPECT_TRUE(names({.draws = true, .constraints = true}).contains("constraints_met"));
}

TEST(BandTable, HasTheObjectivesThatWereAskedForAndThePlace) {
  const std::string table = text(band_table(
      {drawn_design("1-P-2-P-1", 1, 1)}, {Objective::uniformity_mean, Objective::efficiency_mean}));
  EXPECT_EQ(table,
            "rank  name  routing             uniformity  efficiency                  first  "
            "median place  5–95 %\n"
            "   1  -     1-P-2-P-1  0.985 (0.961–0.993)       0.322  75.0 %, 25.0 % shared  "
            "           1     1–2\n");
}

TEST(BandSection, IsNothingWhereNothingWasDrawn) {
  EXPECT_FALSE(band_section({placed("1-P-2-P-1", 1, 1)}, {}, {}).table.has_value());
  EXPECT_TRUE(band_section({drawn_design("1-P-2-P-1", 1, 1)}, {}, {}).table.has_value());
}

std::string line_of(const std::vector<ListedDesign>& designs) {
  const std::vector<DocumentLine> lines = shared_first_lines(designs);
  return lines.empty() ? "" : lines.front().text;
}

TEST(SharedFirst, NamesWhoIsEqualUnlessBearingsAreAllThatDiffers) {
  EXPECT_EQ(line_of({placed("A", 1, 1), placed("B", 2, 2)}), "");
  EXPECT_EQ(line_of({placed("A", 1, 1), placed("B", 2, 1), placed("C", 3, 3)}),
            "Equal in all ranked objectives: A and B");
  ListedDesign twin = placed("B", 2, 1);
  twin.same_as = "A";
  EXPECT_EQ(line_of({placed("A", 1, 1), twin}), "");
  EXPECT_EQ(line_of({placed("A", 1, 1), twin, placed("C", 3, 1)}),
            "Equal in all ranked objectives: A, B and C");
  std::vector<ListedDesign> many;
  for (std::size_t i = 0; i < 6; ++i)
    many.push_back(placed(std::string(1, char('A' + i)), i + 1, 1));
  EXPECT_EQ(line_of(many), "Equal in all ranked objectives: A, B, C, D and 2 more");
  EXPECT_EQ(line_of({drawn_design("A", 1, 1), drawn_design("B", 2, 1)}),
            "Equal in all ranked objectives: A and B; they share the first place in 25.0 % of the "
            "draws");
}

TEST(DesignCsv, EndsWithPlaceAndBands) {
  ListedDesign without = drawn_design("B", 2, 1);
  without.distribution.reset();
  without.bands.clear();
  const std::string csv = design_csv({drawn_design("A", 1, 1), without});
  EXPECT_TRUE(
      testing::has(csv,
                   ",rank_p95,smallest_jams,same_as,place,first_shared,uniformity_mean_median,"
                   "uniformity_mean_p5,uniformity_mean_p95,efficiency_mean_median,"
                   "efficiency_mean_p5,efficiency_mean_p95\n"));
  EXPECT_TRUE(
      testing::has(csv, ",0.75,1,1,2,,,1,0.25,0.9854,0.9612,0.9931,0.32204,0.32201,0.32209\n"));
  EXPECT_TRUE(csv.ends_with(",,,,,,1,,,,,,,\n"));
}

TEST(BandsJson, IsKeyedByObjectiveAndNullWhereThereIsNoNumber) {
  EXPECT_EQ(
      bands_json({{Objective::motor_force, {40.5, 38, std::numeric_limits<double>::infinity()}}})
          .dump(),
      R"({"motor_force":{"median":40.5,"p5":38.0,"p95":null}})");
  EXPECT_EQ(bands_json({}).dump(), "{}");
}

SweptDesigns two_swept() {
  SweptDesigns swept;
  swept.sweep.over = {Coefficient::sheath_angle, {1, 3}};
  swept.sweep.at = {1, 2, 3};
  swept.designs = {placed("A", 1, 1), placed("B", 2, 2)};
  swept.designs[1].name = "a \"B\"";
  for (const double high : {1.0, 0.5}) {
    swept.sweep.designs.push_back({{Objective::uniformity_mean, {high, high / 2, 0}, {}}});
    swept.sweep.places.push_back({high == 1 ? 1U : 2U, 1, 1});
  }
  swept.sweep.leads = {{1, 1.75, {0}}, {1.75, 3, {0, 1}}};
  return swept;
}

TEST(SweepReport, NamesTheBestDesignOfEachStretch) {
  const std::vector<std::string> sentences = lead_sentences(two_swept());
  ASSERT_EQ(sentences.size(), 2U);
  EXPECT_EQ(sentences[0], "A comes first from 1 to 1.75");
  EXPECT_EQ(sentences[1], "A and a \"B\", which are equal, come first from 1.75 to 3");
}

// Of a narrow range, coefficients and values that differ read so.
TEST(SweepReport, TellsNeighboursApart) {
  SweptDesigns swept = two_swept();
  swept.sweep.leads = {{0.1, 0.100041, {0}}, {0.100041, 0.1001, {1}}};
  swept.sweep.at.clear();
  for (auto& curves : swept.sweep.designs) curves[0].values.clear();
  for (int k = 0; k < 9; ++k) {
    swept.sweep.at.push_back(0.1 + k * 1.25e-5);
    for (auto& curves : swept.sweep.designs) curves[0].values.push_back(0.39 - k * 1e-5);
  }
  EXPECT_EQ(lead_sentences(swept)[0], "A comes first from 0.1 to 0.100041");
  EXPECT_EQ(lead_sentences(swept)[1], "a \"B\" comes first from 0.100041 to 0.1001");
  EXPECT_EQ(text(*sweep_sections(swept)[1].table),
            "sheath_angle (rad)        A    a \"B\"\n"
            "               0.1  0.39000  0.39000\n"
            "           0.10005  0.38996  0.38996\n"
            "            0.1001  0.38992  0.38992\n");
}

TEST(SweepCsv, HasARowForEachDesignAndValueAndBandsWhereTheyAre) {
  SweptDesigns swept = two_swept();
  EXPECT_EQ(sweep_csv(swept),
            "coefficient,at,routing,name,place,uniformity_mean\n"
            "sheath_angle,1,A,,1,1\nsheath_angle,2,A,,1,0.5\nsheath_angle,3,A,,1,0\n"
            "sheath_angle,1,B,\"a \"\"B\"\"\",2,0.5\nsheath_angle,2,B,\"a \"\"B\"\"\",1,0.25\n"
            "sheath_angle,3,B,\"a \"\"B\"\"\",1,0\n");
  for (auto& curves : swept.sweep.designs) curves[0].bands = {{3, 2, 4}, {3, 2, 4}, {3, 2, 4}};
  const std::string csv = sweep_csv(swept, "partial: half");
  EXPECT_TRUE(
      csv.starts_with("# partial: half\ncoefficient,at,routing,name,place,uniformity_mean,"
                      "uniformity_mean_median,uniformity_mean_p5,uniformity_mean_p95\n"
                      "sheath_angle,1,A,,1,1,3,2,4\n"));
}

TEST(SweepReport, IsEmptyWithoutDesigns) {
  const SweptDesigns nothing;
  EXPECT_TRUE(sweep_sections(nothing).empty());
  EXPECT_EQ(sweep_csv(nothing), "coefficient,at,routing,name,place\n");
  EXPECT_TRUE(sweep_json(nothing)["designs"].empty());
}

}  // namespace
}  // namespace reeve
