// What an exploration leaves on the disk, and that it does not depend on threads or shards.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

TEST(ExploreFiles, AreTheseAndNothingElse) {
  const Explored explored("--fingers 2");
  EXPECT_EQ(explored.result.exit_code, 0);
  EXPECT_EQ(explored.result.err, "");
  EXPECT_EQ(explored.files(),
            (Arguments(
                "designs.csv figures index.html pareto.csv sample.csv summary.json tradeoff.csv")));
  EXPECT_TRUE(has(
      explored.result.out,
      "Written: index.html, designs.csv, pareto.csv, sample.csv, tradeoff.csv, summary.json and "
      "figures in out\n"));
}

TEST(ExploreFiles, ReplaceThoseOfAnEarlierRun) {
  const TemporaryFolder folder;
  ProcessOptions options{.directory = folder.path()};
  reeve("explore --fingers 3 --out a/b", options);
  const std::string first = read_text(folder.path() / "a/b/designs.csv");
  reeve("explore --fingers 2 --parts full --out a/b", options);
  EXPECT_NE(read_text(folder.path() / "a/b/designs.csv"), first);
  EXPECT_EQ(read_text(folder.path() / "a/b/designs.csv"),
            Explored("--fingers 2").file("designs.csv"));
}

TEST(ExploreFiles, HoldWhatJsonOnStdoutHolds) {
  const Explored explored("--fingers 2 --format json");
  EXPECT_EQ(explored.result.out, explored.file("summary.json"));
}

TEST(ExploreFiles, AgreeWithEachOther) {
  const Explored explored("--fingers 3 --top 20");
  const Json summary = explored.summary();
  EXPECT_EQ(words(explored.file("designs.csv")).size(), 20U);
  ASSERT_EQ(summary["top"].size(), 20U);
  std::vector<std::string> top;
  for (const Json& design : summary["top"]) top.push_back(design["routing"]);
  EXPECT_EQ(words(explored.file("designs.csv")), top);
  std::vector<std::string> front;
  for (const Json& design : summary["front"]) front.push_back(design["routing"]);
  EXPECT_EQ(words(explored.file("pareto.csv")), front);
}

TEST(ExploreFiles, AreTheSameForAnyNumberOfThreads) {
  const auto with_threads = [](const std::string& threads) {
    return Explored(
        {"--fingers", "4", "--top", "100", "--uncertainty", "--draws", "20", "--threads", threads});
  };
  const Explored one = with_threads("1");
  for (const char* threads : {"2", "3"}) {
    SCOPED_TRACE(threads);
    const Explored more = with_threads(threads);
    EXPECT_EQ(more.file("designs.csv"), one.file("designs.csv"));
    EXPECT_EQ(more.file("pareto.csv"), one.file("pareto.csv"));
    EXPECT_TRUE(more.file("index.html") == one.file("index.html"));
    EXPECT_EQ(more.file("figures/pareto.svg"), one.file("figures/pareto.svg"));
    EXPECT_EQ(without_times(more.file("summary.json")), without_times(one.file("summary.json")));
  }
  EXPECT_EQ(words(one.file("designs.csv")).size(), 100U);
}

