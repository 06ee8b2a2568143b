// The options of the subcommands for callers that are no shell, as values.
#include "cli/api.hpp"

#include <gtest/gtest.h>

#include "core/grasp.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

using Options = cli::api::Arguments;

SizingOptions size_options(Options arguments) {
  arguments.insert(arguments.end(), {"--nominal", "--starts", "1", "--evaluations", "10"});
  return cli::api::size(arguments, {}).options;
}

TEST(SizeOptions, OfATargetIsWithNoFingerHeldUnlessGraspsAreGiven) {
  const Options target{"TR1", "--vary", "tip_angle=1..4", "--target", "1=2,others=1"};
  EXPECT_EQ(to_text(goal_grasps(size_options(target))), "none");
  // Its objectives and motor force are those of all grasps that are asked.
  EXPECT_EQ(to_text(size_options(target).grasps), "none/1/2");
  Options held = target;
  held.insert(held.end(), {"--grasps", "1/2"});
  EXPECT_EQ(to_text(goal_grasps(size_options(held))), "1/2");
}

// Bounds that are given stand for those of the file, and with them for what it keeps equal.
TEST(SizeOptions, TakesWhatStaysEqualFromTheFileOnlyWithItsBounds) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("h.toml", "[vary]\ntip_angle = [1, 4]\nequal = [\"tips\"]\n").string();
  const Options of_file{"TR1", "--hardware", file};
  for (const auto& [given, variables] : {std::pair<Options, std::size_t>{{}, 1},
                                         {{"--vary", "tip_angle=1..3"}, 2},
                                         {{"--vary", "tip_angle=1..3", "--equal", "tips"}, 1}}) {
    Options arguments = of_file;
    arguments.insert(arguments.end(), given.begin(), given.end());
    const SizingOptions options = size_options(arguments);
    EXPECT_EQ(options.equal.size(), 2 - variables);
    EXPECT_EQ(options.varied.at(0).bounds.high, given.empty() ? 4 : 3);
  }
}

}  // namespace
}  // namespace reeve::testing
