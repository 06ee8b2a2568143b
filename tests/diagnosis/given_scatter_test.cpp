// How far mountings differ, where the user says it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "diagnosis/diagnose.hpp"
#include "tests/diagnosis/read_dataset.hpp"
#include "tests/support/planting.hpp"
#include "tests/support/sanitizers.hpp"

namespace reeve::testing {
namespace {

// Mountings that differ by 8 %, and no cause.
std::string of_few_mountings(std::uint64_t seed) {
  PlantingPlan plan;
  plan.noise.mounted_exponent = 0.08;
  plan.runs = 6;
  return plant(plan, seed).csv;
}

DiagnosisResult diagnosed_with(const std::string& csv, std::optional<double> given) {
  DiagnoseOptions options;
  options.replicates = 100;
  options.mounting_scatter = given;
  return diagnose(read_data(csv), Hardware{}, options);
}

double scatter_of(const MountingScatter& scatter, Mounted kind) {
  return scatter.relative[static_cast<std::size_t>(kind)];
}

// Of gains an eighth of it, as of the assumed scatters.
TEST(GivenMountingScatter, IsTakenAsItIs) {
  const DiagnosisResult result = diagnosed_with(of_few_mountings(71), 0.05);
  EXPECT_TRUE(result.mounting.given);
  EXPECT_DOUBLE_EQ(scatter_of(result.mounting, Mounted::sheath), 0.05);
  EXPECT_DOUBLE_EQ(scatter_of(result.mounting, Mounted::tube), 0.05);
  EXPECT_DOUBLE_EQ(scatter_of(result.mounting, Mounted::gain), 0.05 / 8);
  EXPECT_FALSE(diagnosed_with(of_few_mountings(71), std::nullopt).mounting.given);
}

// The same readings: with mountings that are said not to differ, what differs between them is
// something that no cause explains, or a cause; said to differ as they do, it is nothing.
TEST(GivenMountingScatter, DecidesWhatIsLeftToExplain) {
  SKIP_UNDER_SANITIZERS();
  const std::string csv = of_few_mountings(71);
  EXPECT_NE(diagnosed_with(csv, 0).verdict, Verdict::none);
  EXPECT_EQ(diagnosed_with(csv, 0.08).verdict, Verdict::none);
}

double width_of(const DiagnosisResult& result, const std::string& name) {
  for (const CalibratedCoefficient& of : result.calibration) {
    if (of.name == name) return of.parameter.high - of.parameter.low;
  }
  return 0;
}

// A coefficient is known no better than the mountings that it was seen in.
TEST(GivenMountingScatter, WidensIntervals) {
  PlantingPlan plan;
  plan.runs = 6;
  const std::string csv = plant(plan, 72).csv;
  const double narrow = width_of(diagnosed_with(csv, 0.02), "sheath_friction");
  const double wide = width_of(diagnosed_with(csv, 0.2), "sheath_friction");
  EXPECT_GT(narrow, 0);
  EXPECT_GT(wide, 3 * narrow);
}

}  // namespace
}  // namespace reeve::testing
