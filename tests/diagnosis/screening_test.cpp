
#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/search/cause_screening.hpp"
#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {
namespace {

const PatternCause only_more("only_more", {1}, {0, 20});
const PatternCause only_less("only_less", {1}, {-20, 0});

// Is there or not: reads half a newton more on T1.
class Half final : public Cause {
 public:
  const char* name() const override { return "half"; }
  Reach reach() const override { return Reach::reading; }
  const char* meaning() const override { return ""; }
  std::vector<Parameter> parameters(const Hardware&) const override { return {}; }
  std::vector<Subject> subjects(const Survey&) const override { return std::vector<Subject>(1); }
  double reading(double tension_N, const Segment& segment, const Effect&) const override {
    return tension_N + (segment.number == 1 ? 0.5 : 0);
  }
};
const Half half;
const Effect half_candidate{&half, {}, {}};

// With readings without noise off by this on T1 and by 0.2 N on T2, all in units of 0.05 N.
struct Seen {
  Bench bench;
  Workers workers{1};
  std::vector<Effect> candidates;
  std::vector<ScreenedCause> screened;  // parallel to the candidates

  Seen(double offset_N, std::vector<Effect> among, const Model& model = {})
      : bench({offset_N, 0.2}, {5, 6, 1, 0}), candidates(std::move(among)) {
    const Forecast at = forecast(bench.dataset, model);
    const Projection projection(bench.problem, model, at);
    const CauseScreening screening(bench.dataset, model, at, candidates, workers);
    screened.resize(candidates.size());
    for (const ScreenedCause& cause :
         screening.run(bench.problem, at, projection, residuals(bench.problem, at))) {
      screened[cause.candidate] = cause;
    }
  }

  double gain(std::size_t candidate) const { return screened[candidate].gain; }
};

// 30 readings of each strand: |e|² = 30 (x² + 4²), of which an offset on T1 takes 30 x².
double gain(double x, double taken) {
  const double all = 30 * (x * x + 16);
  return 120.0 / 2 * std::log(all / (all - taken));
}

TEST(Screening, GivesTheGainOfTheFirstOrderAtTheNoiseThatIsSeen) {
  const Seen seen(0.1, {on_T1.candidate(), on_T2.candidate()});
  EXPECT_NEAR(seen.gain(0), gain(2, 30 * 4), 1e-3);
  EXPECT_NEAR(seen.gain(1), gain(2, 30 * 16), 1e-3);
}

TEST(Screening, GivesNoGainToAnImpossibleSize) {
  const Seen more(0.1, {only_more.candidate(), only_less.candidate()});
  EXPECT_GT(more.gain(0), 5);
  EXPECT_EQ(more.gain(1), 0);
  const Seen less(-0.1, {only_more.candidate(), only_less.candidate()});
  EXPECT_EQ(less.gain(0), 0);
  EXPECT_GT(less.gain(1), 5);
}

// d·e − |d|²/2 with d = 10 and e = x: nothing up to x = 5, 30 (100 - 50) at x = 10.
TEST(Screening, TakesACauseWithoutSizeAsAWhole) {
  EXPECT_EQ(Seen(0.2, {half_candidate}).gain(0), 0);
  EXPECT_NEAR(Seen(0.5, {half_candidate}).gain(0), gain(10, 2 * 30 * 50), 1e-3);
  EXPECT_NEAR(Seen(0.3, {half_candidate}).gain(0), gain(6, 2 * 30 * (60 - 50)), 1e-3);
}

TEST(Screening, TakesOutWhatTheModelsParametersExplain) {
  const PatternCause both("both", {1, 1});
  // Beside an offset on T2, "both" is an offset on T1.
  const Seen seen(0.1, {both.candidate()}, on_T2.model(0.2));
  const double all = 30 * 4;
  EXPECT_GT(seen.gain(0), 119.0 / 2 * std::log(all / 1e-6));
}

TEST(Screening, StartsAFitAtTheSizeOfTheFirstOrderWithinTheRange) {
  const PatternCause small("small", {1}, {0, 0.06});
  const Seen seen(0.1, {on_T1.candidate(), small.candidate(), half_candidate});
  const auto starts = [&](std::size_t candidate) { return seen.screened[candidate].starts; };
  ASSERT_EQ(starts(0).size(), 2U);
  EXPECT_NEAR(starts(0)[0][0], 0.1, 1e-6);
  EXPECT_EQ(starts(1)[0][0], 0.06);
  EXPECT_TRUE(starts(2).empty());  // as a whole it gains nothing
}

TEST(GainFromMisfits, IsZeroWithoutImprovement) {
  EXPECT_EQ(gain_from_misfits(10, 10, 5), 0);
  EXPECT_EQ(gain_from_misfits(10, 11, 5), 0);
  EXPECT_EQ(gain_from_misfits(0, 0, 5), 0);
  EXPECT_NEAR(gain_from_misfits(10, 5, 6), 3 * std::log(2), 1e-12);
  EXPECT_TRUE(std::isfinite(gain_from_misfits(10, 0, 6)));
}

}  // namespace
}  // namespace reeve::testing
