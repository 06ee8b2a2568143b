// Bands of objectives: against drawing, evaluating and sorting one after another, and in closed
// form where quantiles of a coefficient become quantiles of an objective.
#include "search/uncertainty/bands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "tests/search/naive_exploration.hpp"
#include "tests/search/uncertain.hpp"

namespace reeve::testing {
namespace {

std::vector<Routing> banded_routings() {
  return parsed(
      {"M-1-T-2-F", "M-1-P-2-M", "1-P-2-P-1", "M-1b-B-2-F", "M-1-F+M-2-F", "M-Y1+1x-Y1-2x"});
}

// Between the two draws about it, in proportion.
double sorted_quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(at));
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

TEST(Bands, AreTheQuantilesOfWhatIsEvaluatedDrawByDraw) {
  for (const std::size_t draws : {1U, 2U, 3U, 20U, 101U}) {
    const UncertaintyOptions options = options_for(draws);
    const std::vector<Bands> bands = drawn_designs(banded_routings(), options).value().bands;
    ASSERT_EQ(bands.size(), banded_routings().size());
    for (std::size_t i = 0; i < bands.size(); ++i) {
      std::vector<ObjectiveValues> drawn;
      for (std::uint64_t d = 0; d < draws; ++d) {
        DesignEvaluator evaluator(draw_model(options, d).hardware, options.grasps);
        drawn.push_back(evaluator.evaluate(banded_routings()[i]));
      }
      EXPECT_EQ(bands[i].size(), 14U);
      for (const ObjectiveBand& entry : bands[i]) {
        std::vector<double> values;
        for (const ObjectiveValues& each : drawn) values.push_back(value(each, entry.objective));
        const std::string about = std::string(row(entry.objective).name);
        EXPECT_NEAR(entry.band.median, sorted_quantile(values, 0.5), 1e-10) << about;
        EXPECT_NEAR(entry.band.low, sorted_quantile(values, 0.05), 1e-10) << about;
        EXPECT_NEAR(entry.band.high, sorted_quantile(values, 0.95), 1e-10) << about;
      }
    }
  }
}

// TR1: T4 / T1 = e^(-3 pi mu_t) in every grasp, which falls with mu_t: the 95 % quantile of one is
// the 5 % quantile of the other. Of 21 draws those are the 2nd, the 11th and the 20th.
TEST(Bands, OfAChainOfTubesAreThoseOfTheCoefficient) {
  const UncertaintyOptions options = testing::options_of_like_contacts(21);
  std::vector<double> mu;
  for (std::uint64_t d = 0; d < 21; ++d) mu.push_back(draw_model(options, d).hardware.tube.mu);
  std::sort(mu.begin(), mu.end());
  const auto uniformity = [](double coefficient) {
    return std::exp(-3 * std::numbers::pi * coefficient);
  };
  const auto drawn = drawn_designs({parse_routing("M-1-T-2-F")}, options).value();
  const Band* band = find_band(drawn.bands.front(), Objective::uniformity_mean);
  ASSERT_NE(band, nullptr);
  EXPECT_NEAR(band->low, uniformity(mu[19]), 2e-10);
  EXPECT_NEAR(band->median, uniformity(mu[10]), 2e-10);
  EXPECT_NEAR(band->high, uniformity(mu[1]), 2e-10);
}

// mu_t is uniform from 0.05 to 0.20. The share of n draws below its 5 % point deviates by
// sqrt(0.05 0.95 / n): four such deviations.
TEST(Bands, ComeToThoseOfTheRangeWithManyDraws) {
  constexpr std::size_t draws = 4000;
  const auto uniformity_at = [](double share) {
    return std::exp(-3 * std::numbers::pi * (0.05 + 0.15 * share));
  };
  const auto drawn = drawn_designs({parse_routing("M-1-T-2-F")}, options_for(draws)).value();
  const Band* band = find_band(drawn.bands.front(), Objective::uniformity_worst);
  const double by = 4 * std::sqrt(0.05 * 0.95 / draws);
  EXPECT_GT(band->low, uniformity_at(0.95 + by));
  EXPECT_LT(band->low, uniformity_at(0.95 - by));
  EXPECT_GT(band->high, uniformity_at(0.05 + by));
  EXPECT_LT(band->high, uniformity_at(0.05 - by));
  const double by_middle = 4 * std::sqrt(0.25 / draws);
  EXPECT_NEAR(band->median, uniformity_at(0.5),
              uniformity_at(0.5 - by_middle) - uniformity_at(0.5));
}

void expect_same_bands(const std::vector<Bands>& a, const std::vector<Bands>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].size(), b[i].size());
    for (std::size_t k = 0; k < a[i].size(); ++k) {
      EXPECT_EQ(a[i][k].objective, b[i][k].objective);
      EXPECT_EQ(a[i][k].band.median, b[i][k].band.median);
      EXPECT_EQ(a[i][k].band.low, b[i][k].band.low);
      EXPECT_EQ(a[i][k].band.high, b[i][k].band.high);
    }
  }
}

