// Shards put together are the whole, byte for byte; what is not all of one exploration is refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/integration/stored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;

class Merging : public ::testing::Test {
 protected:
  ProcessResult run(Arguments arguments, const fs::path& directory) {
    ProcessOptions options{.directory = directory};
    return reeve(arguments, options);
  }

  // Into folder s<index>.
  void explore_shard(const Arguments& arguments, int index, int count) {
    Arguments command{"explore", "--out", "s" + std::to_string(index), "--shard",
                      std::to_string(index) + "/" + std::to_string(count)};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const ProcessResult result = run(with_full_parts(command), folder_.path());
    ASSERT_LT(result.exit_code, 2) << result.err;
  }

  ProcessResult merge(const std::vector<int>& indices, Arguments options = {}) {
    Arguments command("merge --out out");
    for (const int index : indices) command.push_back("s" + std::to_string(index));
    command.insert(command.end(), options.begin(), options.end());
    return run(command, folder_.path());
  }

  void expect_bad(const std::vector<int>& indices, const std::string& message) {
    const ProcessResult result = merge(indices);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "reeve: " + message + "\n");
    EXPECT_EQ(result.out, "");
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
  }

  TemporaryFolder folder_;
};

struct MergedCase {
  const char* name;
  Arguments arguments;
};

class MergingCase : public Merging, public ::testing::WithParamInterface<MergedCase> {};

TEST_P(MergingCase, GivesTheBytesOfTheWhole) {
  const Explored whole(GetParam().arguments);
  for (const int count : {1, 2, 3, 7}) {
    SCOPED_TRACE(count);
    fs::remove_all(folder_.path() / "out");
    std::vector<int> backwards;
    for (int index = 1; index <= count; ++index) {
      explore_shard(GetParam().arguments, index, count);
      backwards.insert(backwards.begin(), index);
    }
    const ProcessResult result = merge(backwards, {"--threads", "2"});
    EXPECT_EQ(result.exit_code, whole.result.exit_code) << result.err;
    EXPECT_EQ(result.err, "");
    expect_same_below(folder_.path() / "out", whole.out());
  }
}

