// `reeve diagnose` from end to end: what it writes, and data that are poor or odd.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/has.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

using namespace std::chrono_literals;
using Json = nlohmann::ordered_json;

const std::string golden = std::string(REEVE_SOURCE_DIR) + "/tests/golden/";
const std::string with_cause = golden + "diagnose_cause.csv";

std::string without_seconds(const std::string& json) {
  Json parsed = Json::parse(json);
  parsed["seconds"] = 0;
  return parsed.dump();
}

// The lines of the data that has a cause: comment, header, readings.
std::vector<std::string> lines() {
  std::istringstream in(read_text(with_cause));
  std::vector<std::string> result;
  for (std::string line; std::getline(in, line);) result.push_back(line);
  return result;
}

Json diagnosed(const std::vector<std::string>& rows, Arguments options = {}, int exit_code = 0) {
  const TemporaryFolder folder;
  std::string text;
  for (const std::string& row : rows) text += row + '\n';
  folder.write("data.csv", text);
  ProcessOptions process{.directory = folder.path()};
  options.insert(options.begin(), {"diagnose", "data.csv", "--format", "json"});
  const ProcessResult result = reeve(options, process);
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_EQ(result.err, "");
  return result.exit_code <= 1 ? Json::parse(result.out) : Json();
}

bool has_note(const Json& diagnosis, const std::string& text) {
  return std::any_of(diagnosis["notes"].begin(), diagnosis["notes"].end(), [&](const Json& note) {
    return note["text"].get<std::string>().find(text) != std::string::npos ||
           note["kind"].get<std::string>() == text;
  });
}

TEST(Diagnose, AnswersFirst) {
  const ProcessResult result = reeve({"diagnose", with_cause});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(result.out.starts_with(
      "The friction coefficient of the tubes differs from the nominal one: tube_friction, mu = 0.0899"))
      << result.out;
  EXPECT_TRUE(has(result.out, "\nResiduals on 6 held-out runs fall by "));
  EXPECT_TRUE(has(result.out, "\nNo further structure in the residuals (p = "));
  EXPECT_TRUE(has(result.out, "\nThe data are simulated: "));
}

TEST(Diagnose, SaysSoWhereThereIsNoCauseOrMoreThanOne) {
  const std::string none = reeve({"diagnose", golden + "diagnose_none.csv"}).out;
  EXPECT_TRUE(none.starts_with("The nominal model explains the data as well as ")) << none;
  const std::string several = reeve({"diagnose", golden + "diagnose_indistinguishable.csv"}).out;
  EXPECT_TRUE(has(several, " explains the data.\n"));
  EXPECT_TRUE(has(several, "\nTo tell "));
}

// Readings of a sheath alone, which no finger holds.
TEST(Diagnose, OnABenchSpeaksOfNoGraspsAndRanksNoRoutings) {
  const TemporaryFolder folder;
  const std::string bench = golden + "diagnose_indistinguishable.csv";
  const ProcessResult result = reeve({"diagnose", bench, "--out", folder.path().string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  std::string page = read_text(folder.path() / "index.html");
  page.resize(page.find("</main>"));
  for (const std::string& text : {result.out, page}) {
    EXPECT_TRUE(has(text, "sheath_friction"));
    for (const char* word :
         {"grasp", "Grasp", "held fingers", "finger held", "jam", "TR1", "TR7", "Ranking"}) {
      EXPECT_FALSE(has(text, word)) << word;
    }
  }
  const Json json = Json::parse(read_text(folder.path() / "diagnosis.json"));
  EXPECT_TRUE(json["ranking"].is_null());
  EXPECT_TRUE(has(reeve({"diagnose", with_cause}).out, "Ranking of the catalogue"));
}

TEST(Diagnose, TakesAsManyReplicatesAsAlphaNeeds) {
  const std::string bench = golden + "diagnose_indistinguishable.csv";
  const auto replicates = [&](Arguments options) {
    options.insert(options.begin(), {"diagnose", bench, "--format", "json"});
    return Json::parse(reeve(options).out)["calibration"]["replicates"];
  };
  EXPECT_EQ(replicates({}), 1000);
  EXPECT_EQ(replicates({"--alpha", "0.004"}), 2000);
  EXPECT_EQ(replicates({"--alpha", "0.004", "--replicates", "2500"}), 2500);
  EXPECT_EQ(replicates({"--replicates", "400"}), 400);
}

TEST(Diagnose, AsksForTheUnitsRightBelowTheHeadline) {
  std::istringstream in(read_text(golden + "diagnose_indistinguishable.csv"));
  std::string data;
  for (std::string line; std::getline(in, line);) {
    const std::size_t last = line.rfind(',');
    const bool is_row = line[0] == '1' || line[0] == '2' || line[0] == '3' || line[0] == '4';
    data += is_row ? line.substr(0, last) + "," +
                         std::to_string(1000 * std::stod(line.substr(last + 1)))
                   : line;
    data += '\n';
  }
  const TemporaryFolder folder;
  folder.write("millinewton.csv", data);
  const std::string out = reeve({"diagnose", (folder.path() / "millinewton.csv").string()}).out;
  const std::size_t second = out.find('\n') + 1;
  EXPECT_EQ(out.find("Check the units first: the median of "), second) << out;
}

TEST(Diagnose, WritesWhatItPrintsAndOneLineForEachValue) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "new" / "out").string();
  const ProcessResult result = reeve({"diagnose", with_cause, "--format", "json", "--out", out});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(read_text(out + "/diagnosis.json"), result.out);
  const std::string csv = read_text(out + "/residuals.csv");
  EXPECT_TRUE(csv.starts_with("# simulated: "));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2 + 60 * 4);
}

