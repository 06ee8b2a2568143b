#include "diagnosis/search/cause_search.hpp"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <cmath>

#include "causes/library.hpp"
#include "tests/diagnosis/found_causes.hpp"

namespace reeve::testing {
namespace {

TEST(CauseSearch, AcceptsEachCauseThatTheDataHaveAndFitsIt) {
  Bench bench({1, 0.4});
  const CauseSearchResult result = found(bench, Causes{&on_T1, &on_T2, &on_T3});
  ASSERT_EQ(names(result), (Names{"on_T1", "on_T2"}));
  EXPECT_EQ(effect_name(result.accepted[0].effect), "on_T1");
  ASSERT_EQ(result.model.effects.size(), 2U);
  // Means of 30 readings.
  const double sd = bench_noise_N / std::sqrt(30);
  EXPECT_NEAR(result.model.effects[0].values[0], 1, 4 * sd);
  EXPECT_NEAR(result.model.effects[1].values[0], 0.4, 4 * sd);
  EXPECT_GT(result.p_value_of_next, 0.01);
}

// In noise alone: with alpha 1 whatever is best is accepted, with alpha 0 nothing is.
TEST(CauseSearch, AcceptsTheFirstCauseAtAlphaAndFurtherOnesAtTheirOwn) {
  CauseSearchOptions first_only;
  first_only.alpha = 1;
  first_only.further_alpha = 0;
  CauseSearchOptions all = first_only;
  all.further_alpha = 1;
  CauseSearchOptions none;
  none.alpha = 0;
  none.further_alpha = 1;
  std::size_t more_than_one = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto accepted = [&](const CauseSearchOptions& options) {
      Bench bench(Pattern{}, {5, 6, seed});
      return found(bench, Causes{&on_T1, &on_T2, &on_T3}, options).accepted.size();
    };
    EXPECT_EQ(accepted(first_only), 1U) << seed;
    EXPECT_EQ(accepted(none), 0U) << seed;
    more_than_one += accepted(all) > 1 ? 1 : 0;
  }
  EXPECT_GT(more_than_one, 5U);
}

// Of 200 sets of noise alone: as many alarms as alpha says, within three standard deviations.
TEST(CauseSearch, IsAlarmedByNoiseAsOftenAsAlphaSays) {
  constexpr int sets = 200;
  CauseSearchOptions options;
  options.alpha = 0.2;
  options.replicates = 100;
  options.most_causes = 1;
  int alarms = 0;
  for (std::uint64_t seed = 1; seed <= sets; ++seed) {
    Bench bench(Pattern{}, {5, 4, 1000 + seed});
    options.seed = seed;
    alarms += found(bench, Causes{&on_T1, &on_T2, &on_T3}, options).accepted.empty() ? 0 : 1;
  }
  EXPECT_NEAR(alarms, 0.2 * sets, 3 * std::sqrt(0.2 * 0.8 * sets));
}

// To first order an offset of 0.3 N explains everything; but the cause cannot be larger than 2 mN.
TEST(CauseSearch, DoesNotAcceptWhatGainsTooLittleOnceItIsFittedInFull) {
  const PatternCause small("small", {1}, {0, 0.002});
  Bench bench({0.3});
  const CauseSearchResult result = found(bench, Causes{&small});
  EXPECT_TRUE(result.accepted.empty());
  EXPECT_TRUE(result.model.effects.empty());
  EXPECT_LT(result.p_value_of_next, 0.01);
}

// Its first step is a thousandth on T2; on T1 it is its size cubed.
class Late final : public MadeUpCause {
 public:
  Late() : MadeUpCause("late", Reach::reading, {0, 5}) {}

  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    const double x = effect.values[0];
    return tension_N + (segment.number == 1 ? x * x * x : segment.number == 2 ? 1e-3 * x : 0);
  }
};

// Chance is judged by what the screening sees, in the replicates as in the data: a fit that finds
// more than that has no replicates to be compared with.
TEST(CauseSearch, DoesNotAcceptWhatTheScreeningTakesForChance) {
  const Late late;
  std::size_t accepted = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Bench bench({1}, {5, 6, seed});
    const CauseSearchResult result = found(bench, Causes{&late});
    for (const AcceptedCause& cause : result.accepted) EXPECT_LE(cause.p_value, 0.05) << seed;
    accepted += result.accepted.size();
  }
  EXPECT_LE(accepted, 1U);
}

// What M-1-T-2-F with this friction reads more than the hardware says, at 20 N.
Pattern by_friction(double tube, double sheath) {
  const Network network = expand(parse_routing("M-1-T-2-F"));
  Hardware hardware;
  hardware.tube.mu = tube;
  hardware.sheath.mu = sheath;
  const TensionState thought = tensions(network, mechanics(network, {}), Grasp{});
  const TensionState real = tensions(network, mechanics(network, hardware), Grasp{});
  Pattern more;
  for (std::size_t i = 1; i <= 4; ++i) more.push_back(20 * (real.tension[i] - thought.tension[i]));
  return more;
}

