// The keys of the JSON of `import`, which docs/schema promises to keep.
#include <gtest/gtest.h>

#include "tests/golden/json_keys.hpp"

namespace reeve::testing {
namespace {

TEST(KeysOfImport, AreThePromisedOnes) {
  const Json json = json_of({"import", logged});
  EXPECT_EQ(keys(json), "data readings samples notes settings version");
  EXPECT_EQ(keys(json["data"]), "file simulated samples seconds_logged usual_step_s motion");
  EXPECT_EQ(keys(json["readings"][0]),
            "run routing held direction time_s lines samples readings speed_mm_s motor_tension "
            "tensions others");
  EXPECT_EQ(keys(json["readings"][0]["tensions"]), "T1 T2 T3 T4");
  EXPECT_EQ(keys(json["readings"][0]["motor_tension"]), "mean_N deviation_N");
  EXPECT_EQ(keys(json["samples"]),
            "taken standstill speed_varies load_varies settling not_following slack no_direction "
            "incomplete copy spike too_few");
  EXPECT_EQ(keys(json["settings"]),
            "min_duration_s tolerance readings_per_stroke reverse direction run routing held");
}

TEST(KeysOfAGuess, AreThePromisedOnes) {
  const Json json = Json::parse(reeve({"import", logged, "--guess", "--format", "json"}).out);
  EXPECT_EQ(keys(json),
            "file separator columns first_rows missing assumed can_be_imported command version");
  EXPECT_EQ(keys(json["columns"][0]), "name kind meaning reason");
  EXPECT_EQ(json["can_be_imported"], true);
}

}  // namespace
}  // namespace reeve::testing
