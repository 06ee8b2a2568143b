// Subcommands from end to end: exit codes, names, help.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/edited_catalogue.hpp"
#include "tests/support/has.hpp"
#include "tests/support/svg.hpp"

namespace reeve::testing {
namespace {

// Where the bench takes the whole motor tension, all strands are slack.
TEST(Rank, PutsADesignWithSlackStrandsLast) {
  const std::string csv = reeve("rank M-F+M-1-F M-1-F --format csv").out;
  EXPECT_EQ(words(csv), (std::vector<std::string>{"M-1-F", "M-F+M-1-F"}));
  EXPECT_FALSE(has(csv, "nan"));
}

TEST(Show, TakesNamesInAnyCaseAndWords) {
  const std::string expected = reeve("show TR5 --format json").out;
  for (const char* routing : {"tr5", "Tr5", "tR5", "M-1-P-2-M", " TR5 ", " M-1-P-2-M "}) {
    const ProcessResult result = reeve({"show", routing, "--format", "json"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out, expected) << routing;
  }
}

TEST(Show, IsHeadedByTheNameOrTheWordThatWasGiven) {
  EXPECT_TRUE(reeve("show tr5").out.starts_with("TR5  M-1-P-2-M\n"));
  EXPECT_TRUE(reeve("show M-1-P-2-M").out.starts_with("M-1-P-2-M  (routing of TR5)\n"));
}

TEST(Show, NamesTheCanonicalWordWhereItIsAnother) {
  const Json json = Json::parse(reeve("show F-2-T-1-M --format json").out);
  EXPECT_EQ(json["routing"], "F-2-T-1-M");
  EXPECT_EQ(json["canonical"], "M-1-T-2-F");
  EXPECT_EQ(json["name"], "TR1");
}

const std::string example_model = std::string(REEVE_CATALOG_DIR) + "/model/example.toml";

TEST(Model, IsSaidOnceWithWhatIsLeftOutOfIt) {
  for (const Arguments command : {"show TR5", "rank TR5 TR7"}) {
    Arguments arguments = command;
    arguments.insert(arguments.end(), {"--model", example_model});
    const ProcessResult result = reeve(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(count(result.out, "Model with tube_friction (mu 0.09), "), 1U);
    EXPECT_EQ(count(result.out, "Left out, "), 1U);
    EXPECT_EQ(count(result.out, "sensor_gain[T3] (gain 1.08)"), 1U);
  }
  const Explored explored({"--model", example_model});
  EXPECT_EQ(explored.result.exit_code, 0);
  EXPECT_EQ(explored.summary()["settings"]["model"]["effects"].size(), 6U);
}

TEST(Model, OfAFingerThatNoRoutingHasIsNoted) {
  const TemporaryFolder folder;
  const std::string hardware = folder.write("h.toml", "[finger.3]\ntip_mu = 0.01\n").string();
  const std::string model =
      folder.write("m.toml", "[[effect]]\ncause = \"sheath_angle\"\nfinger = 3\nangle_rad = 2\n")
          .string();
  const std::string because = " changes nothing: no routing here has a finger 3\n";
  for (const Arguments command :
       {"show TR1", "rank TR1 TR3", "size TR1 --vary tip_angle=1..4 --nominal --starts 1"}) {
    const auto printed = [&](const std::string& option, const std::string& file) {
      Arguments arguments = command;
      arguments.insert(arguments.end(), {option, file});
      return reeve(arguments).out;
    };
    EXPECT_EQ(count(printed("--hardware", hardware), "Note: [finger.3] of the hardware" + because),
              1U)
        << command[0];
    EXPECT_EQ(count(printed("--model", model), "Note: sheath_angle[3] of the model" + because), 1U)
        << command[0];
  }
  const ProcessResult three = reeve({"show", "M-1-P-2-P-3-M", "--model", model});
  EXPECT_FALSE(has(three.out, "changes nothing"));
}

// The tips of 1x are tied, and no sheath leads to a finger of M-Y1+1x-Y1-2x.
TEST(ValuesOfNoContact, AreNotedOfOneRoutingAndRefusedOfAList) {
  const TemporaryFolder folder;
  const ProcessOptions there{.directory = folder.path()};
  folder.write("one.toml", "[finger.1]\nsheath_mu = 0.5\n");
  folder.write("two.toml", "[finger.2]\ntip_mu = 0.5\n[contact.\"T1-T2\"]\nmu = 0.5\n");
  folder.write("said.toml", "[finger.1]\ntip_angle_rad = 2\n[contact.\"T2-T3\"]\nangle_rad = 1\n");
  const std::string one =
      "Note: finger.1.sheath_mu of the hardware changes nothing: no contact here takes it";
  const std::string two =
      "Note: finger.2.tip_mu, contact.T1-T2 of the hardware change nothing: no contact here takes "
      "them";
  const std::string size = " --vary sheath_angle=1..2 --nominal --starts 1";
  for (const std::string line :
       {"show M-Y1+1x-Y1-2x", "export M-Y1+1x-Y1-2x", "size M-Y1+1x-Y1-2x"}) {
    const std::string options = line.starts_with("size") ? size : "";
    EXPECT_TRUE(has(reeve((line + options + " --hardware one.toml").c_str(), there).out, one))
        << line;
    EXPECT_TRUE(has(reeve((line + options + " --hardware two.toml").c_str(), there).out, two))
        << line;
  }
  EXPECT_FALSE(has(reeve("show TR1 --hardware one.toml", there).out, "Note: "));
  // The word has the angles.
  EXPECT_TRUE(has(reeve("show M-1/90-T/90-2-F --hardware said.toml", there).out,
                  "Note: finger.1.tip_angle_rad, contact.T2-T3 of the hardware change nothing"));
  const auto refused = [&](const char* line, const std::string& why) {
    const ProcessResult result = reeve(line, there);
    EXPECT_EQ(result.exit_code, 2) << line;
    EXPECT_TRUE(has(result.err, why)) << result.err;
  };
  const std::string sheath =
      "one.toml:2:1: hardware: finger.1.sheath_mu; expected a contact on which it acts in ";
  refused("rank M-Y1+1x-Y1-2x M-Y1+F-2-Y1-1-F --hardware one.toml", sheath + "one of the routings");
  refused("rank M-Y1+1x-Y1-2x --hardware two.toml", "finger.2.tip_mu; expected a contact");
  folder.write("middle.toml", "[finger.2]\nsheath_mu = 0.5\n");
  refused(
      "explore --fingers 3 --parts paper --joins T --tendons one --hardware middle.toml",
      "middle.toml:2:1: hardware: finger.2.sheath_mu; expected a contact on which it acts in one "
      "of the routings that are explored");
  // It acts in one of them.
  const ProcessResult ranked = reeve("rank M-Y1+1x-Y1-2x TR1 --hardware one.toml", there);
  EXPECT_EQ(ranked.exit_code, 0) << ranked.err;
  EXPECT_TRUE(has(ranked.out, ", 1 finger with own values where a routing has them;"));
}

TEST(Model, WithoutEffectsIsItsHardware) {
  const TemporaryFolder folder;
  const std::string file = folder.write("m.toml", "[tube]\nmu = 0.1\n").string();
  const std::string expected = reeve({"show", "TR1", "--hardware", file}).out;
  EXPECT_EQ(reeve({"show", "TR1", "--model", file}).out, expected);
}

TEST(Model, SeizesAContactOfTheRoutingThatItNames) {
  const auto grasp = [](const std::string& routing) {
    return Json::parse(
        reeve({"show", routing, "--held", "2", "--model", example_model, "--format", "json"})
            .out)["grasps"][0];
  };
  EXPECT_EQ(grasp("TR5")["tensions"]["T1"], 0);
  EXPECT_GT(grasp("TR2")["tensions"]["T1"], 0);
}

TEST(Model, NamesRoutingsAsTheCommandLineDoes) {
  const TemporaryFolder folder;
  const auto ranked = [&](const std::string& routing) {
    const std::string file =
        folder
            .write("m.toml", "[[effect]]\ncause = \"seized_contact\"\nrouting = \"" + routing +
                                 "\"\ncontact = \"T1-T2\"\n")
            .string();
    const ProcessResult result = reeve({"rank", "TR5", "TR7", "--model", file});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  };
  EXPECT_EQ(ranked("TR5"), ranked("M-1-P-2-M"));
}

TEST(Check, ExitsWithOneIfAPrintedNumberIsAnother) {
  const EditedCatalogue edited("tr1.toml", "0.32", "0.33");
  ProcessOptions options{.environment = {{"REEVE_CATALOG", edited.path().string()}}};
  const ProcessResult result = reeve("check --format json", options);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.err, "");
  const Json json = Json::parse(result.out);
  // The number itself, and the carriage that the row should add up to.
  EXPECT_EQ(json["differs"], 2);
  const Json& first = json["checks"][0];
  EXPECT_EQ(first["published"], 0.33);
  EXPECT_EQ(first["status"], "differs");
  EXPECT_FALSE(first["reason"].is_null());
}

TEST(Version, NamesReleaseCommitAndLicence) {
  const ProcessResult result = reeve("--version");
  EXPECT_EQ(result.exit_code, 0);
  const bool has_history = std::filesystem::exists(std::string(REEVE_SOURCE_DIR) + "/.git");
  const std::regex expected(
      has_history ? R"(reeve \d+\.\d+\.\d+ \([0-9a-f]{7,40}(-dirty(-[0-9a-f]{8})?)?\)\n)"
                  : R"(reeve \d+\.\d+\.\d+ \(.+\)\n)");
  const std::size_t end = result.out.find('\n') + 1;
  EXPECT_TRUE(std::regex_match(result.out.substr(0, end), expected)) << result.out;
  EXPECT_EQ(result.out.substr(end), "MIT licence, copyright 2026 the reeve authors; no warranty\n");
}

// A checkout whose program would be built.
class Checkout {
 public:
  Checkout() {
    std::filesystem::create_directory(folder_.path() / "tests");
    write("one.cpp", "int one();\n");
    write("tests/one_test.cpp", "\n");
    git({"init", "-q"});
    git({"add", "."});
    git({"-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "-m", "one"});
  }

  void write(const std::string& path, const std::string& text) const { folder_.write(path, text); }

  // As the build asks for it.
  std::string commit() const {
    const std::string header = (folder_.path() / "version_info.hpp").string();
    run_process({"cmake", "-DSOURCE=" + folder_.path().string(), "-DOUTPUT=" + header,
                 "-DNUMBER=1.2.3", "-P", REEVE_SOURCE_DIR "/cmake/version.cmake"});
    const std::string text = read_text(header);
    const std::size_t begin = text.find("COMMIT \"") + 8;
    return text.substr(begin, text.find('"', begin) - begin);
  }

 private:
  void git(std::vector<std::string> command) const {
    command.insert(command.begin(), {"git", "-C", folder_.path().string()});
    ASSERT_EQ(run_process(command).exit_code, 0);
  }

  TemporaryFolder folder_;
};

TEST(Version, TellsProgramsWithOtherChangesApart) {
  const Checkout checkout;
  const std::string clean = checkout.commit();
  EXPECT_TRUE(std::regex_match(clean, std::regex("[0-9a-f]{7,40}"))) << clean;
  checkout.write("one.cpp", "int one(int);\n");
  const std::string changed = checkout.commit();
  EXPECT_TRUE(std::regex_match(changed, std::regex(clean + "-dirty-[0-9a-f]{8}"))) << changed;
  checkout.write("tests/one_test.cpp", "int two;\n");
  EXPECT_EQ(checkout.commit(), changed);
  checkout.write("one.cpp", "int one(long);\n");
  EXPECT_NE(checkout.commit(), changed);
  checkout.write("one.cpp", "int one();\n");
  EXPECT_EQ(checkout.commit(), clean + "-dirty");
}

TEST(Help, MentionsEveryOption) {
  const Arguments generator(
      "--fingers --parts --tips --joins --ends --anchored --blocks --beside-ends --linked "
      "--series --bars --beckets --double-passes --motors --distinct-fingers");
  const Arguments ranking(
      "--grasps --objectives --score --uncertainty --draws --seed --threads --hardware "
      "--model --format --tradeoff --within --cost --sweep --columns --text-width");
  std::vector<std::pair<std::string, Arguments>> commands{
      {"show",
       {"routing", "--like", "--fingers", "--held", "--direction", "--svg", "--out", "--hardware",
        "--model", "--cost", "--format"}},
      {"rank",
       {"routing", "--catalogue", "--family", "--margin", "--fingers", "--out", "--data",
        "--distribution-mu", "--map", "--unit", "--group", "--store", "--constraint", "--top"}},
      {"explore",
       {"--tendons", "--constraint", "--shard", "--top", "--details", "--out", "--store",
        "--store-every", "--keep", "--target"}},
      {"count", {"--constraint", "--format"}},
      {"check", {"--family", "--svg", "--format"}},
      {"catalogue", {"--family", "--fingers", "--out", "--format"}},
      {"compare",
       {"data", "--out", "--map", "--unit", "--group", "--hardware", "--model", "--format"}},
      {"diagnose",
       {"data", "--hardware", "--alpha", "--hold-out", "--seed", "--replicates", "--threads",
        "--generated-routings", "--out", "--save-model", "--map", "--unit", "--group",
        "--mounting-scatter", "--as-readings", "--noise", "--exact", "--terms", "--format"}},
      {"simulate",
       {"--routings",       "--grasps",      "--directions",  "--channels",     "--motor-tension",
        "--speed",          "--cycles",      "--temperature", "--sheath-angle", "--noise-relative",
        "--noise-absolute", "--noise-motor", "--runs",        "--rows",         "--repeats",
        "--column",         "--run-column",  "--model",       "--cause",        "--set",
        "--power",          "--hardware",    "--seed",        "--format",       "-o,--output"}},
      {"export", {"routing", "--format", "-o,--output", "--hardware"}}};
  const auto add = [&](std::size_t command, const Arguments& options) {
    Arguments& list = commands[command].second;
    list.insert(list.end(), options.begin(), options.end());
  };
  const Arguments friction("--mu --tube-mu --sheath-mu --sheath-bend");
  for (const std::size_t command : {0U, 1U, 2U}) add(command, friction);
  add(1, ranking);
  add(2, ranking);
  add(2, generator);
  add(3, generator);
  const std::string overview = reeve("--help").out;
  for (const auto& [command, options] : commands) {
    EXPECT_TRUE(has(overview, "\n  " + command + " ")) << command;
    const ProcessResult help = reeve({command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.err, "");
    for (const std::string& option : options) {
      EXPECT_TRUE(has(help.out, "  " + option + " ")) << command << option;
    }
    // None that this list does not know.
    const std::regex line(R"(\n  (--[a-z-]+))");
    for (std::sregex_iterator found(help.out.begin(), help.out.end(), line), end; found != end;
         ++found) {
      EXPECT_NE(std::find(options.begin(), options.end(), found->str(1)), options.end())
          << command << found->str(1);
    }
  }
  EXPECT_TRUE(has(overview, "Exit codes: 0 "));
}

TEST(Explore, GivesEveryDesignOfTheFrontItsDistribution) {
  const Explored explored(
      "--top 1 --objectives uniformity,efficiency,sheaths,pulleys,knots --uncertainty --draws 20");
  const Json summary = explored.summary();
  ASSERT_GT(summary["front"].size(), 1U);
  for (const Json& design : summary["front"]) {
    ASSERT_TRUE(design.contains("rank_distribution")) << design["routing"];
    EXPECT_GE(design["rank_distribution"]["median"], 1);
  }
}

TEST(Explore, IsNotPartialThoughNoDesignIsKept) {
  const Explored explored("--constraint sheaths<=0 --uncertainty --draws 5");
  EXPECT_EQ(explored.result.exit_code, 1);
  EXPECT_FALSE(explored.summary()["partial"]);
  EXPECT_TRUE(explored.summary()["top"].empty());
}

TEST(Explore, OfRoutingsThatNoMotorPullsAnswersNo) {
  const Explored explored("--ends F --joins T");
  EXPECT_EQ(explored.result.exit_code, 1);
  EXPECT_TRUE(explored.summary()["top"].empty());
}

TEST(Explore, SaysWhyAKnownRoutingHasNoRank) {
  const Json without_pulleys = Explored("--joins T --constraint sheaths<=1").summary();
  for (const Json& known : without_pulleys["known"]) {
    if (known["name"] == "TR7") {
      EXPECT_FALSE(known["generated"]);
      EXPECT_TRUE(known["rejected_by"].is_null());
    }
    if (known["name"] == "TR2") {
      EXPECT_TRUE(known["generated"]);
      EXPECT_EQ(known["rejected_by"], "sheaths<=1");
    }
  }
}

TEST(Explore, NotesThatIdenticalFingersAreToldApart) {
  EXPECT_EQ(Explored("--grasps paper").summary()["notes"].size(), 1U);
  EXPECT_TRUE(Explored("--grasps paper --distinct-fingers").summary()["notes"].empty());
  EXPECT_TRUE(Explored({}).summary()["notes"].empty());
}

TEST(Rank, ComparesAMarginOnlyOverTheTwoMeans) {
  const ProcessResult result = reeve("rank --catalogue --margin --objectives force_transmission");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(has(result.err, "--margin"));
}

}  // namespace
}  // namespace reeve::testing
