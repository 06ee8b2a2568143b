// Scales, ticks and axes: values go to pixels and come back, ticks against cases worked by hand,
// and an axis ends where it should.
#include "drawing/chart/chart_axis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "numerics/random.hpp"

namespace reeve::drawing::chart {
namespace {

std::vector<std::string> texts(const LaidAxis& axis) {
  std::vector<std::string> result;
  for (const Tick& tick : axis.ticks) result.push_back(tick.text);
  return result;
}

LaidAxis lay(const Axis& axis, double low, double high, double length = 400) {
  return lay_numbers(axis, {low, high}, {0, length, {}}, Along::x);
}

using Strings = std::vector<std::string>;

TEST(ChartScale, GivesBackTheValueOfAPlace) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Scale scale;
    scale.low = 100 * normal(seed, 1, 0);
    scale.high = scale.low + std::exp(3 * normal(seed, 1, 1));
    scale.from = 700 * uniform(seed, 1, 2);
    scale.to = 700 * uniform(seed, 1, 3);
    scale.linear_to = seed % 2 == 0 ? 0 : std::exp(normal(seed, 1, 4));
    const double value_in = scale.low + uniform(seed, 1, 5) * (scale.high - scale.low);
    const double hair = 1e-9 * (1 + std::abs(value_in));
    EXPECT_NEAR(value(scale, place(scale, value_in)), value_in, hair) << seed;
    EXPECT_NEAR(place(scale, scale.low), scale.from, 1e-9);
    EXPECT_NEAR(place(scale, scale.high), scale.to, 1e-9);
  }
}

// f(v) = sign(v) ln(1 + |v|/2): f(2) = ln 2, f(6) = 2 ln 2, f(14) = 3 ln 2.
TEST(ChartScale, IsLinearNearZeroAndLogarithmicBeyond) {
  const Scale scale{-14, 14, 0, 600, 2};
  EXPECT_NEAR(place(scale, 0), 300, 1e-9);
  EXPECT_NEAR(place(scale, 2), 400, 1e-9);
  EXPECT_NEAR(place(scale, 6), 500, 1e-9);
  EXPECT_NEAR(place(scale, -6), 100, 1e-9);
}

TEST(ChartAxis, EndsAtATickThatIsNear) {
  const Axis axis;
  const Strings to_nine{"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"};
  EXPECT_EQ(texts(lay(axis, 0.1, 9.4, 480)), to_nine);
  EXPECT_EQ(lay(axis, 0.1, 9.4, 480).scale.high, 9.4);
  EXPECT_EQ(lay(axis, 0.1, 9.6, 480).scale.high, 10);
  EXPECT_EQ(lay(axis, 0.1, 9.6, 480).scale.low, 0);
  EXPECT_EQ(texts(lay(axis, 0, 68, 270)), (Strings{"0", "20", "40", "60"}));
}

TEST(ChartAxis, EndsBeforeWhatIsImpossible) {
  Axis share;
  share.least = 0;
  share.greatest = 1;
  EXPECT_EQ(lay(share, 0.03, 0.998).scale.low, 0);
  EXPECT_EQ(lay(share, 0.03, 0.998).scale.high, 1);
  Axis rank;
  rank.least = 1;
  rank.greatest = 37;
  rank.whole = true;
  const LaidAxis laid = lay(rank, 1, 37);
  EXPECT_EQ(laid.scale.low, 1);
  EXPECT_EQ(laid.scale.high, 37);
  EXPECT_EQ(texts(laid), (Strings{"1", "10", "20", "30", "37"}));
}

TEST(ChartAxis, ReachesEveryValueEvenAnImpossibleOne) {
  Axis share;
  share.greatest = 1;
  EXPECT_EQ(lay(share, 0.5, 1.25).scale.high, 1.25);
}

TEST(ChartAxis, HasNoTwoTextsOverEachOther) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Axis axis;
    axis.linear_to = seed % 3 == 0 ? 2 : 0;
    axis.format = seed % 2 == 0 ? Format::percent : Format::with_sign;
    const double size = std::pow(10, 9 * uniform(seed, 1, 0) - 3);
    const double low = -size * uniform(seed, 1, 1);
    const double length = 40 + 600 * uniform(seed, 1, 2);
    const LaidAxis laid = lay(axis, low, low + size, length);
    double last = -1e9;
    for (const Tick& tick : laid.ticks) {
      if (tick.text.empty()) continue;
      const double half = measures::text_width(tick.text, tick_size, false) / 2;
      EXPECT_GT(tick.at - half, last) << seed;
      EXPECT_GE(tick.at, -1e-6);
      EXPECT_LE(tick.at, length + 1e-6);
      last = tick.at + half;
    }
  }
}

TEST(ChartAxis, GivesEachCategoryTheSameRoom) {
  Axis axis;
  axis.categories = {"a", "b", "c", "d"};
  const LaidAxis laid = lay_categories(axis, {0, 200, {}});
  ASSERT_EQ(laid.ticks.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(laid.ticks[i].at, 25 + 50 * static_cast<double>(i), 1e-9);
    EXPECT_EQ(laid.ticks[i].text, axis.categories[i]);
  }
}

