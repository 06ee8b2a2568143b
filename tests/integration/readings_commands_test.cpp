// `compare` and `simulate` from end to end.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

TEST(Compare, WritesWhatItPrintsAndOneLineForEachValue) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "new" / "out").string();
  const ProcessResult result = reeve({"compare", readings, "--format", "json", "--out", out});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(read_text(out + "/comparison.json"), result.out);
  const Json json = Json::parse(result.out);
  const std::string csv = read_text(out + "/residuals.csv");
  // The header, and the line that says that the data are simulated.
  EXPECT_EQ(
      std::count(csv.begin(), csv.end(), '\n'),
      2 + json["tension"]["all"]["count"].get<int>() + json["share"]["all"]["count"].get<int>());
  EXPECT_TRUE(has(csv, "\n4,\"May 3, left\",M-1-P-2-M,1,pull,T1,tension,3.4,"));
  EXPECT_TRUE(has(csv, "\n8,C,M-1-P-2-M,1;2,pull,"));
}

TEST(Compare, SaysThatNothingIsFittedAndWhichDataAreSimulated) {
  const std::string simulated = reeve({"compare", readings}).out;
  EXPECT_TRUE(has(simulated, "\nNothing is fitted. "));
  EXPECT_TRUE(has(simulated, "\nThe data are simulated: "));
  EXPECT_TRUE(has(simulated, " (line 5)\n"));
  const std::string measured =
      reeve({"compare", std::string(REEVE_CATALOG_DIR) + "/measured/canyons_and_crags.csv"}).out;
  EXPECT_TRUE(has(measured, "\nNothing is fitted. "));
  EXPECT_FALSE(has(measured, "simulated"));
}

// The readings that it was fitted to are nearer to a saved model than to the plain one.
TEST(Compare, TakesAModelThatADiagnosisSaved) {
  const TemporaryFolder folder;
  const std::string data = std::string(REEVE_SOURCE_DIR) + "/tests/golden/diagnose_cause.csv";
  const std::string model = (folder.path() / "model.toml").string();
  ASSERT_EQ(reeve({"diagnose", data, "--save-model", model}).exit_code, 0);
  const auto compared = [&](const Arguments& more) {
    Arguments arguments{"compare", data, "--format", "json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Json::parse(reeve(arguments).out);
  };
  const Json plain = compared({});
  const Json extended = compared({"--model", model});
  EXPECT_LT(extended["tension"]["all"]["rms"].get<double>(),
            0.5 * plain["tension"]["all"]["rms"].get<double>());
  EXPECT_TRUE(plain["settings"]["model"].is_null());
  EXPECT_FALSE(extended["settings"]["model"]["effects"].empty());
}

TEST(Compare, ReadsAPipe) {
  const ProcessResult result =
      run_process({"bash", "-c", "cat \"$1\" | \"$0\" compare /dev/stdin", reeve_path(), readings});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(result.out, "6 readings in 3 runs"));
}

const Arguments planned("simulate --routings TR1,TR5,TR7 --cycles 0:3000");

ProcessResult simulate(const Arguments& options) {
  Arguments arguments = planned;
  arguments.insert(arguments.end(), options.begin(), options.end());
  return reeve(arguments);
}

TEST(Simulate, TakesNamesOfTheCatalogueInSitesOfLaws) {
  const auto with_tube_of = [](const std::string& routing) {
    const std::string law = "law[exponent of tube 1 in pull of " + routing + ", cycle, linear]";
    const std::string csv = simulate({"--cause", law, "--set", "a=0.0001"}).out;
    return csv.substr(csv.find("\nrun,"));  // without the lines of the command
  };
  EXPECT_EQ(with_tube_of("TR5"), with_tube_of("M-1-P-2-M"));
}

TEST(Simulate, WritesTheSameBytesForTheSameSeedWhereverTheyGo) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "a.csv").string();
  const ProcessResult printed = simulate("--seed 5");
  const ProcessResult written = simulate({"-o", file, "--seed", "5"});
  EXPECT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_EQ(written.exit_code, 0) << written.err;
  EXPECT_EQ(written.out,
            file + ": 240 simulated readings in 12 runs of 3 routings, with no cause\n");
  EXPECT_EQ(read_text(file), printed.out);
  EXPECT_EQ(simulate("--seed=5").out, printed.out);
  EXPECT_NE(simulate("--seed 6").out, printed.out);
}

TEST(Simulate, GivesEachSettingToTheCauseBeforeIt) {
  const std::string csv =
      simulate(
          "--cause sensor_gain[T3] --set gain=1.08 --cause wear --set change=-0.4 "
          "--set cycles=300 --cause seized_contact[tr5,T1-T2]")
          .out;
  for (const char* line :
       {"\n# hidden cause: sensor_gain[T3] (gain = 1.08)\n",
        "\n# hidden cause: wear (change = -0.4, cycles = 300)\n",
        "\n# hidden cause: seized_contact[M-1-P-2-M,T1-T2]\n",
        "\n# command: reeve simulate --routings TR1,TR5,TR7 --cycles 0:3000 --cause "
        "'sensor_gain[T3]' --set gain=1.08 --cause wear --set change=-0.4 "
        "--set cycles=300 "
        "--cause 'seized_contact[tr5,T1-T2]'\n"}) {
    EXPECT_TRUE(has(csv, line)) << line << csv.substr(0, 1000);
  }
}

TEST(Simulate, WithoutNoiseAgreesWithTheModelInCompare) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "a.csv").string();
  simulate({"--noise-relative", "0", "--noise-absolute", "0", "--channels", "all", "--directions",
            "pull,release", "-o", file});
  const Json json = Json::parse(reeve({"compare", file, "--format", "json"}).out);
  EXPECT_EQ(json["data"]["simulated"], true);
  EXPECT_EQ(json["data"]["runs"], 12);
  EXPECT_EQ(json["data"]["routings"].size(), 3U);
  EXPECT_LT(json["tension"]["all"]["relative_rms"], 1e-5);
  EXPECT_TRUE(json["notes"].empty()) << json["notes"];
}

TEST(Simulate, WithPowerSaysHowOftenTheHiddenCauseIsFound) {
  const Arguments options("--cause sensor_gain[T3] --set gain=1.3 --power 2");
  Arguments as_json = options;
  as_json.insert(as_json.end(), {"--format", "json"});
  const ProcessResult result = simulate(as_json);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["findings"]["found"]["count"], 2) << json["trials"];
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(json["trials"][i]["seed"], 1 + i);
    EXPECT_EQ(json["trials"][i]["causes"].dump(), R"(["sensor_gain[T3]"])");
  }
  const std::string table = simulate(options).out;
  EXPECT_TRUE(table.starts_with(
      "2 simulated experiments, seeds 1 to 2, with sensor_gain[T3] (gain = 1.3)\n"))
      << table;
  EXPECT_TRUE(has(table, "\nfound                  2  1.000  0.158 to 1.000  all that is hidden"));
}

}  // namespace
}  // namespace reeve::testing