// What stands in the element, unescaped.
std::string command_of(const std::string& page) {
  const std::string opening = "id=\"command\">";
  const std::size_t begin = page.find(opening) + opening.size();
  std::string text = page.substr(begin, page.find("</pre>", begin) - begin);
  for (const auto& [escaped, plain] : std::vector<std::pair<std::string, std::string>>{
           {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&apos;", "'"}, {"&amp;", "&"}}) {
    for (std::size_t at = text.find(escaped); at != std::string::npos; at = text.find(escaped)) {
      text.replace(at, escaped.size(), plain);
    }
  }
  return text;
}

TEST(ExplorePage, GivesTheCommandThatGivesItAgain) {
  const Explored first({"--fingers", "2", "--constraint", "sheaths<=2", "--constraint", "jams==0",
                        "--threads", "1", "--objectives", "uniformity, travel"});
  const std::string command = command_of(first.file("index.html"));
  ASSERT_TRUE(command.starts_with("reeve explore ")) << command;
  ProcessOptions options{.directory = first.folder.path()};
  const std::string page = first.file("index.html");
  std::filesystem::remove_all(first.out());
  const std::string program = reeve_path();
  EXPECT_EQ(
      run_process({"/bin/sh", "-c", "reeve() { '" + program + "' \"$@\"; }; " + command}, options)
          .exit_code,
      0)
      << command;
  EXPECT_TRUE(first.file("index.html") == page) << command;
}

TEST(ExploreShards, MayOutnumberTheRoutings) {
  const Json summary = Explored("--fingers 1 --parts paper --shard 6/7").summary();
  EXPECT_LE(summary["generated"], 1);
  EXPECT_FALSE(summary["partial"]);
}

TEST(ExploreCounts, AgreeWithCount) {
  const Json summary = Explored("--fingers 3 --parts field --distinct-fingers").summary();
  const Json counts = Json::parse(reeve("count --fingers 3 --distinct-fingers --format json").out);
  EXPECT_EQ(summary["generated"], counts["all"]);
  EXPECT_EQ(summary["evaluated"], counts["actuated"]);
  EXPECT_EQ(summary["rejected"]["not actuated"],
            counts["all"].get<int>() - counts["actuated"].get<int>());
}

Json counted(const Arguments& parts) {
  Arguments command("count --format json");
  command.insert(command.end(), parts.begin(), parts.end());
  return Json::parse(reeve(command).out);
}

TEST(Count, AllPartsAreTheFullOnesWithAnchoredTipsAndABlock) {
  const Json all = counted({"--parts", "all"});
  EXPECT_EQ(all["all"], 168 + 312);
  EXPECT_EQ(all["actuated"], 70 + 213);
  EXPECT_EQ(all["one_tendon"], 42 + 129);
  EXPECT_EQ(counted({"--anchored", "--blocks", "1"}), all);
  EXPECT_EQ(counted({"--parts", "all", "--blocks", "2"})["all"], 168 + 312 + 810);
  EXPECT_EQ(counted({"--parts", "all", "--blocks", "0"})["all"], 168);
  EXPECT_EQ(counted({"--parts", "paper", "--anchored"})["all"], 43);
}

TEST(Count, SaysTreesWhereBlocksTieTendonsTogether) {
  EXPECT_TRUE(has(reeve("count --blocks 1").out, "every tree actuated"));
  EXPECT_TRUE(has(reeve("count --parts full").out, "every tendon actuated"));
}

// The user asked for a set of routings: those that cannot be solved are no error, as one that the
// user names is.
TEST(ExploreWithoutTensions, GoesOnAndSaysHowManyAndWhy) {
  const Explored explored("--motors 2 --grasps none@1,-1 --tips tube");
  EXPECT_EQ(explored.result.exit_code, 0) << explored.result.err;
  const Json summary = explored.summary();
  const auto count = summary["rejected"]["no tensions"].get<std::uint64_t>();
  EXPECT_EQ(summary["generated"].get<std::uint64_t>(),
            summary["rejected"]["not actuated"].get<std::uint64_t>() + count +
                summary["ranked"].get<std::uint64_t>());
  EXPECT_TRUE(has(explored.result.out, " " + std::to_string(count) + " without tensions, "));
  EXPECT_TRUE(has(explored.result.out, "Note: " + std::to_string(count) +
                                           " designs left out for want of tensions in a grasp, "
                                           "such as routing 'M-1-P2-2-F'"))
      << explored.result.out;
  EXPECT_TRUE(has(explored.file("index.html"),
                  std::to_string(count) + ": no tensions in one of the grasps."));
  const ProcessResult named = reeve({"rank", "M-1-P2-2-F", "--grasps", "none@1,-1"});
  EXPECT_EQ(named.exit_code, 2);
}

TEST(ExploreWithoutTensions, SaysSoIfNoneIsLeft) {
  const TemporaryFolder folder;
  const std::string file = folder.write("h.toml", "[contact.\"T1-T2\"]\nmu = 9\n").string();
  const Explored explored({"--fingers", "1", "--parts", "paper", "--hardware", file});
  EXPECT_EQ(explored.result.exit_code, 1) << explored.result.err;
  EXPECT_TRUE(has(explored.result.out, "No design has tensions in all grasps"))
      << explored.result.out;
}

}  // namespace
}  // namespace reeve::testing