std::vector<std::string> texts(double low, double high, std::size_t most, bool whole = false,
                               Format format = Format::plain) {
  const Ticks ticks = nice_ticks({low, high}, most, whole);
  std::vector<std::string> result;
  for (const double value : ticks.values) result.push_back(tick_text(value, ticks.step, format));
  return result;
}

TEST(NiceTicks, AreMultiplesOfOneTwoOrFive) {
  EXPECT_EQ(texts(0, 1, 6), (Strings{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(texts(0, 1, 5), (Strings{"0.0", "0.5", "1.0"}));
  EXPECT_EQ(texts(0, 1, 11).size(), 11U);
  EXPECT_EQ(texts(0.02, 0.33, 6), (Strings{"0.0", "0.1", "0.2", "0.3", "0.4"}));
  EXPECT_EQ(texts(105, 543, 6), (Strings{"100", "200", "300", "400", "500", "600"}));  // Heckbert's
  EXPECT_EQ(texts(-5200, 26900, 5), (Strings{"−10000", "0", "10000", "20000", "30000"}));
}

TEST(NiceTicks, TakeTheFinestStepThatFits) {
  EXPECT_EQ(texts(0, 10, 6), (Strings{"0", "2", "4", "6", "8", "10"}));
  EXPECT_EQ(texts(0, 10, 7).size(), 6U);
  EXPECT_EQ(texts(0, 10, 11).size(), 11U);
  EXPECT_EQ(texts(0.1, 9.9, 3), (Strings{"0", "5", "10"}));
}

TEST(NiceTicks, OfWholeThingsAreWhole) {
  EXPECT_EQ(texts(3, 4, 9, true), (Strings{"3", "4"}));
  EXPECT_EQ(texts(1, 7, 9, true), (Strings{"1", "2", "3", "4", "5", "6", "7"}));
  EXPECT_EQ(texts(1, 40, 6, true), (Strings{"0", "10", "20", "30", "40"}));
}

TEST(NiceTicks, CoverWhateverTheyAreGiven) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const double size = std::pow(10, 24 * uniform(seed, 1, 0) - 12);
    const double low = size * normal(seed, 1, 1);
    const double high = low + size * std::pow(10, -6 * uniform(seed, 1, 2));
    const std::size_t most = 3 + static_cast<std::size_t>(9 * uniform(seed, 1, 3));
    SCOPED_TRACE(::testing::Message() << low << " to " << high << " by " << most);
    const Ticks ticks = nice_ticks({low, high}, most);
    ASSERT_GE(ticks.values.size(), 2U);
    EXPECT_LE(ticks.values.size(), most);
    const double hair = 1e-6 * ticks.step;
    EXPECT_LE(ticks.values.front(), low + hair);
    EXPECT_GE(ticks.values.back(), high - hair);
    EXPECT_GT(ticks.values.front(), low - ticks.step);
    EXPECT_LT(ticks.values.back(), high + ticks.step);
    EXPECT_TRUE(std::is_sorted(ticks.values.begin(), ticks.values.end()));
  }
}

TEST(NiceTicks, EndWhereNumbersAreTooNearToTellApart) {
  EXPECT_GE(nice_ticks({1e9, std::nextafter(1e9, 2e9)}, 9).values.size(), 2U);
  EXPECT_GE(nice_ticks({-1e100, 1e100}, 9).values.size(), 3U);
  EXPECT_GE(nice_ticks({0, 1e-100}, 9).values.size(), 2U);
}

TEST(BentTicks, AreZeroAndOnesAndThreesOfBothSignsTheMostTellingFirst) {
  EXPECT_EQ(bent_ticks({-40, 20}, 2), (std::vector<double>{0, 10, -10, -30, 3, -3}));
  EXPECT_EQ(bent_ticks({0, 3}, 0.1), (std::vector<double>{0, 1, 0.1, 3, 0.3}));
  EXPECT_EQ(bent_ticks({-1, 1}, 2), (std::vector<double>{0}));
}

TEST(TickText, HasTheDecimalsOfTheStep) {
  EXPECT_EQ(tick_text(0.3, 0.1, Format::plain), "0.3");
  EXPECT_EQ(tick_text(0.25, 0.05, Format::plain), "0.25");
  EXPECT_EQ(tick_text(-0.0, 0.1, Format::plain), "0.0");
  EXPECT_EQ(tick_text(-1e-17, 0.1, Format::plain), "0.0");
  EXPECT_EQ(tick_text(20, 5, Format::plain), "20");
  EXPECT_EQ(tick_text(0.2, 0.1, Format::percent), "20 %");
  EXPECT_EQ(tick_text(0.025, 0.005, Format::percent), "2.5 %");
  EXPECT_EQ(tick_text(30, 10, Format::with_sign), "+30");
  EXPECT_EQ(tick_text(-30, 10, Format::with_sign), "−30");
  EXPECT_EQ(tick_text(0, 10, Format::with_sign), "0");
  EXPECT_EQ(tick_text(2e9, 1e9, Format::plain), "2e+09");
}

}  // namespace
}  // namespace reeve::drawing::chart
