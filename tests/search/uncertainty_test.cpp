#include "search/uncertainty/uncertainty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/rank/equivalent.hpp"
#include "tests/search/uncertain.hpp"
#include "tests/support/published_words.hpp"

namespace reeve {
namespace {

using testing::options_for;
using testing::parsed;
using testing::published_words;

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

// Draw by draw: each design evaluated alone, each constraint compared here.
TEST(DrawnDesigns, MeetAllConstraintsInThisShareOfTheDraws) {
  UncertaintyOptions options = varying(60);
  EXPECT_TRUE(drawn_designs(parsed(close_rivals()), options).value().constraints_met.empty());
  options.constraints = {parse_constraint("efficiency>=0.15"), parse_constraint("uniformity<0.4")};
  const std::vector<double> met =
      drawn_designs(parsed(close_rivals()), options).value().constraints_met;
  ASSERT_EQ(met.size(), close_rivals().size());
  std::vector<double> count(met.size(), 0);
  for (std::uint64_t draw = 0; draw < options.draws; ++draw) {
    const auto designs =
        evaluated(close_rivals(), draw_model(options, draw).hardware, options.grasps);
    for (std::size_t i = 0; i < designs.size(); ++i) {
      const bool efficient = value(designs[i].values, Objective::efficiency_mean) >= 0.15;
      const bool uneven = value(designs[i].values, Objective::uniformity_mean) < 0.4;
      count[i] += efficient && uneven ? 1.0 / 60 : 0;
    }
  }
  std::size_t between = 0;
  for (std::size_t i = 0; i < met.size(); ++i) {
    EXPECT_NEAR(met[i], count[i], 1e-12) << close_rivals()[i];
    if (met[i] > 0 && met[i] < 1) ++between;
  }
  EXPECT_GE(between, 3U);
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
  UncertaintyOptions options = testing::options_of_like_contacts(25);
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
  EXPECT_FALSE(drawn_designs(parsed(published_words()), options, {{}, &stop}).has_value());
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
