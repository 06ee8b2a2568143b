#include "studies/tension_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "core/mechanics.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

// More samples than a worker takes at a time.
constexpr std::size_t samples = 1000;

std::vector<double> tube_coefficients() {
  std::vector<double> values(samples);
  for (std::size_t sample = 0; sample < samples; ++sample) {
    values[sample] = 0.05 + 0.0001 * static_cast<double>(sample);
  }
  return values;
}

// Solves one sample after the other.
std::vector<double> solved_one_by_one(const std::vector<Routing>& routings,
                                      const std::vector<double>& mu) {
  std::vector<double> table;
  for (const Routing& routing : routings) {
    const Network network = expand(routing);
    for (const double coefficient : mu) {
      Hardware hardware;
      hardware.tube.mu = coefficient;
      const TensionState state = tensions(network, mechanics(network, hardware), hold({1}));
      for (const Segment& segment : table_segments(routings)) {
        for (std::size_t at = 0; at < network.segments.size(); ++at) {
          if (network.segments[at] == segment) table.push_back(state.tension[at]);
        }
      }
    }
  }
  return table;
}

TEST(TensionTableThreads, FillItAsOneSolveAfterTheOther) {
  const std::vector<Routing> routings{parse_routing("M-1-P-2-M"), parse_routing("M-1-P-2b-M")};
  const std::vector<double> mu = tube_coefficients();
  const std::vector<double> expected = solved_one_by_one(routings, mu);
  for (const int threads : {1, 3}) {
    TensionTableRequest request;
    request.routings = routings;
    request.grasps = {hold({1})};
    request.columns = {{"tube_mu", ContactKind::tube, LawTerm::mu, mu}};
    request.samples = samples;
    request.threads = threads;
    std::vector<double> table(table_size(request));
    ASSERT_TRUE(fill_tension_table(request, table));
    EXPECT_EQ(table, expected) << threads << " threads";
  }
}

std::vector<double> filled(const std::vector<std::string>& words) {
  TensionTableRequest request;
  for (const std::string& word : words) request.routings.push_back(parse_routing(word));
  request.grasps = {hold({1})};
  request.samples = 1;
  std::vector<double> table(table_size(request));
  EXPECT_TRUE(fill_tension_table(request, table));
  return table;
}

// The first routing has all segments of the table, the second has no T3, T4 and others.
TEST(TensionTable, HasNoNumberWhereARoutingHasNoSuchSegment) {
  const std::vector<double> table = filled({"M-1-T-2-M", "M-1-M"});
  const std::vector<Segment> segments =
      table_segments({parse_routing("M-1-T-2-M"), parse_routing("M-1-M")});
  const Network small = expand(parse_routing("M-1-M"));
  ASSERT_EQ(table.size(), 2 * segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const bool has_it = std::find(small.segments.begin(), small.segments.end(), segments[i]) !=
                        small.segments.end();
    EXPECT_FALSE(std::isnan(table[i]));
    EXPECT_EQ(std::isnan(table[segments.size() + i]), !has_it) << segment_name(segments[i]);
  }
}

TEST(TensionTable, IsOfRoutingsThatAMotorPulls) {
  EXPECT_EQ(testing::input_error([] {
              filled({"M-1-M", "F-1-F"});
            }),
            "routing 'F-1-F': the tendon with T1 is not actuated: it has no M and no P, so the "
            "motor cannot pull it");
}

}  // namespace
}  // namespace reeve