TEST(Diagnose, WritesAPageWithItsFiguresForEachVerdict) {
  for (const char* verdict : {"cause", "none", "indistinguishable"}) {
    const TemporaryFolder folder;
    const std::string out = (folder.path() / "out").string();
    const std::string data = golden + "diagnose_" + verdict + ".csv";
    ASSERT_EQ(reeve({"diagnose", data, "--out", out}).exit_code, 0);
    const std::string page = read_text(out + "/index.html");
    EXPECT_TRUE(has(page, std::string("data-verdict=\"") + verdict + '"'));
    EXPECT_TRUE(has(page, "<strong>Simulated data.</strong>"));
    EXPECT_TRUE(has(page, "href=\"diagnosis.json\""));
    for (const char* figure : {"compared", "residuals-strand", "residuals-load", "held-out-runs"}) {
      const std::string svg = read_text(out + "/figures/" + figure + ".svg");
      EXPECT_TRUE(svg.starts_with("<svg ")) << verdict << ' ' << figure;
      EXPECT_TRUE(has(page, std::string("id=\"") + figure + '"')) << figure;
    }
    const bool asks = page.find("id=\"rows-to-record\"") != std::string::npos;
    EXPECT_EQ(asks, std::string(verdict) != "none");
    EXPECT_EQ(asks, std::filesystem::exists(out + "/figures/next-measurement.svg"));
  }
}

TEST(Diagnose, DoesNotWriteThePageOverTheData) {
  const TemporaryFolder folder;
  folder.write("index.html", read_text(with_cause));
  const std::string data = (folder.path() / "index.html").string();
  EXPECT_EQ(reeve({"diagnose", data, "--out", folder.path().string()}).exit_code, 2);
  EXPECT_EQ(read_text(data), read_text(with_cause));
}

TEST(Diagnose, SavesAModelThatRankTakes) {
  const TemporaryFolder folder;
  const std::string model = (folder.path() / "model.toml").string();
  const ProcessResult result =
      reeve({"diagnose", with_cause, "--format", "json", "--save-model", model});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(has(read_text(model), "\n# The data are simulated"));
  const Json ranked =
      Json::parse(reeve({"rank", "--catalogue", "--model", model, "--format", "json"}).out);
  std::vector<std::string> order;
  for (const Json& design : ranked["designs"]) order.push_back(design["name"]);
  EXPECT_EQ(Json::parse(result.out)["ranking"]["after"], order);
}

TEST(Diagnose, GivesTheSameBytesAndPageForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  ProcessOptions process{.directory = folder.path()};
  const auto with_threads = [&](const std::string& threads) {
    const ProcessResult result =
        reeve({"diagnose", with_cause, "--format", "json", "--out", "out", "--threads", threads},
              process);
    EXPECT_EQ(result.exit_code, 0);
    return without_seconds(result.out) + read_text(folder.path() / "out" / "index.html");
  };
  EXPECT_TRUE(with_threads("1") == with_threads("3"));
}

TEST(Diagnose, OffersGeneratedRoutingsIfAskedFor) {
  const Json json = diagnosed(lines(), {"--generated-routings"});
  EXPECT_TRUE(json["settings"]["generated_routings"]);
  EXPECT_LE(json["next_measurement"]["width_expected"].get<double>(),
            1.01 * diagnosed(lines())["next_measurement"]["width_expected"].get<double>());
}

TEST(Diagnose, OfOneRunSaysThatNothingIsHeldOut) {
  std::vector<std::string> rows = lines();
  rows.resize(2 + 10);
  const Json json = diagnosed(rows);
  EXPECT_EQ(json["runs"], 1);
  EXPECT_EQ(json["held_out_runs"], 0);
  EXPECT_TRUE(json["held_out"].is_null());
  EXPECT_TRUE(has_note(json, "one run only"));
}

