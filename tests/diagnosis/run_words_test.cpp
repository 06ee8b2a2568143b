#include "diagnosis/verdict/run_words.hpp"

#include <gtest/gtest.h>

namespace reeve::testing {
namespace {

TEST(RunsInWords, AreAsShortAsTheyCanBe) {
  MeasuredData data;
  data.runs = {"m1", "m2", "m3", "m4", "m5"};
  EXPECT_EQ(runs_text({2}, data), "run m3");
  EXPECT_EQ(runs_text({0, 1}, data), "runs m1 and m2");
  EXPECT_EQ(runs_text({0, 2, 3}, data), "runs m1, m3 and m4");
  EXPECT_EQ(runs_text({1, 2, 3}, data), "runs m2 to m4");
  EXPECT_EQ(runs_text({0, 1, 2, 3, 4}, data), "all runs");
  data.runs = {"run 1", "run 2", "run 3"};
  EXPECT_EQ(runs_text({1}, data), "run 2");
  EXPECT_EQ(runs_text({0, 2}, data), "run 1 and run 3");
}

}  // namespace
}  // namespace reeve::testing
