#include "search/uncertainty/uncertainty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "search/decide/places.hpp"
#include "search/judge/evaluation.hpp"
#include "tests/support/published_words.hpp"

namespace reeve {
namespace {

using testing::published_words;

std::vector<Routing> parsed(const std::vector<std::string>& words) {
  std::vector<Routing> routings;
  for (const std::string& word : words) routings.push_back(parse_routing(word));
  return routings;
}

std::vector<RankDistribution> drawn(const std::vector<std::string>& words,
                                    const UncertaintyOptions& options) {
  return drawn_designs(parsed(words), options).value().ranks;
}

std::vector<Design> evaluated(const std::vector<std::string>& words, const Hardware& hardware,
                              const GraspSet& grasps) {
  DesignEvaluator evaluator(hardware, grasps);
  std::vector<Design> designs;
  for (const std::string& word : words) {
    designs.push_back({word, evaluator.evaluate(parse_routing(word))});
  }
  return designs;
}

UncertaintyOptions options_for(std::size_t draws) {
  UncertaintyOptions options;
  options.grasps = single_grasps(2);
  options.order = {Objective::uniformity_mean, Objective::efficiency_mean};
  options.draws = draws;
  options.threads = 1;
  return options;
}

std::vector<double> drawn(const Hardware& hardware) {
  return {hardware.tube.mu, hardware.sheath.mu, hardware.bearing.mu, hardware.sheath.angle_rad};
}

// Routings whose order depends on the friction, so that ranks vary, the first among them.
const std::vector<std::string>& close_rivals() {
  static const std::vector<std::string> words{"M-1-T-2-F", "M-1-T-2-M",  "M-1-P-2-F",
                                              "M-1-P-2-M", "M-1b-T-2-F", "M-1-B-2b-F"};
  return words;
}

UncertaintyOptions varying(std::size_t draws) {
  UncertaintyOptions options = options_for(draws);
  options.order = {Objective::efficiency_mean};
  options.ranges = {{0, 0.4}, {0, 0.4}, 1, 0.9};
  return options;
}

// The smallest rank that at least `share` percent of the draws do not exceed.
double quantile_by_counting(const std::vector<std::size_t>& ranks, std::size_t percent) {
  for (std::size_t rank = 1;; ++rank) {
    const auto reached =
        std::count_if(ranks.begin(), ranks.end(), [&](std::size_t r) { return r <= rank; });
    if (100 * static_cast<std::size_t>(reached) >= percent * ranks.size()) {
      return static_cast<double>(rank);
    }
  }
}

// ranks[i][d]: of design i in draw d
std::vector<std::vector<std::size_t>> ranks_by_draw(const std::vector<std::string>& words,
                                                    const UncertaintyOptions& options) {
  std::vector<std::vector<std::size_t>> ranks(words.size());
  for (std::uint64_t draw = 0; draw < options.draws; ++draw) {
    const std::vector<RankedDesign> ranked =
        rank(evaluated(words, draw_model(options, draw).hardware, options.grasps), options.order);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto entry = std::find_if(ranked.begin(), ranked.end(), [&](const RankedDesign& r) {
        return r.design.word == words[i];
      });
      ranks[i].push_back(entry->rank);
    }
  }
  return ranks;
}

void expect_equal(const std::vector<RankDistribution>& a, const std::vector<RankDistribution>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].first, b[i].first);
    EXPECT_EQ(a[i].median, b[i].median);
    EXPECT_EQ(a[i].low, b[i].low);
    EXPECT_EQ(a[i].high, b[i].high);
  }
}

TEST(DrawHardware, StaysWithinItsRangesAndFillsThem) {
  UncertaintyOptions options = options_for(1);
  options.nominal.hardware.bearing.mu = 0.002;
  const double angle = options.nominal.hardware.sheath.angle_rad;
  const std::vector<double> low{0.05, 0.05, 0.001, 0.8 * angle};
  const std::vector<double> high{0.20, 0.20, 0.003, 1.2 * angle};
  std::vector<double> least = high;
  std::vector<double> most = low;
  for (std::uint64_t draw = 0; draw < 2000; ++draw) {
    const std::vector<double> quantities = drawn(draw_model(options, draw).hardware);
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      EXPECT_GE(quantities[q], low[q] * (1 - 1e-12));
      EXPECT_LE(quantities[q], high[q] * (1 + 1e-12));
      least[q] = std::min(least[q], quantities[q]);
      most[q] = std::max(most[q], quantities[q]);
    }
  }
  for (std::size_t q = 0; q < low.size(); ++q) {
    EXPECT_LT(least[q], low[q] + 0.01 * (high[q] - low[q])) << q;
    EXPECT_GT(most[q], high[q] - 0.01 * (high[q] - low[q])) << q;
  }
}

