#include "search/uncertainty/margin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/uncertainty/coefficient_box.hpp"
#include "tests/search/uncertain.hpp"

namespace reeve {
namespace {

using testing::parsed;

MarginOptions options(const UncertaintyRanges& ranges) {
  return {Model{}, ranges, single_grasps(2), 500, 2};
}

double lead(const std::string& a, const std::string& b, const Hardware& hardware) {
  DesignEvaluator evaluator(hardware, single_grasps(2));
  return uniformity_times_efficiency(evaluator.evaluate(parse_routing(a))) -
         uniformity_times_efficiency(evaluator.evaluate(parse_routing(b)));
}

// The least lead on a grid over the box, corners included.
double least_on_grid(const std::string& a, const std::string& b, const UncertaintyRanges& ranges) {
  constexpr int steps = 4;
  const CoefficientBox box = coefficient_box(Hardware{}, ranges);
  double least = 1;
  for (int i = 0; i < (steps + 1) * (steps + 1) * (steps + 1) * (steps + 1); ++i) {
    std::vector<double> point;
    for (int rest = i; const Interval& interval : box) {
      point.push_back(interval.low + (interval.high - interval.low) * (rest % (steps + 1)) / steps);
      rest /= steps + 1;
    }
    least = std::min(least, lead(a, b, at_point(Hardware{}, point)));
  }
  return least;
}

TEST(Margin, IsAtMostTheLeastLeadOnAGrid) {
  const std::vector<Routing> routings =
      parsed({"1-P-2-P-1", "F-1-P-2-F", "M-1-T-2-M", "M-1-P-2-F"});
  const std::vector<Margin> found = margins(routings, options({})).value();
  ASSERT_EQ(found.size(), 3U);
  for (const Margin& margin : found) {
    const double grid = least_on_grid("1-P-2-P-1", margin.challenger, {});
    EXPECT_LE(margin.least_lead, grid + 1e-9) << margin.challenger;
    EXPECT_GT(margin.least_lead, grid - 0.02) << margin.challenger;
    EXPECT_NEAR(margin.least_lead, lead("1-P-2-P-1", margin.challenger, margin.at), 1e-9);
    EXPECT_NEAR(margin.nominal_lead, lead("1-P-2-P-1", margin.challenger, Hardware{}), 1e-12);
  }
}

TEST(Margin, FindsWhereTheOrderTurns) {
  // By its mean, TR5 trails TR4 a little at the paper's coefficients; with little friction in the
  // tubes and none to speak of in the sheaths its two motor ends pay off.
  const std::vector<Routing> routings = parsed({"M-1-P-2-F", "M-1-P-2-M"});
  UncertaintyRanges wide;
  wide.tube_mu = {0.0, 0.6};
  wide.sheath_mu = {0.0, 0.6};
  const Margin margin = margins(routings, options(wide)).value().at(0);
  EXPECT_GT(margin.nominal_lead, 0);
  EXPECT_LT(margin.least_lead, 0);
}

// TR3 over TR5 and others, where the least lead lies in a corner that a search of the middle
// misses; nominal coefficients in another corner.
TEST(Margin, IsAtMostTheLeadInAnyCornerAndAtTheNominalCoefficients) {
  UncertaintyRanges wide;
  wide.tube_mu = {0.01, 0.3};
  wide.sheath_mu = {0.01, 0.3};
  for (const double mu : {0.1, 0.01}) {
    MarginOptions asked = options(wide);
    asked.nominal.hardware.tube.mu = asked.nominal.hardware.sheath.mu = mu;
    const std::vector<Routing> routings =
        parsed({"F-1-P-2-F", "M-1-P-2-M", "M-1-P-2-F", "M-1-T-2-F"});
    const std::vector<Margin> found = margins(routings, asked).value();
    for (const Margin& margin : found) {
      EXPECT_LE(margin.least_lead, margin.nominal_lead) << margin.challenger;
      const CoefficientBox box = coefficient_box(asked.nominal.hardware, wide);
      for (unsigned corner = 0; corner < 16; ++corner) {
        std::vector<double> point;
        for (std::size_t i = 0; i < box.size(); ++i) {
          point.push_back((corner >> i & 1U) != 0 ? box[i].high : box[i].low);
        }
        EXPECT_LE(
            margin.least_lead,
            lead("F-1-P-2-F", margin.challenger, at_point(asked.nominal.hardware, point)) + 1e-9)
            << margin.challenger << ' ' << corner;
      }
    }
  }
}

TEST(Margin, IsTheNominalLeadWhereNothingIsUncertain) {
  const UncertaintyRanges none{{0.18, 0.18}, {0.18, 0.18}, 0, 0};
  const Margin margin = margins(parsed({"1-P-2-P-1", "F-1-P-2-F"}), options(none)).value().at(0);
  EXPECT_EQ(margin.least_lead, margin.nominal_lead);
}

// What a block's coefficient is, nominally, it is as uncertain as the bearings'.
TEST(Margin, TakesBlocksOfTheirOwnForBearings) {
  const std::vector<Routing> routings = parsed({"1x-P-2x", "M-Y1+1x-Y1-2x"});
  MarginOptions plain = options({});
  plain.nominal.hardware.bearing.mu = 0.05;
  MarginOptions own = plain;
  own.nominal.hardware.block = plain.nominal.hardware.bearing;
  const Margin expected = margins(routings, plain).value().at(0);
  const Margin found = margins(routings, own).value().at(0);
  EXPECT_EQ(found.nominal_lead, expected.nominal_lead);
  EXPECT_EQ(found.least_lead, expected.least_lead);
}

TEST(MarginThreads, DoNotChangeTheResult) {
  const std::vector<Routing> routings = parsed({"1-P-2-P-1", "F-1-P-2-F", "M-1-T-2-M"});
  MarginOptions one = options({});
  one.threads = 1;
  MarginOptions three = options({});
  three.threads = 3;
  const auto a = margins(routings, one).value();
  const auto b = margins(routings, three).value();
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].least_lead, b[i].least_lead);
}

}  // namespace
}  // namespace reeve
