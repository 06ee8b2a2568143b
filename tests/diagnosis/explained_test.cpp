// Offsets of known size on the strands of one bench: mean squares can be written down.
#include "diagnosis/verdict/explained.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/verdict/folds.hpp"
#include "tests/diagnosis/pattern_bench.hpp"

namespace reeve::testing {
namespace {

Sample all_in_training(const Bench& bench) {
  Sample part;
  part.training = bench.dataset;
  return part;
}

Effect of_size(const PatternCause& cause, double size) { return {&cause, {}, {size}}; }

Model with(const std::vector<Effect>& effects) {
  Model model;
  for (const Effect& effect : effects) add_effect(model, effect);
  return model;
}

// Four strands: 3 N on one of them and 0.3 N on another are mean squares of 9/4 and 0.09/4 N².
TEST(ExplainedResiduals, AreTheRootOfWhatEachTermTakesOffTheMeanSquare) {
  const Bench bench({3, 0.3}, {5, 6, 1, 0});
  const std::vector<Effect> terms{of_size(on_T2, 0.3), of_size(on_T1, 3)};
  const ExplainedResiduals by =
      explained_residuals(all_in_training(bench), bench.problem, Model{}, with(terms), terms);
  const double all = (9 + 0.09) / 4;
  EXPECT_NEAR(by.before_N, std::sqrt(all), 1e-6);
  EXPECT_NEAR(by.after_N, 0, 1e-6);
  ASSERT_EQ(by.terms.size(), 2U);
  EXPECT_NEAR(by.terms[1].rms_N, 1.5, 1e-6);
  EXPECT_NEAR(by.terms[1].share, 9 / 4.0 / all, 1e-6);
  EXPECT_NEAR(by.terms[0].rms_N, 0.15, 1e-6);
  EXPECT_NEAR(by.terms[0].share, 0.09 / 4 / all, 1e-6);
}

// Two names of nearly one thing: what the first explains the second does not explain again, and the
// order in which they are given says nothing.
TEST(ExplainedResiduals, OfTermsThatOverlapAddUp) {
  const Bench bench({3}, {5, 6, 1, 0});
  const std::vector<Effect> one{of_size(on_T1, 2), of_size(nearly_on_T1, 1)};
  const std::vector<Effect> other{one[1], one[0]};
  const Sample part = all_in_training(bench);
  const ExplainedResiduals by = explained_residuals(part, bench.problem, Model{}, with(one), one);
  const ExplainedResiduals again =
      explained_residuals(part, bench.problem, Model{}, with(one), other);
  EXPECT_EQ(by.terms[0].share, again.terms[1].share);
  EXPECT_EQ(by.terms[1].share, again.terms[0].share);
  const double left = std::pow(by.after_N / by.before_N, 2);
  EXPECT_NEAR(by.terms[0].share + by.terms[1].share, 1 - left, 1e-9);
  EXPECT_NEAR(by.terms[0].share, 1, 1e-6);
}

// 3 N on T1 and 0.3 N on T2, explained by 12 N of a pattern on T1 and a tenth of it on T2, less 9 N
// of another on T1 alone: at these sizes each by itself would leave more than there is.
TEST(ExplainedResiduals, OfTermsThatWorkAgainstEachOtherAreNoMoreThanThereIs) {
  const Bench bench({3, 0.3}, {5, 6, 1, 0});
  const PatternCause both("both", {1, 0.025});
  const std::vector<Effect> terms{of_size(both, 12), of_size(on_T1, -9)};
  const ExplainedResiduals by =
      explained_residuals(all_in_training(bench), bench.problem, Model{}, with(terms), terms);
  EXPECT_NEAR(by.after_N, 0, 1e-6);
  const double all = 9 + 0.09;
  const double along = (3 + 0.3 * 0.025) * (3 + 0.3 * 0.025) / (1 + 0.025 * 0.025);
  EXPECT_NEAR(by.terms[0].share, along / all, 1e-4);
  EXPECT_NEAR(by.terms[1].share, 1 - along / all, 1e-4);
}

// Each by itself is drawn to its own strand, and puts 30 N on a third whose noise hides them; both
// together put none there. Neither explains anything without the other.
TEST(ExplainedResiduals, OfTermsThatExplainOnlyTogetherAreAlike) {
  const Bench bench({3, 3}, {5, 6, 1, 0});
  Problem noisy = bench.problem;
  for (std::size_t i = 0; i < bench.dataset.cells.size(); ++i) {
    if (bench.dataset.cells[i].channel == 2) noisy.deviation_N[static_cast<Eigen::Index>(i)] *= 1e4;
  }
  const PatternCause one("one", {1, 0, 10});
  const PatternCause other("other", {0, 1, -10});
  const std::vector<Effect> terms{of_size(one, 3), of_size(other, 3)};
  const ExplainedResiduals by =
      explained_residuals(all_in_training(bench), noisy, Model{}, with(terms), terms);
  for (const diagnosis::Explained& term : by.terms) {
    EXPECT_NEAR(term.share, 0.5, 1e-6);
    EXPECT_NEAR(term.rms_N, 1.5, 1e-6);
  }
}

// The effect of a run that stands apart is in all residuals, and draws no term towards it.
TEST(ExplainedResiduals, BesideARunApartAreThoseOfTheOthers) {
  const Bench bench({8, 6, 3, 0}, [](std::size_t run) {
    return run == 5 ? Pattern{3, 0.3, 0, 4} : Pattern{3, 0.3};
  });
  Term apart;
  apart.target = Target::offset;
  apart.site.place = SitePlace::channel;
  apart.site.channel = {SegmentKind::strand, 4};
  apart.site.runs = {"r5"};
  const std::vector<Effect> terms{of_size(on_T1, 3), of_size(on_T2, 0.3)};
  const ExplainedResiduals by =
      explained_residuals(all_in_training(bench), bench.problem, Model{}, with(terms), terms,
                          {{&causes::law(apart), {}, {4}}});
  EXPECT_NEAR(by.after_N, std::sqrt(16 / 4.0 / 8), 1e-6);
  EXPECT_NEAR(by.terms[0].rms_N, std::sqrt(9 / 4.0), 1e-6);
  EXPECT_NEAR(by.terms[1].rms_N, std::sqrt(0.09 / 4), 1e-6);
}

TEST(ExplainedResiduals, OfATermThatMakesThemWorseAreBelowZero) {
  const Bench bench({3}, {5, 6, 1, 0});
  const std::vector<Effect> terms{of_size(on_T1, 3), of_size(on_T3, 1)};
  const ExplainedResiduals by =
      explained_residuals(all_in_training(bench), bench.problem, Model{}, with(terms), terms);
  EXPECT_NEAR(by.terms[1].rms_N, -0.5, 1e-6);
  EXPECT_LT(by.terms[1].share, 0);
}

// The term that a fold has found in place of a cause is taken out with it.
TEST(StandIns, OfACauseAreItsAlternatives) {
  AcceptedTerm accepted;
  accepted.effect = of_size(on_T1, 3);
  accepted.alternatives.push_back({of_size(nearly_on_T1, 3), 0.1, {accepted.effect}});
  EXPECT_TRUE(diagnosis::stands_for(of_size(on_T1, 2), accepted));
  EXPECT_TRUE(diagnosis::stands_for(of_size(nearly_on_T1, 1), accepted));
  EXPECT_FALSE(diagnosis::stands_for(of_size(on_T2, 1), accepted));
}

}  // namespace
}  // namespace reeve::testing
