#include "numerics/student_t.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace reeve {
namespace {

// One degree of freedom is the Cauchy distribution, two have a closed form, many the normal one.
TEST(StudentT, QuantilesFollowTheClosedForms) {
  for (const double p : {0.6, 0.9, 0.975, 0.999}) {
    EXPECT_NEAR(student_t_quantile(p, 1), std::tan(std::numbers::pi * (p - 0.5)), 1e-9 / (1 - p));
    EXPECT_NEAR(student_t_quantile(p, 2), (2 * p - 1) / std::sqrt(2 * p * (1 - p)), 1e-9);
    EXPECT_NEAR(student_t_quantile(1 - p, 2), -student_t_quantile(p, 2), 1e-9);
  }
  EXPECT_NEAR(student_t_quantile(0.975, 1e8), 1.959963985, 1e-6);
}

}  // namespace
}  // namespace reeve
