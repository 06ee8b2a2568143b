// Contacts of one kind that are not alike: each has an exponent of its own in each draw.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "numerics/robust.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/evaluate/shared_states.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "tests/search/uncertain.hpp"
#include "tests/support/contact_monte_carlo.hpp"

namespace reeve {
namespace {

using testing::ContactDeviations;
using testing::options_for;
using testing::ReferenceHardware;

// Returns options in which no coefficient of a whole kind of part varies.
UncertaintyOptions contacts_alone(std::size_t draws) {
  UncertaintyOptions options = options_for(draws);
  options.ranges = {{0.18, 0.18}, {0.18, 0.18}, 0, 0};
  return options;
}

ReferenceHardware paper_hardware() {
  constexpr double pi = std::numbers::pi;
  return {{0.18, pi}, {0.001, pi}, {0.18, 2 * pi}, 1, 1, 1, {}, {}, {}, {}};
}

Band uniformity_band(const std::string& word, const UncertaintyOptions& options) {
  const DrawnDesigns drawn = drawn_designs({parse_routing(word)}, options).value();
  return *find_band(drawn.bands.front(), Objective::uniformity_mean);
}

TEST(ContactScatter, MakesTheMostUniformRoutingAsUnevenAsAnIndependentModelSays) {
  const Band band = uniformity_band("1-P-2-P-1", contacts_alone(4000));
  EXPECT_NEAR(band.low, 0.86, 0.006);
  EXPECT_NEAR(band.median, 0.92, 0.006);
  EXPECT_NEAR(band.high, 0.97, 0.006);
  const std::vector<double> reference =
      scattered_objectives("1-P-2-P-1", {{}, {1}, {2}}, paper_hardware(), {}, 2000, 5).uniformity;
  EXPECT_NEAR(band.low, quantile_of(reference, 0.05), 0.006);
  EXPECT_NEAR(band.median, quantile_of(reference, 0.5), 0.004);
  EXPECT_NEAR(band.high, quantile_of(reference, 0.95), 0.003);
}

TEST(ContactScatter, OfARoutingWithBlocksIsAsAnIndependentModelSays) {
  const std::string word = "M-Y1+F-1b-Y1-2b-F";
  const Band band = uniformity_band(word, contacts_alone(2000));
  const std::vector<double> reference =
      scattered_objectives(word, {{}, {1}, {2}}, paper_hardware(), {}, 800, 6).uniformity;
  EXPECT_NEAR(band.low, quantile_of(reference, 0.05), 4e-4);
  EXPECT_NEAR(band.median, quantile_of(reference, 0.5), 2e-4);
  EXPECT_NEAR(band.high, quantile_of(reference, 0.95), 3e-4);
}

std::vector<double> exponents(const std::string& word, const Hardware& hardware) {
  return mechanics(expand(parse_routing(word)), hardware).phi;
}

TEST(ContactScatter, LeavesNoTwoContactsAlikeAndEachOfItsOwnDeviation) {
  const std::vector<double> nominal = exponents("1b-P-2-P-1b", Hardware{});
  std::vector<double> sum(nominal.size(), 0);
  std::vector<double> squares(nominal.size(), 0);
  double product = 0;
  constexpr std::size_t draws = 4000;
  for (std::uint64_t d = 0; d < draws; ++d) {
    const std::vector<double> phi =
        exponents("1b-P-2-P-1b", draw_model(contacts_alone(1), d).hardware);
    for (std::size_t k = 0; k < phi.size(); ++k) {
      const double z = phi[k] / nominal[k] - 1;
      sum[k] += z;
      squares[k] += z * z;
    }
    product += (phi[1] / nominal[1] - 1) * (phi[3] / nominal[3] - 1);
  }
  for (std::size_t k = 0; k < nominal.size(); ++k) {
    const double sigma = nominal[k] < 0.01 ? 0.1 : 0.04;
    EXPECT_NEAR(sum[k] / draws, 0, 4 * sigma / std::sqrt(draws)) << k;
    EXPECT_NEAR(std::sqrt(squares[k] / draws), sigma, 4 * sigma / std::sqrt(2.0 * draws)) << k;
  }
  EXPECT_NEAR(product / draws / (0.1 * 0.1), 0, 4 / std::sqrt(draws) * 6.25);
}

TEST(ContactScatter, LeavesWhatTheFileSaysOfOneFingerOrContact) {
  UncertaintyOptions options = contacts_alone(1);
  options.nominal.hardware.fingers.push_back({1, 0.1, {}, 0.15, {}, {}, {}});
  options.nominal.hardware.contacts.push_back({"T4", "b", 0.2, std::nullopt});
  const std::vector<double> nominal = exponents("M-1-T-2-M", options.nominal.hardware);
  const std::vector<double> drawn = exponents("M-1-T-2-M", draw_model(options, 7).hardware);
  // sheath and tip of finger 1, join, tip and sheath of finger 2
  ASSERT_EQ(drawn.size(), 5U);
  EXPECT_EQ(drawn[0], nominal[0]);
  EXPECT_EQ(drawn[1], nominal[1]);
  EXPECT_NE(drawn[2], nominal[2]);
  EXPECT_NE(drawn[3], nominal[3]);
  EXPECT_EQ(drawn[4], nominal[4]);
}

TEST(ContactScatter, ComesOnTopOfWhatAKindHasInCommon) {
  UncertaintyOptions options = options_for(1);
  UncertaintyOptions common = options;
  common.nominal.hardware.scatter = {0, 0};
  EXPECT_EQ(options.nominal.hardware.scatter, (ContactScatter{0.04, 0.1}));
  EXPECT_FALSE(draw_model(common, 3).hardware.contact_draw);
  EXPECT_EQ(draw_model(options, 3).hardware.tube, draw_model(common, 3).hardware.tube);
  const std::vector<double> kind = exponents("M-1-T-2-M", draw_model(common, 3).hardware);
  const std::vector<double> own = exponents("M-1-T-2-M", draw_model(options, 3).hardware);
  for (std::size_t k = 0; k < own.size(); ++k) {
    EXPECT_NE(own[k], kind[k]);
    EXPECT_NEAR(own[k] / kind[k], 1, 0.25);
  }
}

TEST(ContactScatter, KeepsTreesFromBeingSharedAndFingersFromBeingAlike) {
  const Model drawn = draw_model(contacts_alone(1), 1);
  EXPECT_FALSE(routings_share_states(drawn));
  EXPECT_FALSE(treats_fingers_alike(drawn.hardware, 2));
}

TEST(ContactScatter, IsTheSameForAnyNumberOfThreads) {
  UncertaintyOptions options = options_for(50);
  const std::vector<Routing> routings{parse_routing("1-P-2-P-1"), parse_routing("M-1-T-2-M")};
  const DrawnDesigns one = drawn_designs(routings, options).value();
  options.threads = 3;
  const DrawnDesigns three = drawn_designs(routings, options).value();
  for (std::size_t i = 0; i < routings.size(); ++i) {
    for (std::size_t o = 0; o < one.bands[i].size(); ++o) {
      EXPECT_EQ(one.bands[i][o].band.low, three.bands[i][o].band.low);
      EXPECT_EQ(one.bands[i][o].band.high, three.bands[i][o].band.high);
    }
  }
}

}  // namespace
}  // namespace reeve