TEST(DrawHardware, DrawsTheQuantitiesIndependentlyOfEachOther) {
  const UncertaintyOptions options = options_for(1);
  constexpr int draws = 4000;
  std::vector<int> above(16, 0);
  for (std::uint64_t draw = 0; draw < draws; ++draw) {
    const std::vector<double> quantities = drawn(draw_model(options, draw).hardware);
    const std::vector<double> middle{0.125, 0.125, options.nominal.hardware.bearing.mu,
                                     options.nominal.hardware.sheath.angle_rad};
    std::size_t corner = 0;
    for (std::size_t q = 0; q < 4; ++q) corner = 2 * corner + (quantities[q] > middle[q] ? 1 : 0);
    ++above[corner];
  }
  // 250 in each of the 16 corners, give or take five standard deviations.
  for (const int count : above) EXPECT_NEAR(count, draws / 16, 80);
}

TEST(DrawHardware, IsAFunctionOfSeedAndNumberAlone) {
  const UncertaintyOptions options = options_for(10);
  UncertaintyOptions others = options_for(5000);
  others.threads = 8;
  others.order = {Objective::sheaths};
  others.grasps = paper_grasps();
  for (const std::uint64_t draw : {9U, 3U, 0U, 3U}) {
    EXPECT_EQ(drawn(draw_model(options, draw).hardware), drawn(draw_model(others, draw).hardware));
  }
}

TEST(DrawHardware, OtherSeedsAndNumbersDrawOtherHardware) {
  std::set<double> tubes;
  for (const std::uint64_t seed : {1ULL, 2ULL, 3ULL, 1ULL << 32, (1ULL << 32) + 1}) {
    UncertaintyOptions options = options_for(1);
    options.seed = seed;
    for (const std::uint64_t draw : {0ULL, 1ULL, 2ULL, 1ULL << 32}) {
      tubes.insert(draw_model(options, draw).hardware.tube.mu);
    }
  }
  EXPECT_EQ(tubes.size(), 20U);
}

TEST(DrawHardware, LeavesEverythingElseAsItIs) {
  UncertaintyOptions options = options_for(1);
  options.nominal.hardware.tube.angle_rad = 3;
  options.nominal.hardware.strand_mm = 80;
  options.nominal.hardware.fingers.push_back({1, 0.3, {}, 0.25, 5.0, 90.0, 2});
  options.nominal.hardware.contacts.push_back({"T1", "T2", 0.4, {}});
  const Hardware hardware = draw_model(options, 5).hardware;
  EXPECT_EQ(hardware.tube.angle_rad, 3);
  EXPECT_EQ(hardware.bearing.angle_rad, options.nominal.hardware.bearing.angle_rad);
  EXPECT_EQ(hardware.strand_mm, 80);
  EXPECT_EQ(hardware.motor_side_mm, options.nominal.hardware.motor_side_mm);
  EXPECT_EQ(hardware.hand_mm, options.nominal.hardware.hand_mm);
  ASSERT_EQ(hardware.fingers.size(), 1U);
  EXPECT_EQ(hardware.fingers[0].tip_mu, 0.3);
  EXPECT_EQ(hardware.fingers[0].sheath_mu, 0.25);
  EXPECT_EQ(hardware.fingers[0].sheath_angle_rad, 5.0);
  EXPECT_EQ(hardware.fingers[0].closing, 2);
  ASSERT_EQ(hardware.contacts.size(), 1U);
  EXPECT_EQ(hardware.contacts[0].mu, 0.4);
}

TEST(Uncertainty, AgreesWithCountingRanksDrawByDraw) {
  for (const std::size_t draws : {1U, 2U, 3U, 19U, 20U, 21U, 40U, 100U, 137U}) {
    SCOPED_TRACE(draws);
    const UncertaintyOptions options = varying(draws);
    const auto ranks = ranks_by_draw(close_rivals(), options);
    const auto distributions = drawn(close_rivals(), options);
    ASSERT_EQ(distributions.size(), ranks.size());
    for (std::size_t i = 0; i < ranks.size(); ++i) {
      const auto first = static_cast<double>(std::count(ranks[i].begin(), ranks[i].end(), 1U));
      EXPECT_EQ(distributions[i].first, first / static_cast<double>(draws));
      EXPECT_EQ(distributions[i].median, quantile_by_counting(ranks[i], 50));
      EXPECT_EQ(distributions[i].low, quantile_by_counting(ranks[i], 5));
      EXPECT_EQ(distributions[i].high, quantile_by_counting(ranks[i], 95));
    }
  }
}

TEST(Uncertainty, ShowsThatCloseRivalsChangePlaces) {
  const UncertaintyOptions options = varying(100);
  int sometimes_first = 0;
  double first = 0;
  for (const RankDistribution& d : drawn(close_rivals(), options)) {
    EXPECT_LT(d.low, d.high);
    EXPECT_LE(d.low, d.median);
    EXPECT_LE(d.median, d.high);
    sometimes_first += d.first > 0 && d.first < 1 ? 1 : 0;
    first += d.first;
  }
  EXPECT_GE(sometimes_first, 2);
  EXPECT_NEAR(first, 1, 1e-12);
}

TEST(UncertaintyThreads, DoNotChangeTheDistributions) {
  UncertaintyOptions options = varying(75);
  const auto one = drawn(close_rivals(), options);
  for (const int threads : {2, 3, 8}) {
    SCOPED_TRACE(threads);
    options.threads = threads;
    expect_equal(drawn(close_rivals(), options), one);
  }
}