// Short lists, so that each shard keeps what the whole does not and leaves out what equals.
INSTANTIATE_TEST_SUITE_P(
    Of, MergingCase,
    ::testing::Values(
        MergedCase{"ThreeFingers", {"--fingers", "3", "--top", "15"}},
        MergedCase{"FourFingersOfThePaper",
                   {"--fingers", "4", "--parts", "paper", "--tendons", "any"}},
        MergedCase{"Constraints",
                   {"--fingers", "3", "--constraint", "sheaths<=3", "--constraint",
                    "uniformity>=0.5", "--objectives", "uniformity,efficiency,sheaths,travel"}},
        MergedCase{
            "NothingThatMeetsThem",
            {"--fingers", "3", "--constraint", "uniformity>=2", "--constraint", "sheaths<=1"}},
        MergedCase{
            "NothingThatMeetsThemThoughPartsDo",
            {"--fingers", "3", "--constraint", "sheaths<=1", "--constraint", "uniformity>=0.9999"}},
        MergedCase{"FewPartsWithBlocks",
                   {"--fingers", "2", "--parts", "all", "--constraint", "sheaths<=1"}},
        MergedCase{"KnownRoutingsThatAreRejected",
                   {"--constraint", "sheaths<=2", "--constraint", "jams<=0"}},
        MergedCase{"Uncertainty",
                   {"--fingers", "3", "--uncertainty", "--draws", "25", "--top", "20"}},
        MergedCase{"EqualDesigns", {"--fingers", "3", "--top", "2", "--objectives", "jams,knots"}},
        MergedCase{"OneTendon", {"--fingers", "4", "--tendons", "one", "--top", "30"}},
        MergedCase{"DesignsWithoutTensions",
                   {"--motors", "2", "--grasps", "none@1,-1", "--tips", "tube", "--top", "9"}},
        MergedCase{"NoJoins", {"--joins", "", "--grasps", "all"}},
        MergedCase{"AScore", {"--fingers", "3", "--score", "authors", "--top", "10"}},
        MergedCase{"Blocks",
                   {"--fingers", "3", "--parts", "all", "--cost",
                    REEVE_CATALOG_DIR "/prices/example.toml", "--tradeoff", "cost", "--top", "10"}},
        MergedCase{"DistinctFingersOfAHand",
                   {"--fingers", "3", "--distinct-fingers", "--tips", "bearing", "--hardware",
                    REEVE_CATALOG_DIR "/hardware/three_finger_hand.toml", "--top", "12"}},
        MergedCase{"AModelThatNeedNotConverge",
                   {"--fingers", "2", "--model", REEVE_CATALOG_DIR "/model/example.toml", "--top",
                    "7", "--details", "3"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(Merging, PrintsWhatTheWholePrints) {
  const Explored whole("--fingers 3 --format json");
  for (const int index : {1, 2}) explore_shard({"--fingers", "3"}, index, 2);
  const ProcessResult result = merge({1, 2}, {"--format", "json"});
  EXPECT_EQ(without_times(result.out), without_times(whole.result.out));
}

TEST_F(Merging, RefusesAnIncompleteSetOfShards) {
  const Arguments arguments("--fingers 3");
  for (const int index : {1, 2, 3}) explore_shard(arguments, index, 3);
  expect_bad({1, 3}, "shard 2/3 is missing");
  expect_bad({2}, "2 shards are missing: 1/3, 3/3");
  expect_bad({1, 2, 3, 2}, "s2/shard.json: shard 2/3 is there twice, also as s2/shard.json");
  fs::copy(folder_.path() / "s1", folder_.path() / "s4", fs::copy_options::recursive);
  expect_bad({1, 2, 4}, "s4/shard.json: shard 1/3 is there twice, also as s1/shard.json");
}

TEST_F(Merging, TakesShardsOfOneExplorationOnly) {
  explore_shard({"--fingers", "3"}, 1, 3);
  explore_shard({"--fingers", "3", "--top", "20", "--constraint", "sheaths<=2"}, 2, 3);
  explore_shard({"--fingers", "3"}, 3, 4);
  explore_shard({"--fingers", "3"}, 4, 4);
  expect_bad({1, 2},
             "s2/shard.json: it is of another exploration than s1/shard.json: other settings: top, "
             "constraints");
  expect_bad(
      {1, 3},
      "s3/shard.json: it is shard 3/4, and s1/shard.json is shard 1/3; expected shards of as "
      "many");
}

TEST_F(Merging, NamesAHardwareThatHasChanged) {
  const fs::path hardware = folder_.write("h.toml", "[tube]\nmu = 0.1\n");
  for (const int index : {1, 2}) explore_shard({"--hardware", "h.toml"}, index, 2);
  folder_.write("h.toml", "[tube]\nmu = 0.2\n");
  expect_bad({1, 2}, "s1/shard.json: it was made by other settings: hardware");
  fs::remove(hardware);
  expect_bad({1, 2}, "h.toml: cannot be read: No such file or directory");
}

TEST_F(Merging, RefusesAShardThatWasStopped) {
  explore_shard({"--fingers", "9"}, 2, 1000000);
  ProcessOptions options{
      .directory = folder_.path(),
      .disturbance = Disturbance{SIGINT, after_it_catches(SIGINT, std::chrono::milliseconds(500))}};
  const ProcessResult stopped = reeve("explore --fingers 9 --shard 1/2 --out s1", options);
  ASSERT_EQ(stopped.exit_code, 3) << stopped.err;
  const ProcessResult result = merge({1});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "s1/shard.json: shard 1/2 was stopped after "));
}

TEST_F(Merging, RefusesAFileThatIsNotAWholeShard) {
  for (const int index : {1, 2}) explore_shard({}, index, 2);
  run("explore --out s3", folder_.path());
  expect_bad({1, 3},
             "s3: there is no shard.json; expected the folder of an exploration with --shard");
  expect_bad({7}, "s7/shard.json: cannot be read: No such file or directory");
  fs::copy_file(folder_.path() / "s2/designs.csv", folder_.path() / "s1/designs.csv",
                fs::copy_options::overwrite_existing);
  const std::string whole = "; expected the folder of an exploration that was written to its end";
  expect_bad({1, 2}, "s1: designs.csv and summary.json are of two explorations" + whole);
  fs::remove(folder_.path() / "s1/summary.json");
  expect_bad({1, 2}, "s1: there is no summary.json, which is written last" + whole);
  const ProcessResult into = run("merge s1 s2 --out s2", folder_.path());
  EXPECT_EQ(into.exit_code, 2);
  EXPECT_TRUE(has(into.err, "--out 's2': expected another folder"));
}

TEST_F(Merging, RefusesAFileThatSomebodyChanged) {
  explore_shard({}, 1, 1);
  const fs::path file = folder_.path() / "s1/shard.json";
  const std::string text = read_text(file);
  const auto with = [&](const std::string& old, const std::string& changed) {
    std::string other = text;
    const std::size_t at = other.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return folder_.write("s1/shard.json", other.replace(at, old.size(), changed));
  };
  const auto expect_refused = [&](const std::string& message) {
    const ProcessResult result = merge({1});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(result.err.starts_with("reeve: s1/shard.json: " + message)) << result.err;
  };
  const std::string changed = "it was changed or damaged: its digest is ";
  with("1-P-2-P-1", "1-P-2-T-1");
  expect_refused(changed);
  with("\n    \"1-P-2-P-1\",", "");
  expect_refused(changed);
  with("\"generated\": ", "\"generated\": 1");
  expect_refused(changed);
  with("\"seconds\": ", "\"seconds\": -");
  expect_refused("seconds '-");
  with(",\n  \"digest\"", ",\n  \"other\"");
  expect_refused("it has no digest, so that it cannot be told whether it is whole");
  with("\"evaluated\":", "\"valued\":");
  EXPECT_EQ(merge({1}).exit_code, 2);
  folder_.write("s1/shard.json", text.substr(0, text.size() / 2));
  const ProcessResult half = merge({1});
  EXPECT_EQ(half.exit_code, 2);
  EXPECT_TRUE(has(half.err, "s1/shard.json: it cannot be understood"));
}

// Lists that the shards printed are none of the whole, and its command is that of the first.
TEST_F(Merging, DoesNotDependOnHowShardsWereShownAndNamed) {
  const Arguments table(
      "--fingers 2 --objectives uniformity,efficiency --format latex --columns "
      "name,routing --top 20 --text-width 88mm");
  explore_shard(table, 1, 2);
  explore_shard({"--fingers", "2", "--top", "20"}, 2, 2);
  for (const std::vector<int>& order : {std::vector{1, 2}, std::vector{2, 1}}) {
    fs::remove_all(folder_.path() / "out");
    const ProcessResult result = merge(order, {"--format", "json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(has(read_text(folder_.path() / "out/index.html"), "--objectives"));
  }
}

TEST_F(Merging, RefusesAnEmptyName) {
  explore_shard({"--fingers", "2"}, 1, 1);
  const ProcessResult result = run("merge '' --out .", folder_.path() / "s1");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err,
            "reeve: '': it is no name; expected that of a folder of explore --shard, or of a "
            "store\n");
  EXPECT_TRUE(fs::exists(folder_.path() / "s1/shard.json"));
}

TEST_F(Merging, LeavesAShardsFileOutOfAWholeExploration) {
  explore_shard({}, 1, 1);
  EXPECT_TRUE(fs::exists(folder_.path() / "s1/shard.json"));
  run("explore --parts full --out s1", folder_.path());
  EXPECT_FALSE(fs::exists(folder_.path() / "s1/shard.json"));
}

// How near others come is for the whole to say: to know it, all that is left out would be made.
TEST_F(Merging, SaysThatConstraintsLeaveAShardEmpty) {
  const ProcessResult result =
      run("explore --fingers 4 --parts full --constraint sheaths<=1 --shard 5/5", folder_.path());
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_TRUE(has(result.out,
                  "Of the 228 that are actuated 228 fail by their parts alone; the other 0 "
                  "evaluated, 0 a second"));
  EXPECT_TRUE(has(result.out, "No design of this shard meets the constraints"));
}

}  // namespace
}  // namespace reeve::testing
