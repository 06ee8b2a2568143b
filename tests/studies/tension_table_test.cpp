#include "studies/tension_table.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "core/mechanics.hpp"
#include "core/notation.hpp"
#include "core/tension/tension.hpp"

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

}  // namespace
}  // namespace reeve