TEST(Diagnose, OfOneConditionWorks) {
  std::vector<std::string> rows{"run,routing,motor_tension_N,T1_N,T2_N,T3_N,T4_N"};
  for (int i = 0; i < 24; ++i) {
    rows.push_back(std::to_string(i / 4) + ",TR1,20," + std::to_string(6.4 + 0.01 * (i % 5)) +
                   ",3.6,2.1,1.2");
  }
  EXPECT_FALSE(diagnosed(rows)["verdict"].is_null());
}

// No answer is not the answer that nothing is wrong.
TEST(Diagnose, ExitsWithOneIfThereIsOneReading) {
  std::vector<std::string> rows = lines();
  rows.resize(3);
  const Json json = diagnosed(rows, {}, 1);
  EXPECT_EQ(json["verdict"], "too_few");
  EXPECT_TRUE(has_note(json, "too few"));
}

TEST(Diagnose, DropsRepeatedRowsAndSaysSo) {
  std::vector<std::string> rows = lines();
  rows.push_back(rows[5]);
  rows.push_back(rows[6]);
  const Json json = diagnosed(rows);
  EXPECT_EQ(json["dropped_duplicates"], 2);
  EXPECT_EQ(json["rows"], 60);
  EXPECT_TRUE(has_note(json, "duplicate"));
}

// Another column in every row.
std::vector<std::string> changed(
    const std::function<void(std::vector<std::string>& fields, bool header)>& change) {
  std::vector<std::string> rows = lines();
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::vector<std::string> fields;
    std::istringstream in(rows[i]);
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    change(fields, i == 1);
    rows[i].clear();
    for (const std::string& field : fields) rows[i] += (rows[i].empty() ? "" : ",") + field;
  }
  return rows;
}

TEST(Diagnose, NotesTensionsInAnotherUnit) {
  const auto in_millinewton = changed([](std::vector<std::string>& fields, bool header) {
    if (header) return;
    for (std::size_t i = 5; i < fields.size(); ++i) {
      fields[i] = std::to_string(1000 * std::stod(fields[i]));
    }
  });
  EXPECT_TRUE(has_note(diagnosed(in_millinewton), "units"));
}

TEST(Diagnose, NotesAMotorSideThatCarriesMoreThanTheMotorGives) {
  const auto too_much = changed([](std::vector<std::string>& fields, bool header) {
    fields.push_back(header ? "Ta_N" : std::to_string(1.5 * std::stod(fields[4])));
  });
  std::vector<std::string> rows = too_much;
  std::erase_if(rows, [](const std::string& row) {
    return row.find("TR3") != std::string::npos || row.find("TR5") != std::string::npos;
  });
  EXPECT_TRUE(has_note(diagnosed(rows), "motor_side_above_motor"));
}

// A model that has not seen the run cannot know what it alone shows.
TEST(Diagnose, ClaimsNoGainOfAGraspThatOneRunAloneHas) {
  const ProcessResult simulated =
      reeve({"simulate", "--routings", "TR1,TR3,TR5,TR7", "--cause", "wrong_grasp[TR5]", "--set",
             "recorded=none", "--set", "actual=1", "--runs", "12"});
  std::vector<std::string> rows;
  std::istringstream in(simulated.out);
  for (std::string row; std::getline(in, row);) {
    const bool is_of_another_run = !row.starts_with("3,") && has(row, ",TR5,,");
    if (!is_of_another_run) rows.push_back(row);
  }
  const Json cause = diagnosed(rows)["causes"][0];
  EXPECT_EQ(cause["name"], "wrong_grasp[M-1-P-2-M]");
  EXPECT_EQ(cause["only_run"], "3");
  EXPECT_TRUE(cause["held_out"].is_null());
}

TEST(Diagnose, WritesNothingWhenStopped) {
  const TemporaryFolder folder;
  ProcessOptions options{.directory = folder.path(),
                         .disturbance = Disturbance{SIGINT, after_it_catches(SIGINT, 100ms)}};
  const ProcessResult result =
      reeve({"diagnose", with_cause, "--replicates", "100000", "--threads", "1", "--out", "out"},
            options);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "reeve: interrupted\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

TEST(Diagnose, ShowsItsStageOnATerminal) {
  ProcessOptions options{.stderr_is_terminal = true};
  options.environment["TERM"] = "xterm";
  const ProcessResult result = reeve({"diagnose", with_cause}, options);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(has(result.err, "searching for causes"));
  EXPECT_TRUE(result.err.ends_with("\r\x1b[K"));
}

}  // namespace
}  // namespace reeve::testing
