// Bands and first places of all two-finger designs, against 200 draws that nothing of the library
// has a part in: kinds and contacts drawn by the test, tensions by the reference model.
#include "tests/support/contact_monte_carlo.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/notation.hpp"
#include "search/enumerate/generator.hpp"
#include "search/uncertainty/uncertainty.hpp"
#include "tests/search/uncertain.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve {
namespace {

using testing::KindRanges;
using testing::ScatteredObjectives;

constexpr std::size_t reference_draws = 200;
constexpr std::size_t drawn_by_library = 10000;

struct BothAnswers {
  std::vector<std::string> words;
  DrawnDesigns drawn;
  std::vector<ScatteredObjectives> reference;
};

BothAnswers both_answers(const UncertaintyRanges& ranges, const std::optional<KindRanges>& kinds) {
  UncertaintyOptions options = testing::options_for(drawn_by_library);
  options.ranges = ranges;
  BothAnswers both;
  testing::for_each_generated(testing::generating(full_parts(), 2, testing::identical),
                              [&](const Routing& routing) {
                                if (is_actuated(routing)) both.words.push_back(to_word(routing));
                              });
  both.drawn = drawn_designs(testing::parsed(both.words), options).value();
  constexpr double pi = std::numbers::pi;
  const testing::ReferenceHardware hardware{
      {0.18, pi}, {0.001, pi}, {0.18, 2 * pi}, 1, 1, 1, {}, {}, {}, {}};
  for (const std::string& word : both.words) {
    both.reference.push_back(testing::scattered_objectives(word, {{}, {1}, {2}}, hardware, {},
                                                           reference_draws, 33, kinds));
  }
  return both;
}

// Returns by how many standard deviations of a binomial law a number of successes is off.
double deviations_off(std::size_t successes, double probability) {
  const double mean = probability * reference_draws;
  return std::abs(static_cast<double>(successes) - mean) /
         std::sqrt(std::max(mean * (1 - probability), 1.0));
}

// The share of the draws below a quantile of the library is the quantile's, for any distribution.
void expect_quantile(const std::vector<double>& draws, double quantile, double share) {
  const auto below = static_cast<std::size_t>(
      std::count_if(draws.begin(), draws.end(), [&](double x) { return x < quantile; }));
  EXPECT_LT(deviations_off(below, share), 4) << below << " of 200 below " << quantile;
}

void expect_quantiles(const BothAnswers& both) {
  ASSERT_EQ(both.words.size(), 54U);
  for (std::size_t i = 0; i < both.words.size(); ++i) {
    SCOPED_TRACE(both.words[i]);
    const Band uniformity = *find_band(both.drawn.bands[i], Objective::uniformity_mean);
    const Band efficiency = *find_band(both.drawn.bands[i], Objective::efficiency_mean);
    expect_quantile(both.reference[i].uniformity, uniformity.low, 0.05);
    expect_quantile(both.reference[i].uniformity, uniformity.median, 0.5);
    expect_quantile(both.reference[i].efficiency, efficiency.low, 0.05);
    expect_quantile(both.reference[i].efficiency, efficiency.median, 0.5);
  }
}

// Returns in how many draws each design has the greatest product of both objectives. No design can
// then be better in both, so it is first. Equal designs are all first.
std::vector<std::size_t> first_places(const std::vector<ScatteredObjectives>& designs) {
  std::vector<std::size_t> firsts(designs.size(), 0);
  for (std::size_t d = 0; d < reference_draws; ++d) {
    const auto product = [&](std::size_t i) {
      return designs[i].uniformity[d] * designs[i].efficiency[d];
    };
    double greatest = 0;
    for (std::size_t i = 0; i < designs.size(); ++i) greatest = std::max(greatest, product(i));
    for (std::size_t i = 0; i < designs.size(); ++i) {
      if (product(i) > greatest - 1e-9) ++firsts[i];
    }
  }
  return firsts;
}

void expect_first_places(const BothAnswers& both) {
  const std::vector<std::size_t> firsts = first_places(both.reference);
  for (std::size_t i = 0; i < both.words.size(); ++i) {
    EXPECT_LT(deviations_off(firsts[i], both.drawn.ranks[i].first), 4)
        << both.words[i] << ": first in " << firsts[i] << " of 200, by the library in the share "
        << both.drawn.ranks[i].first;
  }
}

TEST(ContactMonteCarlo, HasTheBandsAndFirstPlacesOfAllTwoFingerDesignsWhereContactsAloneVary) {
  const BothAnswers both = both_answers({{0.18, 0.18}, {0.18, 0.18}, 0, 0}, std::nullopt);
  expect_quantiles(both);
  expect_first_places(both);
}

TEST(ContactMonteCarlo, HasTheBandsAndFirstPlacesOfAllTwoFingerDesignsWhereKindsVaryToo) {
  SKIP_UNDER_SANITIZERS();
  const BothAnswers both = both_answers({}, KindRanges{});
  expect_quantiles(both);
  expect_first_places(both);
}

}  // namespace
}  // namespace reeve
