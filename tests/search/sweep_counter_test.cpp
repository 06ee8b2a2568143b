#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "search/rank/staircase.hpp"

namespace reeve {
namespace {

TEST(SweepCounter, CountsWhatIsNotLess) {
  std::mt19937_64 engine(5);
  for (const std::uint64_t levels : {1U, 3U, 100U}) {
    std::vector<double> values;
    for (int i = 0; i < 200; ++i) values.push_back(static_cast<double>(engine() % levels) - 1);
    SweepCounter counter(values);
    for (auto value = values.begin(); value != values.end(); ++value) {
      for (double threshold = -2; threshold <= 5; threshold += 0.5) {
        const auto expected =
            std::count_if(values.begin(), value, [&](double v) { return v >= threshold; });
        ASSERT_EQ(counter.not_less(threshold), expected) << threshold;
      }
      counter.add(*value);
    }
  }
}

}  // namespace
}  // namespace reeve
