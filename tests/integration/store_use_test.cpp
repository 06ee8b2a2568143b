// What a store keeps, put together, ranked again, and read by other programs.
#include <gtest/gtest.h>

#include "tests/integration/stored.hpp"
#include "tests/support/has.hpp"
#include "tests/support/svg.hpp"

namespace reeve::testing {
namespace {

// Without the last column, the exploration's id, which a ranking does not have.
std::string without_id(const std::string& csv) {
  std::string result;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    result += line.substr(0, line.rfind(',')) + '\n';
  }
  return result;
}

struct AskedCase {
  const char* name;
  Arguments asked;
};

const Arguments kept("--fingers 4 --top 40 --constraint sheaths<=6");

class RankedStore : public Stored, public ::testing::WithParamInterface<AskedCase> {
 protected:
  ProcessResult ranked(const std::string& format) const {
    Arguments command{"rank", "--store", "s.db", "--format", format};
    command.insert(command.end(), GetParam().asked.begin(), GetParam().asked.end());
    return run(command);
  }

  std::string explored() const {
    Arguments arguments("--fingers 4");
    for (const std::string& argument : GetParam().asked) arguments.push_back(argument);
    for (const char* option : {"--top", "--constraint"}) {
      const auto given = std::find(arguments.begin(), arguments.end(), option);
      if (given != arguments.end()) continue;
      const auto at = std::find(kept.begin(), kept.end(), option);
      arguments.insert(arguments.end(), at, at + 2);
    }
    return without_id(Explored(arguments).file("designs.csv"));
  }
};

class RankedWhole : public RankedStore {};

TEST_P(RankedWhole, IsTheExplorationWithTheseObjectives) {
  ASSERT_EQ(explore(kept, {}, {"--keep", "all"}).exit_code, 0);
  const ProcessResult result = ranked("csv");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(result.out == explored()) << result.out.substr(0, 1000);
  EXPECT_TRUE(Json::parse(ranked("json").out)["exact"]);
}

INSTANTIATE_TEST_SUITE_P(
    Of, RankedWhole,
    ::testing::Values(AskedCase{"AsItWas", {}},
                      AskedCase{"Objectives", {"--objectives", "uniformity_worst,sheaths,travel"}},
                      AskedCase{"Score", {"--score", "uniformity=2,sheaths=0.1", "--top", "2000"}},
                      AskedCase{"Constraints",
                                {"--constraint", "pulleys<=1", "--constraint", "jams<=0"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

class RankedBest : public RankedStore {};

TEST_P(RankedBest, IsExactWhereItSaysSo) {
  ASSERT_EQ(explore(kept).exit_code, 0);
  const ProcessResult result = ranked("csv");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(result.out == explored()) << result.out.substr(0, 1000);
  EXPECT_TRUE(Json::parse(ranked("json").out)["exact"]);
}

INSTANTIATE_TEST_SUITE_P(
    Of, RankedBest,
    ::testing::Values(AskedCase{"AsItWas", {}}, AskedCase{"Fewer", {"--top", "7"}},
                      AskedCase{"OnTheWorseSide",
                                {"--constraint", "sheaths<=6", "--constraint", "uniformity>=0.8"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

class RankedGap : public RankedStore {};

TEST_P(RankedGap, SaysThatDesignsMayBeMissing) {
  ASSERT_EQ(explore(kept).exit_code, 0);
  const Json json = Json::parse(ranked("json").out);
  EXPECT_FALSE(json["exact"]);
  EXPECT_EQ(json["inexact_because"].size(), 1U);
  EXPECT_TRUE(has(ranked("table").out, "Note: not exact: "));
  const std::string csv = ranked("csv").out;
  EXPECT_TRUE(csv.starts_with("# not exact: ")) << csv;
  // It has reason to.
  EXPECT_NE(csv.substr(csv.find('\n') + 1), explored());
}

INSTANTIATE_TEST_SUITE_P(
    Of, RankedGap,
    ::testing::Values(AskedCase{"Objectives", {"--objectives", "travel,round_trip_efficiency"}},
                      AskedCase{"More", {"--top", "2000"}},
                      AskedCase{"Dropped", {"--constraint", "uniformity>=0.1"}},
                      AskedCase{"Elsewhere",
                                {"--constraint", "sheaths<=6", "--constraint", "pulleys<=0"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

class RankedFew : public RankedStore {};

// There are 54 designs.
TEST_P(RankedFew, IsExactSinceNoneWasLeftOut) {
  ASSERT_EQ(explore("--fingers 2 --top 60").exit_code, 0);
  ASSERT_TRUE(Json::parse(ranked("json").out)["exact"]);
  EXPECT_FALSE(has(ranked("table").out, "not exact"));
  Arguments arguments("--fingers 2 --top 60");
  arguments.insert(arguments.end(), GetParam().asked.begin(), GetParam().asked.end());
  EXPECT_TRUE(ranked("csv").out == without_id(Explored(arguments).file("designs.csv")));
}

INSTANTIATE_TEST_SUITE_P(
    Of, RankedFew,
    ::testing::Values(AskedCase{"Objectives", {"--objectives", "sheaths,uniformity_worst"}},
                      AskedCase{"Score", {"--score", "uniformity=2,sheaths=0.1"}},
                      AskedCase{"Elsewhere", {"--constraint", "pulleys<=0"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(Stored, IsExactWhereTheSameDesignsAreLeftOutAgain) {
  const auto exact = [&](Arguments asked) {
    asked.insert(asked.begin(), {"rank", "--store", "s.db", "--format", "json"});
    return Json::parse(run(asked).out)["exact"].get<bool>();
  };
  ASSERT_EQ(explore("--constraint sheaths<=1").exit_code, 0);
  EXPECT_TRUE(exact({"--objectives", "travel"}));
  EXPECT_TRUE(exact({"--constraint", "sheaths<=1", "--constraint", "pulleys<=0"}));
  EXPECT_FALSE(exact({"--objectives", "travel", "--constraint", "sheaths<=2"}));
}

// The same words bound another score.
TEST_F(Stored, IsNotExactUnderABoundOnAnotherScore) {
  ASSERT_EQ(explore("--score uniformity=1 --constraint score>=0.5").exit_code, 0);
  const auto ranked = [&](const char* score) {
    return Json::parse(run({"rank", "--store", "s.db", "--score", score, "--format", "json"}).out);
  };
  EXPECT_TRUE(ranked("uniformity=1")["exact"]);
  EXPECT_FALSE(ranked("force_transmission=1")["exact"]);
}

TEST_F(Stored, IsNotExactWhereEqualsWereLeftOut) {
  ASSERT_EQ(explore("--objectives knots --top 53").exit_code, 0);
  const Json ranked = Json::parse(run("rank --store s.db --objectives travel --format json").out);
  EXPECT_EQ(ranked["kept"], 53);
  EXPECT_FALSE(ranked["exact"]);
}

TEST_F(Stored, WithAllDesignsSaysThatAllWereEvaluated) {
  const Arguments asked("--fingers 3 --constraint sheaths<=1");
  EXPECT_TRUE(has(explore(asked).out,
                  "\nOf the 426 that are actuated 394 fail by their parts alone; "
                  "the other 32 evaluated, "));
  std::filesystem::remove(store());
  EXPECT_TRUE(has(explore(asked, {}, {"--keep", "all"}).out, "\n426 evaluated, "));
}

// No option would give them.
TEST_F(Stored, SaysThatDesignsHaveNoCostOrMotorForce) {
  ASSERT_EQ(explore({}).exit_code, 0);
  const auto expect_refused = [&](const Arguments& asked, const std::string& message) {
    Arguments command("rank --store s.db");
    command.insert(command.end(), asked.begin(), asked.end());
    expect_bad(run(command), message);
  };
  const std::string without_prices =
      ": there is no cost of the designs of s.db, which was explored without prices: expected a "
      "store of explore --cost FILE.toml";
  const std::string without_hand =
      ": there is no motor_force of the designs of s.db, which was explored without a hand: "
      "expected a store of explore with the joints of the fingers in the file of --hardware or "
      "--model";
  expect_refused({"--objectives", "cost"}, "--objectives" + without_prices);
  expect_refused({"--score", "uniformity=1,cost=1"}, "--score" + without_prices);
  expect_refused({"--constraint", "cost<=1"}, "--constraint 'cost<=1'" + without_prices);
  expect_refused({"--objectives", "motor_force"}, "--objectives" + without_hand);
  expect_refused({"--constraint", "motor_force<=90"},
                 "--constraint 'motor_force<=90'" + without_hand);
}

// A step of the trade-off that others equal is among those that are counted and not kept.
TEST_F(Stored, CountsTheEqualsThatWereLeftOutOnce) {
  const Arguments arguments("--fingers 3 --parts paper --objectives knots --top 10");
  ASSERT_EQ(explore(arguments).exit_code, 0);
  const Json ranked = Json::parse(run("rank --store s.db --format json").out);
  EXPECT_TRUE(ranked["exact"]);
  EXPECT_EQ(ranked["front_equals_left_out"],
            Json::parse(read_text(folder_.path() / "out/summary.json"))["front_equals_left_out"]);
}

// Whatever the exploration was ranked by, each design is kept with all its objectives.
TEST_F(Stored, MeetsConstraintsOnWhatWasNotRanked) {
  ASSERT_EQ(explore({}).exit_code, 0);
  const Json json =
      Json::parse(run("rank --store s.db --objectives round_trip_efficiency --constraint travel<=1 "
                      "--format json")
                      .out);
  ASSERT_FALSE(json["top"].empty());
  double before = 1;
  for (const Json& design : json["top"]) {
    EXPECT_LE(design["travel"], 1);
    const double here = design["round_trip_efficiency"];
    EXPECT_LE(here, before);
    before = here;
  }
}

TEST_F(Stored, IsRankedByItsOwnHardwareAlone) {
  ASSERT_EQ(explore({}).exit_code, 0);
  const ProcessResult result = run("rank --store s.db --grasps none");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(
      has(result.err, "--grasps: a store has been evaluated already; expected with --store"));
  EXPECT_EQ(run("rank TR1 --top 3").exit_code, 2);
}

TEST_F(Stored, ShardsInStoresMergeToTheWhole) {
  const Arguments arguments("--fingers 4 --top 25");
  const Explored whole(arguments);
  const auto shard = [&](const std::string& index, const std::string& file) {
    Arguments command{"explore", "--out", "o" + index, "--shard", index + "/3", "--store", file};
    command.insert(command.end(), arguments.begin(), arguments.end());
    ASSERT_EQ(run(with_full_parts(command)).exit_code, 0);
  };
  shard("1", "a.db");
  shard("2", "b.db");
  shard("3", "a.db");
  const ProcessResult missing = run("merge a.db --out out");
  expect_bad(missing, "shard 2/3 is missing");
  expect_bad(run("merge b.db o2 a.db --out out"),
             "o2/shard.json: shard 2/3 is there twice, also as b.db");
  // A folder will do as well.
  for (const char* second : {"b.db", "o2"}) {
    EXPECT_EQ(run({"merge", second, "a.db", "--out", "out"}).exit_code, 0);
    expect_same_below(folder_.path() / "out", whole.out());
  }
}

std::string complaint(const ProcessResult& result) {
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  return result.err;
}

TEST_F(Stored, IsNotRankedBeforeItsFirstSave) {
  ASSERT_EQ(explore({}).exit_code, 0);
  execute(store(), "DELETE FROM shards");
  const std::string expected =
      "reeve: s.db: explore has saved nothing in it yet; expected a store after its first save\n";
  EXPECT_EQ(complaint(run("rank --store s.db")), expected);
  EXPECT_EQ(complaint(run("merge s.db --out merged")), expected);
}

// Whoever finds the fault, SQLite or the parser of words.
TEST_F(Stored, ThatIsDamagedIsNamedOnce) {
  ASSERT_EQ(explore({}).exit_code, 0);
  const auto once = [](const std::string& err) { return count(err, "s.db") == 1; };
  const auto changed = [&](const std::string& sql) {
    execute(store(), sql);
    return complaint(run("rank --store s.db"));
  };
  const std::string word = changed("UPDATE archive SET routing = 'M-9-Q' WHERE number = 0");
  EXPECT_TRUE(once(word) && word.find("is damaged") != std::string::npos) << word;
  const std::string counts = changed("UPDATE shards SET evaluated = generated + 1");
  EXPECT_TRUE(once(counts) && counts.find("shard 1 of 1") != std::string::npos) << counts;
  const std::string table = changed("DROP TABLE archive");
  EXPECT_TRUE(once(table)) << table;
}

class StoreLines : public Stored {
 protected:
  void SetUp() override {
    ASSERT_EQ(run("explore --fingers 3 --out out --store five.db").exit_code, 0);
    summary_ = Json::parse(read_text(folder_.path() / "out/summary.json"));
  }

  ProcessResult run_in(const Arguments& command) const {
    ProcessOptions options{.directory = folder_.path(),
                           .environment = {{"PYTHONWARNINGS", "ignore"}}};
    return run_process(command, options);
  }

  Json summary_;
};

TEST_F(StoreLines, ReadItInTheShell) {
  const std::vector<std::string> blocks = blocks_of("store.md", "sh");
  ASSERT_EQ(blocks.size(), 1U);
  const ProcessResult result = run_in({"bash", "-ec", blocks.front()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::istringstream lines(result.out);
  std::string line;
  std::getline(lines, line);
  const std::string total = summary_["total"].dump();
  EXPECT_EQ(line, "1|" + total + "|" + total + "|100.0");
  std::getline(lines, line);
  EXPECT_EQ(line.substr(0, 31), "routing,uniformity_mean,sheaths");
  // More uniform than any is none.
  double most = 0;
  for (const Json& design : summary_["front"]) {
    most = std::max(most, design["uniformity"]["mean"].get<double>());
  }
  std::getline(lines, line);
  EXPECT_EQ(std::stod(line.substr(line.find(',') + 1)), most);
}

}  // namespace
}  // namespace reeve::testing
