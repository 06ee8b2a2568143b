// `import` from end to end: from the log of a simulated rig to the cause that is planted in it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"
#include "tests/support/read_chart.hpp"
#include "tests/support/rig_log.hpp"

namespace reeve::testing {
namespace {

const std::string golden_log = std::string(REEVE_SOURCE_DIR) + "/tests/golden/log.csv";

// What the model says with the hardware in the file.
std::vector<RigStrand> strands(const std::string& routing, const std::string& held,
                               const std::string& hardware) {
  const auto tensions = [&](const std::string& direction) {
    return Json::parse(reeve({"show", routing, "--held", held, "--hardware", hardware,
                              "--direction", direction, "--format", "json"})
                           .out)["grasps"][0]["tensions"];
  };
  const Json pull = tensions("pull");
  const Json release = tensions("release");
  std::vector<RigStrand> result;
  for (const char* strand : {"T1", "T2", "T3", "T4"}) {
    result.push_back({pull[strand], release[strand]});
  }
  return result;
}

// Two mountings of each of three routings on a rig whose tubes are smoother than the paper's.
std::string smooth_rig(const TemporaryFolder& folder) {
  const std::string hardware = folder.write("truth.toml", "[tube]\nmu = 0.10\n").string();
  RigPlan plan;
  plan.strokes = 1;
  plan.correlation = 0.9;
  std::vector<RigRun> runs;
  for (const char* run : {"left", "right"}) {
    for (const char* routing : {"TR1", "TR3", "TR7"}) {
      runs.push_back(
          {std::string(run) + "-" + routing, routing, "1", strands(routing, "1", hardware)});
    }
  }
  return rig_csv(rig_log(plan, runs), runs, {.position = true, .speed = false, .labels = true});
}

TEST(Import, LeadsADiagnosisToTheCauseThatIsPlantedInALog) {
  const TemporaryFolder folder;
  const std::string log = folder.write("rig.csv", smooth_rig(folder)).string();
  const std::string readings = (folder.path() / "readings.csv").string();
  const ProcessResult import = reeve({"import", log, "-o", readings});
  ASSERT_EQ(import.exit_code, 0) << import.err;
  const ProcessResult result = reeve({"diagnose", readings, "--format", "json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json json = Json::parse(result.out);
  ASSERT_EQ(json["causes"].size(), 1U) << json["causes"].dump(2);
  EXPECT_EQ(json["causes"][0]["name"], "tube_friction");
  EXPECT_NEAR(json["causes"][0]["parameters"][0]["value"].get<double>(), 0.10, 0.003);
  for (const Json& note : json["notes"]) EXPECT_NE(note["kind"], "time_series");
}

// Not thousands of readings, which chance would seem to explain never.
TEST(Diagnose, SendsATimeSeriesToImport) {
  const TemporaryFolder folder;
  const std::string log = folder.write("rig.csv", smooth_rig(folder)).string();
  const ProcessResult refused = reeve({"diagnose", log});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.out, "");
  EXPECT_TRUE(has(refused.err, "are a logger's time series"));
  EXPECT_TRUE(has(refused.err, "reeve import"));
  EXPECT_TRUE(has(refused.err, "--as-readings"));
}

TEST(Diagnose, TakesATimeSeriesForReadingsIfToldTo) {
  std::string text = "run,routing,motor_tension_N,T1_N,T2_N,time_s\n";
  for (int i = 0; i < 120; ++i) {
    text += fmt::format("{},TR1,{},{},{},{}\n", i / 30, 20 + i % 7, 6.4 + 0.32 * (i % 7),
                        3.6 + 0.18 * (i % 7) + 0.01 * (i % 3), 0.01 * i);
  }
  const TemporaryFolder folder;
  const std::string file = folder.write("fast.csv", text).string();
  EXPECT_EQ(reeve({"diagnose", file}).exit_code, 2);
  const ProcessResult taken = reeve({"diagnose", file, "--as-readings"});
  EXPECT_EQ(taken.exit_code, 0) << taken.err;
  EXPECT_TRUE(has(taken.out, "are a logger's time series"));
}

TEST(Import, WritesReadingsThatSayWhereTheyComeFrom) {
  const TemporaryFolder folder;
  const std::string readings = (folder.path() / "readings.csv").string();
  const ProcessResult result =
      reeve({"import", golden_log, "-o", readings, "--readings-per-stroke", "2"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string csv = read_text(readings);
  EXPECT_EQ(csv.find("# steady readings out of a logger's time series, by reeve "), 0U);
  EXPECT_TRUE(has(csv, "\n# simulated: a carriage goes to and fro, two mountings\n"));
  // But not where to: the same readings are the same file.
  EXPECT_TRUE(has(csv, "\n# command: reeve import " + golden_log + " --readings-per-stroke 2\n"));
  EXPECT_TRUE(
      has(csv,
          "\nrun,routing,held,direction,motor_tension_N,speed_mm_s,T1_N,T2_N,T3_N,T4_N,"
          "readings,motor_tension_sd_N,T1_sd_N,T2_sd_N,T3_sd_N,T4_sd_N,time_s\nleft-1,TR7,1,"
          "pull,"));
  EXPECT_TRUE(has(result.out, "Written: " + readings));
  EXPECT_EQ(reeve({"compare", readings}).exit_code, 0);
}

// The command goes into the readings, and with it the name of the log.
TEST(Import, OfAMeasuredLogDoesNotSayThatItIsSimulated) {
  const TemporaryFolder folder;
  const std::string text = read_text(golden_log);
  const std::string measured = text.substr(text.find('\n') + 1);  // without the comment
  const std::string readings = (folder.path() / "readings.csv").string();
  for (const char* name : {"simulated.csv", "As_Simulated.csv"}) {
    const std::string log = folder.write(name, measured).string();
    ASSERT_EQ(reeve({"import", log, "-o", readings}).exit_code, 0);
    const Json compared = Json::parse(reeve({"compare", readings, "--format", "json"}).out);
    EXPECT_EQ(compared["data"]["simulated"], false) << name;
  }
}

TEST(Import, PlotsReadingsAndWhyTheRestIsLeftOut) {
  const TemporaryFolder folder;
  const std::string plot = (folder.path() / "log.svg").string();
  const Json json =
      Json::parse(reeve({"import", golden_log, "--plot", plot, "--format", "json"}).out);
  const std::vector<ReadPanel> panels = read_chart(read_text(plot));
  ASSERT_EQ(panels.size(), 3U);
  const std::size_t pulls = panels[1].marks("bands", "taken, pulling").size();
  const std::size_t releases = panels[1].marks("bands", "taken, releasing").size();
  EXPECT_EQ(pulls + releases, json["readings"].size());
  EXPECT_EQ(pulls, static_cast<std::size_t>(std::count_if(
                       json["readings"].begin(), json["readings"].end(),
                       [](const Json& reading) { return reading["direction"] == "pull"; })));
  std::vector<std::string> categories;
  for (const ReadTick& tick : panels[2].y) categories.push_back(tick.text);
  for (const auto& [use, count] : json["samples"].items()) {
    if (count == 0) continue;
    EXPECT_TRUE(std::any_of(categories.begin(), categories.end(), [&](const std::string& category) {
      return category.ends_with("(" + count.dump() + ")");
    })) << use;
  }
}

TEST(Import, CountsEverySampleOnce) {
  const Json json = Json::parse(reeve({"import", golden_log, "--format", "json"}).out);
  std::size_t samples = 0;
  for (const auto& [use, count] : json["samples"].items()) samples += count.get<std::size_t>();
  EXPECT_EQ(samples, json["data"]["samples"]);
  std::size_t taken = 0;
  for (const Json& reading : json["readings"]) taken += reading["samples"].get<std::size_t>();
  EXPECT_EQ(json["samples"]["taken"], taken);
}

// The text, where commas and points stand for what a logger of another country writes.
std::string in_semicolons(std::string text) {
  std::replace(text.begin(), text.end(), ',', ';');
  std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

TEST(Import, ReadsALogInOtherSpellingsAlike) {
  const TemporaryFolder folder;
  RigPlan plan;
  plan.strokes = 1;
  RigRun run;
  run.strands = {{0.4, 0.7}, {0.3, 0.5}};
  const std::vector<RigRun> runs{run};
  const std::string plain = rig_csv(rig_log(plan, runs), runs);
  const std::string rows = plain.substr(plain.find('\n') + 1);
  const std::string other =
      "Time [s];Position_mm;Motor Tension;T1;T2;\ns;mm;N;N;N;\n" + in_semicolons(rows);
  const auto readings = [&](const std::string& name, const std::string& text) {
    const std::string log = folder.write(name, text).string();
    const ProcessResult result =
        reeve({"import", log, "--routing", "M-1-T-2-F", "--format", "json"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return Json::parse(result.out);
  };
  const Json expected = readings("plain.csv", plain);
  const Json found = readings("other.csv", other);
  EXPECT_EQ(found["data"]["motion"], "position");
  ASSERT_EQ(found["readings"].size(), expected["readings"].size());
  EXPECT_EQ(found["readings"][0]["tensions"], expected["readings"][0]["tensions"]);
}

TEST(Import, TakesLabelsThatTheLogLacksFromOptions) {
  const TemporaryFolder folder;
  RigPlan plan;
  plan.strokes = 1;
  RigRun run;
  run.strands = {{0.4, 0.7}, {0.3, 0.5}};
  std::string log = rig_csv(rig_log(plan, {run}), {run});
  log = "Zeit,Weg,Motor,T1,T2" + log.substr(log.find('\n'));
  const std::string file = folder.write("log.csv", log).string();
  const Json json =
      Json::parse(reeve({"import", file, "--routing", "M-1-T-2-F", "--map", "Zeit=time_s", "--map",
                         "Weg=position_cm", "--map", "Motor=motor_tension_N", "--unit", "kgf",
                         "--format", "json"})
                      .out);
  EXPECT_EQ(json["data"]["motion"], "position");
  EXPECT_NEAR(json["readings"][0]["speed_mm_s"].get<double>(), 10 * plan.speed_mm_s, 1);
  EXPECT_GT(json["readings"][0]["motor_tension"]["mean_N"].get<double>(), 9 * plan.least_load_N);
}

// The answer is no, and says why; there is no file without readings.
TEST(Import, ExitsWithOneIfNothingIsSteady) {
  const TemporaryFolder folder;
  const std::string log =
      folder.write("still.csv", "t,position_mm,motor_tension_N,T1_N\n0,1,20,6\n1,1,20,6\n")
          .string();
  const std::string readings = (folder.path() / "readings.csv").string();
  const ProcessResult result = reeve({"import", log, "--routing", "TR1", "-o", readings});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(has(result.out, "No steady reading in it."));
  EXPECT_TRUE(has(result.out, "too few samples"));
  EXPECT_FALSE(std::filesystem::exists(readings));
}

}  // namespace
}  // namespace reeve::testing