TEST(Uncertainty, BelongsToItsDesignsInWhateverOrderTheyCome) {
  const UncertaintyOptions options = varying(30);
  std::vector<std::string> words = close_rivals();
  std::vector<RankDistribution> expected = drawn(words, options);
  std::reverse(words.begin(), words.end());
  std::reverse(expected.begin(), expected.end());
  expect_equal(drawn(words, options), expected);
}

TEST(Uncertainty, OtherSeedsGiveOtherDistributions) {
  UncertaintyOptions options = varying(50);
  std::set<std::vector<double>> seen;
  for (options.seed = 1; options.seed <= 5; ++options.seed) {
    std::vector<double> first;
    for (const RankDistribution& d : drawn(close_rivals(), options)) first.push_back(d.first);
    seen.insert(first);
  }
  EXPECT_GT(seen.size(), 1U);
}

TEST(Uncertainty, WithoutWidthIsTheNominalRanking) {
  UncertaintyOptions options = options_for(25);
  options.ranges = {{options.nominal.hardware.tube.mu, options.nominal.hardware.tube.mu},
                    {options.nominal.hardware.sheath.mu, options.nominal.hardware.sheath.mu},
                    0,
                    0};
  const std::vector<Design> designs =
      evaluated(published_words(), options.nominal.hardware, options.grasps);
  const auto distributions = drawn(published_words(), options);
  const std::vector<RankedDesign> ranked = rank(designs, options.order);
  const std::vector<std::size_t> shared = places(ranked, options.order);
  for (std::size_t k = 0; k < ranked.size(); ++k) {
    const RankDistribution& drawn_ranks = distributions[ranked[k].given];
    const auto place = static_cast<double>(shared[k]);
    EXPECT_EQ(drawn_ranks.first, shared[k] == 1 ? 1 : 0);
    EXPECT_EQ(drawn_ranks.median, place);
    EXPECT_EQ(drawn_ranks.low, place);
    EXPECT_EQ(drawn_ranks.high, place);
  }
}

TEST(Uncertainty, Tr7IsFirstInEveryDraw) {
  for (const GraspSet& grasps : {single_grasps(2), paper_grasps()}) {
    UncertaintyOptions options = options_for(300);
    options.grasps = grasps;
    const auto distributions = drawn(published_words(), options);
    EXPECT_EQ(distributions.back().first, 1);
    EXPECT_EQ(distributions.back().high, 1);
    for (std::size_t i = 0; i + 1 < distributions.size(); ++i) {
      EXPECT_EQ(distributions[i].first, 0) << published_words()[i];
    }
  }
}

TEST(Uncertainty, StoppedItIsEmpty) {
  const UncertaintyOptions options = options_for(100);
  const std::atomic<bool> stop{true};
  Supervision supervision;
  supervision.stop = &stop;
  EXPECT_FALSE(drawn_designs(parsed(published_words()), options, supervision).has_value());
}

TEST(Uncertainty, ProgressGrowsToTheNumberOfDraws) {
  std::vector<std::uint64_t> heard;
  Supervision supervision;
  supervision.report = [&](const Progress& progress) {
    EXPECT_EQ(progress.total, 100U);
    heard.push_back(progress.done);
  };
  const UncertaintyOptions options = options_for(100);
  drawn_designs(parsed(published_words()), options, supervision);
  ASSERT_GE(heard.size(), 2U);
  EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
  EXPECT_EQ(heard.back(), 100U);
}

TEST(Uncertainty, WidensTheRangesToHoldWhatTheUserHasInHand) {
  UncertaintyOptions options;
  options.nominal.hardware.tube.mu = 0.30;
  options.nominal.hardware.sheath.mu = 0.02;
  bool above_the_literature = false;
  bool below_the_literature = false;
  for (std::uint64_t draw = 0; draw < 200; ++draw) {
    const Hardware hardware = draw_model(options, draw).hardware;
    EXPECT_LE(hardware.tube.mu, 0.30);
    EXPECT_GE(hardware.sheath.mu, 0.02);
    above_the_literature |= hardware.tube.mu > 0.25;
    below_the_literature |= hardware.sheath.mu < 0.04;
  }
  EXPECT_TRUE(above_the_literature);
  EXPECT_TRUE(below_the_literature);
}

TEST(Uncertainty, RefusesRangesBeyondTheHardwareBeforeDrawing) {
  UncertaintyOptions options;
  options.nominal.hardware.sheath.angle_rad = 50;
  try {
    validate(options, 10);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "at the upper end of the uncertainty's ranges: hardware: sheath: mu * angle = 12: "
              "expected at most 10");
  }
}

TEST(Uncertainty, RefusesMoreRanksThanMemoryShouldHold) {
  UncertaintyOptions options;
  options.draws = 100000;
  EXPECT_NO_THROW(validate(options, 5000));
  EXPECT_THROW(validate(options, 5001), InputError);
  options.draws = 0;
  EXPECT_THROW(validate(options, 1), InputError);
}

}  // namespace
}  // namespace reeve
