#include "diagnosis/verdict/row_scatter.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {
namespace {

constexpr std::size_t strands = 3;

// Readings of the model that scatter by 1 %, and their rows by τ.
MeasuredData rig(double tau, std::uint64_t seed, std::size_t shown = strands) {
  const std::string columns = "run,routing,motor_tension_N,T1_N,T2_N,T3_N\n";
  std::string bare = columns;
  for (std::size_t i = 0; i < 120; ++i) bare += fmt::format("A,TR5,{},1,1,1\n", 10 + i % 7 * 5);
  const MeasuredData planned = read_data(bare);
  const Forecast at = forecast(all_of(planned), {});
  std::string text = columns;
  for (std::size_t i = 0; i < 120; ++i) {
    text += fmt::format("A,TR5,{}", 10 + i % 7 * 5);
    const double row = 1 + tau * normal(seed, 1, i);
    for (std::size_t k = 0; k < strands; ++k) {
      const std::size_t cell = strands * i + k;
      const double own = 1 + 0.01 * normal(seed, 2, cell);
      text += k < shown
                  ? fmt::format(",{}", at.reading_N[static_cast<Eigen::Index>(cell)] * row * own)
                  : ",";
    }
    text += "\n";
  }
  return read_data(text);
}

std::optional<RowScatter> found(const MeasuredData& data) {
  const Dataset dataset = all_of(data);
  const Forecast at = forecast(dataset, {});
  return row_scatter(problem(dataset, 0.01 * at.reading_N), at);
}

TEST(RowScatter, IsThatOfTheMotorTension) {
  // The standard deviation of 120 numbers is known to 6.5 %.
  for (const double tau : {0.02, 0.06}) {
    const auto scatter = found(rig(tau, 11));
    ASSERT_TRUE(scatter);
    EXPECT_NEAR(scatter->relative, tau, 0.2 * tau);
    EXPECT_GT(scatter->log_likelihood_gain, 20);
  }
}

TEST(RowScatter, IsNotFoundWhereThereIsNone) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) EXPECT_FALSE(found(rig(0, seed))) << seed;
}

TEST(RowScatter, CannotBeSeenInSingleReadings) { EXPECT_FALSE(found(rig(0.06, 11, 1))); }

TEST(RowScatter, IsNotReportedWhereItIsGiven) {
  MeasuredData data = rig(0.06, 11);
  data.known_motor_noise = KnownNoise{.relative = 0.06};
  EXPECT_FALSE(found(data));
}

}  // namespace
}  // namespace reeve::testing
