// Quantiles where no two contacts are alike, to first order, against every draw solved in full.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "numerics/robust.hpp"
#include "search/enumerate/generator.hpp"
#include "search/evaluate/evaluation.hpp"
#include "tests/search/generated.hpp"

namespace reeve {
namespace {

struct Quantiles {
  double uniformity = 0;
  double efficiency = 0;
};

Quantiles in_full(const Routing& routing, Model model, const GraspSet& grasps) {
  std::vector<double> uniformity;
  std::vector<double> efficiency;
  const EvaluationScope means{false, false, false, false, false};
  for (std::uint64_t d = 0; d < ContactQuantileFinder::draws; ++d) {
    model.hardware.contact_draw = ContactDraw{ContactQuantileFinder::seed, d};
    const ObjectiveValues values = DesignEvaluator(model, grasps).evaluate(routing, means);
    uniformity.push_back(value(values, Objective::uniformity_mean));
    efficiency.push_back(value(values, Objective::efficiency_mean));
  }
  return {quantile_of(uniformity, 0.05), quantile_of(efficiency, 0.05)};
}

Quantiles to_first_order(const Routing& routing, const Model& model, const GraspSet& grasps) {
  const ObjectiveValues values = DesignEvaluator(model, grasps).evaluate(routing);
  return {value(values, Objective::uniformity_p5), value(values, Objective::efficiency_p5)};
}

struct Errors {
  double greatest = 0;
  double mean = 0;
};

template <typename Get>
Errors errors(const std::vector<Routing>& routings, const GraspSet& grasps, Get get) {
  Errors errors;
  for (const Routing& routing : routings) {
    const double error =
        std::abs(get(in_full(routing, {}, grasps)) - get(to_first_order(routing, {}, grasps)));
    errors.greatest = std::max(errors.greatest, error);
    errors.mean += error / static_cast<double>(routings.size());
  }
  return errors;
}

const std::vector<std::string> scattered_words{
    "M-1-T-2-F",     "M-1-T-2-M",         "F-1-P-2-F",   "M-1-P-2-F",
    "M-1-P-2-M",     "1-T-2-P-1",         "1-P-2-P-1",   "1x-P-2x",
    "M-Y1+1x-Y1-2x", "M-Y1+F-1b-Y1-2b-F", "M-1-F+M-2-F", "M-Y1+F-1-Y1-2-F"};

TEST(ContactQuantiles, OfKnownRoutingsAreThoseOfEveryDrawSolved) {
  const auto routings = testing::parsed(scattered_words);
  const GraspSet grasps = single_grasps(2);
  const Errors uniformity =
      errors(routings, grasps, [](const Quantiles& q) { return q.uniformity; });
  const Errors efficiency =
      errors(routings, grasps, [](const Quantiles& q) { return q.efficiency; });
  EXPECT_LT(uniformity.mean, 0.002);
  EXPECT_LT(uniformity.greatest, 0.01);
  EXPECT_LT(efficiency.mean, 0.0005);
  EXPECT_LT(efficiency.greatest, 0.002);
}

TEST(ContactQuantiles, OfTheMostUniformRoutingAreFarBelowItsNominalUniformity) {
  const Quantiles tr7 = to_first_order(parse_routing("1-P-2-P-1"), {}, single_grasps(2));
  EXPECT_NEAR(tr7.uniformity, 0.86, 0.012);
}

TEST(ContactQuantiles, AreTheNominalValuesWhereContactsAreAlike) {
  Model alike;
  alike.hardware.scatter = {0, 0};
  for (const std::string& word : scattered_words) {
    const ObjectiveValues values =
        DesignEvaluator(alike, single_grasps(2)).evaluate(parse_routing(word));
    EXPECT_NEAR(value(values, Objective::uniformity_p5), value(values, Objective::uniformity_mean),
                1e-9);
    EXPECT_NEAR(value(values, Objective::efficiency_p5), value(values, Objective::efficiency_mean),
                1e-9);
  }
}

TEST(ContactQuantiles, LeaveWhatTheRestOfTheEvaluationSees) {
  const Routing routing = parse_routing("M-1-T-2-F");
  ObjectiveValues with = DesignEvaluator(Hardware{}, single_grasps(2)).evaluate(routing);
  EvaluationScope scope;
  scope.contacts = false;
  const ObjectiveValues without =
      DesignEvaluator(Hardware{}, single_grasps(2)).evaluate(routing, scope);
  value(with, Objective::uniformity_p5) = value(with, Objective::efficiency_p5) = 0;
  EXPECT_EQ(with, without);
}

TEST(ContactQuantiles, OfContactsThatDifferMoreStayNearThoseOfEveryDrawSolved) {
  const Routing routing = parse_routing("M-1-P-2-M");
  Model model;
  model.hardware.tube.mu = 0.1;
  model.hardware.scatter = {0.08, 0.1};
  const Quantiles full = in_full(routing, model, paper_grasps());
  const Quantiles first = to_first_order(routing, model, paper_grasps());
  EXPECT_NEAR(first.uniformity, full.uniformity, 0.003);
  EXPECT_NEAR(first.efficiency, full.efficiency, 0.001);
}

}  // namespace
}  // namespace reeve