TEST(Bands, DependNeitherOnThreadsNorOnTheRoomForThem) {
  UncertaintyOptions options = options_for(40);
  const DrawnDesigns expected = drawn_designs(banded_routings(), options).value();
  for (const std::size_t room :
       {std::size_t{0}, std::size_t{40 * 14 * 2 + 1}, std::size_t{1} << 30}) {
    for (const int threads : {1, 3}) {
      options.values_at_once = room;
      options.threads = threads;
      const DrawnDesigns drawn = drawn_designs(banded_routings(), options).value();
      expect_same_bands(drawn.bands, expected.bands);
      for (std::size_t i = 0; i < drawn.ranks.size(); ++i) {
        EXPECT_EQ(drawn.ranks[i].first, expected.ranks[i].first);
        EXPECT_EQ(drawn.ranks[i].median, expected.ranks[i].median);
      }
    }
  }
}

TEST(Bands, OfADesignAloneAreThoseAmongOthers) {
  const UncertaintyOptions options = options_for(25);
  const auto among = drawn_designs(banded_routings(), options).value().bands;
  for (std::size_t i = 0; i < among.size(); ++i) {
    const auto alone = drawn_bands({banded_routings()[i]}, friction_objectives(false), options,
                                   [&](std::uint64_t draw) { return draw_model(options, draw); });
    expect_same_bands(alone.value(), {among[i]});
  }
}

TEST(Bands, ProgressCountsEveryPassAndAStopEndsThem) {
  UncertaintyOptions options = options_for(100);
  options.values_at_once = 0;
  std::vector<std::uint64_t> heard;
  Supervision supervision;
  supervision.report = [&](const Progress& progress) {
    EXPECT_EQ(progress.total, 600U);
    heard.push_back(progress.done);
  };
  std::atomic<bool> stop{false};
  supervision.stop = &stop;
  EXPECT_TRUE(drawn_designs(banded_routings(), options, supervision).has_value());
  EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
  EXPECT_EQ(heard.back(), 600U);
  // In the second pass.
  supervision.report = [&](const Progress& progress) { stop = progress.done > 100; };
  EXPECT_FALSE(drawn_designs(banded_routings(), options, supervision).has_value());
}

// Of all routings of two fingers, with a block or an anchor too.
TEST(FrictionObjectives, AreThoseThatTheDrawsMove) {
  const UncertaintyOptions options = options_for(3);
  std::vector<bool> moved(objective_count, false);
  for (const Routing& routing : explore(options_for(all_parts(), 2)).routings) {
    std::vector<ObjectiveValues> drawn;
    for (std::uint64_t d = 0; d < options.draws; ++d) {
      DesignEvaluator evaluator(draw_model(options, d), options.grasps);
      drawn.push_back(evaluator.evaluate(routing));
    }
    for (std::size_t k = 0; k < objective_count; ++k) {
      if (drawn[0][k] != drawn[1][k] || drawn[0][k] != drawn[2][k]) moved[k] = true;
    }
  }
  for (const ObjectiveRow& about : objective_table()) {
    // Quantiles over contacts move, and are bands themselves.
    const bool is_quantile =
        about.objective == Objective::uniformity_p5 || about.objective == Objective::efficiency_p5;
    if (about.of_hand || is_quantile) continue;
    EXPECT_EQ(moved[static_cast<std::size_t>(about.objective)],
              depends_on_friction(about.objective))
        << about.name;
  }
  EXPECT_EQ(friction_objectives(true).size(), friction_objectives(false).size() + 4);
}

TEST(BandOf, TakesWhatIsInfiniteForWhatItIs) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Band never = band_of({infinite, infinite, infinite});
  EXPECT_EQ(never.low, infinite);
  EXPECT_EQ(never.high, infinite);
  EXPECT_TRUE(never.is_point());
  const Band sometimes = band_of({1, 2, infinite});
  EXPECT_NEAR(sometimes.low, 1.1, 1e-12);
  EXPECT_EQ(sometimes.median, 2);
  EXPECT_EQ(sometimes.high, infinite);
}

}  // namespace
}  // namespace reeve::testing
