// Mountings that seem to differ by more than those of any rig.
#include <gtest/gtest.h>

#include "diagnosis/diagnose.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/planting.hpp"

namespace reeve::testing {
namespace {

DiagnosisResult diagnosed(const PlantingPlan& plan, std::uint64_t seed) {
  DiagnoseOptions options;
  options.replicates = 100;
  return diagnose(read_data(plant(plan, seed).csv), Hardware{}, options);
}

TEST(BelievedScatter, IsThreeTimesTheAssumedOneAtMost) {
  MountingScatter scatter;
  scatter.relative = {0.11, 0.11, 0.29, 0.014};
  EXPECT_FALSE(believed(scatter).is_bounded);
  EXPECT_EQ(believed(scatter).relative, scatter.relative);
  scatter.relative[3] = 0.1;
  EXPECT_TRUE(believed(scatter).is_bounded);
  EXPECT_DOUBLE_EQ(believed(scatter).relative[3], 0.015);
  scatter.given = true;
  EXPECT_FALSE(believed(scatter).is_bounded);
}

TEST(BelievedScatter, NamesNothingOfARigThatIsMountedBadly) {
  PlantingPlan plan;
  plan.noise.mounted_exponent = 0.25;
  plan.runs = 6;
  const DiagnosisResult result = diagnosed(plan, 1);
  EXPECT_TRUE(result.causes.empty());
  EXPECT_TRUE(result.mounting.is_bounded);
}

}  // namespace
}  // namespace reeve::testing
