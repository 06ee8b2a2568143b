#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "causes/library.hpp"
#include "studies/tension_distributions.hpp"
#include "tests/readings/read_data.hpp"
#include "tests/studies/shipped_catalogue.hpp"

namespace reeve {
namespace {

using testing::read_data;
using testing::shipped_catalogue;
using testing::the_seven;

DiagnosisResult with_friction(double tube, double sheath) {
  DiagnosisResult result;
  add_effect(result.model, {find_cause("tube_friction"), {}, {tube}});
  add_effect(result.model, {find_cause("sheath_friction"), {}, {sheath}});
  return result;
}

std::vector<PublishedModel> published_with(std::vector<double> coefficients) {
  std::vector<PublishedModel> models;
  for (const double mu : coefficients) models.push_back({"", mu, {}, 0, 0, {}});
  return models;
}

const RoutingShares& of(const TensionDistribution& distribution, const std::string& name) {
  for (const RoutingShares& shares : distribution.routings) {
    if (shares.name == name) return shares;
  }
  throw std::runtime_error(name);
}

// What the readings, Tables I to VII and the lines of Fig. 9 (b) say of each other, worked out
// from them by hand.
TEST(DiagnosedDistributions, AreThePublishedCasesAndThatOfTheDiagnosis) {
  const auto all = diagnosed_distributions(the_seven(), {}, with_friction(0.05, 0.045),
                                           published_with({0.18, 0.09}), shipped_catalogue());
  ASSERT_TRUE(all);
  ASSERT_EQ(all->list.size(), 3U);
  EXPECT_EQ(all->list[0].kind, FrictionKind::coefficient);
  EXPECT_EQ(all->list[2].kind, FrictionKind::diagnosed);
  EXPECT_EQ(all->list[2].tube_mu, 0.05);
  EXPECT_EQ(all->list[2].sheath_mu, 0.045);
  const double model[] = {0.162, 0.060, 0.014};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(*all->list[i].share_errors.model, model[i], 0.001) << i;
  }
  EXPECT_NEAR(*all->list[0].share_errors.published, 0.135, 0.001);
  EXPECT_NEAR(*all->list[1].share_errors.published, 0.034, 0.001);
  EXPECT_FALSE(all->list[2].share_errors.published);
}

TEST(DiagnosedDistributions, HaveTheModelsClosedFormAndTheReadingsShares) {
  const auto all = diagnosed_distributions(the_seven(), {}, with_friction(0.05, 0.045),
                                           published_with({0.18, 0.09}), shipped_catalogue());
  const RoutingShares& tr4 = of(all->list[2], "TR4");
  EXPECT_NEAR(tr4.strands[2].model / tr4.strands[1].model,
              std::exp(-(2 * 0.045 * 2 + 0.001) * std::numbers::pi), 1e-9);
  EXPECT_NEAR(tr4.strands[1].model / tr4.strands[0].model, std::exp(-0.05 * std::numbers::pi),
              1e-9);
  const double read[] = {36.11, 30.84, 18.35, 14.54};  // 99.84 N together
  for (const TensionDistribution& distribution : all->list) {
    const auto& strands = of(distribution, "TR4").strands;
    ASSERT_EQ(strands.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(strands[i].measured->mean, read[i] / 99.84, 1e-12) << i;
    }
  }
}

TEST(DiagnosedDistributions, BeginWithTheModelAsItStandsWhereItIsNotPublished) {
  const MeasuredData data =
      read_data("run,routing,held,T1_N,T2_N,T3_N,T4_N\n1,M-1-T-2-M,none,4,3,2,1\n");
  const auto plain = diagnosed_distributions(data, {}, {}, {}, shipped_catalogue());
  ASSERT_TRUE(plain);
  ASSERT_EQ(plain->list.size(), 1U);
  EXPECT_EQ(plain->list[0].kind, FrictionKind::model);
  EXPECT_EQ(plain->list[0].grasp, Grasp{});
  const auto both =
      diagnosed_distributions(data, {}, with_friction(0.05, 0.045), {}, shipped_catalogue());
  ASSERT_EQ(both->list.size(), 2U);
  EXPECT_EQ(both->list[1].kind, FrictionKind::diagnosed);
}

TEST(DiagnosedDistributions, NameWhatElseIsDiagnosed) {
  DiagnosisResult result = with_friction(0.05, 0.045);
  add_effect(result.model, {find_cause("pretension"), {}, {2}});
  const auto all = diagnosed_distributions(the_seven(), {}, result, {}, shipped_catalogue());
  ASSERT_TRUE(all);
  EXPECT_TRUE(all->list[0].other_effects.empty());
  EXPECT_EQ(all->list[1].other_effects, std::vector<std::string>{"pretension"});
}

TEST(DiagnosedDistributions, SayWhetherASensorReadsOtherwise) {
  DiagnosisResult result = with_friction(0.05, 0.045);
  const auto plain = diagnosed_distributions(the_seven(), {}, result, {}, shipped_catalogue());
  EXPECT_FALSE(plain->list[1].sensors_differ);
  Subject sensor;
  sensor.channel = parse_segment("T1");
  add_effect(result.model, {find_cause("sensor_gain"), sensor, {1.1}});
  const auto all = diagnosed_distributions(the_seven(), {}, result, {}, shipped_catalogue());
  EXPECT_FALSE(all->list[0].sensors_differ);
  EXPECT_TRUE(all->list[1].sensors_differ);
}

TEST(DiagnosedDistributions, AreNoneWhereNoReadingHasAllStrands) {
  const MeasuredData data =
      read_data("run,routing,held,T1_N,T2_N\n1,M-1-T-2-M,none,4,3\n1,TR5,none,4,3\n");
  EXPECT_FALSE(
      diagnosed_distributions(data, {}, with_friction(0.05, 0.045), {}, shipped_catalogue()));
}

TEST(DiagnosedDistributions, KeepToTheNumberOfFingersOfTheFirst) {
  const MeasuredData data = read_data(
      "run,routing,held,T1_N,T2_N,T3_N,T4_N,T5_N,T6_N\n"
      "1,M-1-T-2-M,none,4,3,2,1,,\n1,M-1-P-2-P-3-M,none,4,3,2,1,1,1\n");
  const auto all = diagnosed_distributions(data, {}, {}, {}, shipped_catalogue());
  ASSERT_TRUE(all);
  ASSERT_EQ(all->list.front().routings.size(), 1U);
  EXPECT_EQ(all->list.front().routings.front().word, "M-1-T-2-M");
  EXPECT_TRUE(std::any_of(all->data->notes.begin(), all->data->notes.end(), [](const auto& note) {
    return note.text.find("M-1-P-2-P-3-M") != std::string::npos;
  }));
}

TEST(DiagnosedDistributions, HaveACoefficientOnceHoweverOftenItIsPublished) {
  const auto all = diagnosed_distributions(the_seven(), {}, {}, published_with({0.18, 0.18, 0.09}),
                                           shipped_catalogue());
  ASSERT_TRUE(all);
  ASSERT_EQ(all->list.size(), 2U);
  EXPECT_EQ(all->list[0].tube_mu, 0.18);
  EXPECT_EQ(all->list[1].tube_mu, 0.09);
}

TEST(DiagnosedDistributions, ShowTheTableWhereAFigureHasTheSameCoefficient) {
  Catalogue catalogue = shipped_catalogue();
  for (CatalogueEntry& entry : catalogue.entries) {
    for (PublishedLines& lines : entry.lines) lines.mu = 0.18;
  }
  const auto all = diagnosed_distributions(the_seven(), {}, {}, published_with({0.18}), catalogue);
  ASSERT_TRUE(all);
  const RoutingShares& tr4 = of(all->list[0], "TR4");
  EXPECT_EQ(tr4.published_source, "Table IV");
  EXPECT_EQ(tr4.strands[0].published->share, 0.54);
}

TEST(TensionDistributions, HaveTheStrandsThatTheRoutingHas) {
  const std::vector<Routing> routings{parse_routing("M-1b-B-2b-B-3x"), parse_routing("M-1x+M-2x")};
  const TensionDistributions all =
      tension_distributions({routings, {{FrictionKind::model, {}}}, {}}, shipped_catalogue());
  const auto names = [&](std::size_t routing) {
    std::string text;
    for (const StrandShare& strand : all.list[0].routings[routing].strands) text += strand.strand;
    return text;
  };
  EXPECT_EQ(names(0), "T1T2T3T4T5");
  EXPECT_EQ(names(1), "T1T3");
}

}  // namespace
}  // namespace reeve