Eigen::Vector4d vector_of(const Pattern& pattern) {
  return Eigen::Vector4d(pattern[0], pattern[1], pattern[2], pattern[3]);
}

// The same in the hardware: tubes by its size cubed, and at first a thousandth of what tubes and
// sheaths do where they look least like that.
class LateFriction final : public MadeUpCause {
 public:
  explicit LateFriction(double tube_for_sheath)
      : MadeUpCause("late_friction", Reach::hardware, {0, 1}), tube_for_sheath_(tube_for_sheath) {}

  void change_hardware(Hardware& hardware, const Effect& effect) const override {
    const double x = effect.values[0];
    hardware.sheath.mu += 1e-3 * x;
    hardware.tube.mu += x * x * x - 1e-3 * tube_for_sheath_ * x;
  }

 private:
  double tube_for_sheath_;
};

TEST(CauseSearch, AcceptsACoefficientByItsFitInFull) {
  const Pattern far = by_friction(0.3, 0.18);
  const Eigen::Vector4d seen = vector_of(far);
  const LateFriction late(seen.dot(vector_of(by_friction(0.18, 0.1801))) /
                          seen.dot(vector_of(by_friction(0.1801, 0.18))));
  Bench bench(far);
  const CauseSearchResult result = found(bench, Causes{&late});
  ASSERT_EQ(result.accepted.size(), 1U);
  EXPECT_NEAR(std::pow(result.model.effects[0].values[0], 3), 0.12, 0.01);
}

// Alone, the pattern of all three explains more of 1, 1, 0 N than either offset; beside one of
// them, the other does.
TEST(CauseSearch, GivesAPlaceToWhatExplainsMoreBesideTheOthers) {
  const PatternCause all("all", {1, 1, 1});
  Bench alone({1, 1});
  CauseSearchOptions options;
  options.most_causes = 1;
  EXPECT_EQ(names(found(alone, Causes{&all, &on_T1, &on_T2}, options)), Names{"all"});
  Bench bench({1, 1});
  options.most_causes = 2;
  EXPECT_EQ(names(found(bench, Causes{&all, &on_T1, &on_T2}, options)), (Names{"on_T1", "on_T2"}));
}

// Once the second cause is known, T1 turns out to scatter by 1.5 N: an offset of 0.3 N is nothing.
TEST(CauseSearch, DropsACauseThatNoLongerGainsEnough) {
  Bench bench({0.3, 0.2});
  const auto scatter = [&](Problem& problem, const Model& model) {
    if (model.effects.size() < 2) return;
    for (std::size_t i = 0; i < bench.dataset.cells.size(); ++i) {
      if (bench.dataset.cells[i].channel == 0)
        problem.deviation_N[static_cast<Eigen::Index>(i)] = 1.5;
    }
  };
  const CauseSearchResult result = found(bench, Causes{&on_T1, &on_T2}, {}, scatter);
  EXPECT_EQ(names(result), Names{"on_T2"});
  EXPECT_EQ(result.model.effects.size(), 1U);
}

// x = 2 on_T1 + on_T2 - 0.8 on_T3, so that x + 1.6 on_T3 is (2, 1, 0.8) N, which the three offsets
// explain one after the other, each more than x would.
const PatternCause three_at_once("x", {2, 1, -0.8});

TEST(CauseSearch, PrefersTwoCausesThatExplainWhatThreeDo) {
  Bench bench({2, 1, 0.8});
  const CauseSearchResult result = found(bench, Causes{&on_T1, &on_T2, &on_T3, &three_at_once});
  EXPECT_EQ(names(result), (Names{"on_T3", "x"}));
  EXPECT_EQ(result.model.effects.size(), 2U);
}

TEST(CauseSearch, KeepsThreeCausesWhereNoTwoExplainAsMuch) {
  Bench bench({2, 1.5, 0.8});
  EXPECT_EQ(found(bench, Causes{&on_T1, &on_T2, &on_T3, &three_at_once}).accepted.size(), 3U);
}

TEST(CauseSearch, AcceptsNoMoreCausesThanItMay) {
  Bench bench({2, 1.5, 0.8});
  CauseSearchOptions options;
  options.most_causes = 2;
  EXPECT_EQ(names(found(bench, Causes{&on_T1, &on_T2, &on_T3}, options)),
            (Names{"on_T1", "on_T2"}));
}

TEST(CauseSearch, GivesNothingOnceItIsStopped) {
  Bench bench({1});
  Workers workers(1);
  const auto result = search_causes(bench.problem, {}, {on_T1.candidate()}, {}, {}, workers,
                                    unchanged, [] { return true; });
  EXPECT_FALSE(result.has_value());
}

}  // namespace
}  // namespace reeve::testing
