// No command writes over what it reads, whatever the files are called.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;

const std::string hardware = "[tube]\nmu = 0.1\n";
const std::string prices = "unit = \"EUR\"\nsheath = 1\n";
const std::string data = "run,routing,motor_tension_N,T1_N\nA,TR1,20,6\n";

struct Case {
  std::string input;  // of that name, with `content`
  std::string content;
  Arguments arguments;
  std::string message;
};

ProcessResult run_in(const TemporaryFolder& folder, const Arguments& arguments) {
  ProcessOptions options{.directory = folder.path()};
  return reeve(arguments, options);
}

void expect_left_as_it_was(const Case& tried) {
  SCOPED_TRACE(tried.arguments.front() + " over " + tried.input);
  const TemporaryFolder folder;
  fs::create_directories((folder.path() / tried.input).parent_path());
  folder.write(tried.input, tried.content);
  const ProcessResult result = run_in(folder, tried.arguments);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(result.out.empty());
  EXPECT_EQ(result.err, "reeve: " + tried.message + ": expected another place\n");
  EXPECT_TRUE(read_text(folder.path() / tried.input) == tried.content);
}

Case over_hardware(const std::string& input, Arguments arguments, const std::string& message) {
  arguments.insert(arguments.end(), {"--hardware", input});
  return {input, hardware, arguments, message + " would be written over the hardware"};
}

TEST(Outputs, NeverReplaceAFileThatAnOptionNames) {
  const std::vector<Case> cases{
      over_hardware("h.toml", {"show", "TR7", "--svg", "h.toml"}, "--svg: 'h.toml'"),
      over_hardware("o/routing.json", {"show", "TR7", "--out", "o"}, "--out 'o': 'o/routing.json'"),
      over_hardware("h.toml", {"export", "TR7", "-o", "h.toml"}, "-o: 'h.toml'"),
      over_hardware("h.toml", {"simulate", "--routings", "TR1", "-o", "./h.toml"},
                    "-o: './h.toml'"),
      over_hardware("h.toml",
                    {"size", "TR1", "--vary", "tip_angle=1..4", "--save-hardware", "h.toml"},
                    "--save-hardware: 'h.toml'"),
      over_hardware("o/sizing.json", {"size", "TR1", "--vary", "tip_angle=1..4", "--out", "o"},
                    "--out 'o': 'o/sizing.json'"),
      over_hardware("o/ranking.json", {"rank", "TR1", "TR7", "--out", "o"},
                    "--out 'o': 'o/ranking.json'"),
      {"o/tradeoff.csv",
       prices,
       {"rank", "TR1", "TR7", "--cost", "o/tradeoff.csv", "--out", "o"},
       "--out 'o': 'o/tradeoff.csv' would be written over the prices"},
      {"o/sweep.csv",
       data,
       {"rank", "TR1", "TR7", "--data", "o/sweep.csv", "--out", "o"},
       "--out 'o': 'o/sweep.csv' would be written over the data"},
      {"o/residuals.csv",
       data,
       {"compare", "o/residuals.csv", "--out", "o"},
       "--out 'o': 'o/residuals.csv' would be written over the data"},
      over_hardware("o/summary.json", {"explore", "--out", "o"}, "--out 'o': 'o/summary.json'"),
      over_hardware("o/shard.json", {"explore", "--out", "o"}, "--out 'o': 'o/shard.json'"),
      over_hardware("o/figures/front.svg", {"explore", "--out", "o"},
                    "--out 'o': 'o/figures/front.svg'"),
      {"o/index.html",
       prices,
       {"explore", "--cost", "o/index.html", "--out", "o"},
       "--out 'o': 'o/index.html' would be written over the prices"},
  };
  for (const Case& tried : cases) expect_left_as_it_was(tried);
}

TEST(Outputs, NeverReplaceTheHardwareFileOfADiagnosis) {
  for (const Arguments& output : {Arguments("--save-model h.toml"), {"--out", "h.toml/.."}}) {
    const TemporaryFolder folder;
    folder.write("h.toml", hardware);
    folder.write("readings.csv", data);
    Arguments command("diagnose readings.csv --hardware h.toml");
    command.insert(command.end(), output.begin(), output.end());
    EXPECT_EQ(run_in(folder, command).exit_code, 2);
    EXPECT_TRUE(read_text(folder.path() / "h.toml") == hardware);
  }
  expect_left_as_it_was({"o/comparison.json",
                         data,
                         {"compare", "o/comparison.json", "--out", "o"},
                         "--out 'o': 'o/comparison.json' would be written over the data"});
}

TEST(Outputs, NeverReplaceEachOther) {
  struct Twice {
    Arguments arguments;
    std::string message;
  };
  const std::vector<Twice> cases{
      {"show TR1 --out o --svg ./o/index.html",
       "--out 'o': 'o/index.html' would be written over the file of --svg"},
      {"show TR1 --out o --svg o/figures/a.svg",
       "--out 'o': 'o/figures/a.svg' would be written over the file of --svg"},
      {"size TR1 --vary tip_angle=1..4 --out o --save-hardware o/sizing.json",
       "--out 'o': 'o/sizing.json' would be written over the file of --save-hardware"},
      {"diagnose readings.csv --out o --save-model o/../o/diagnosis.json",
       "--out 'o': 'o/diagnosis.json' would be written over the file of --save-model"},
  };
  for (const Twice& tried : cases) {
    const TemporaryFolder folder;
    folder.write("readings.csv", data);
    fs::create_directories(folder.path() / "o" / "figures");
    const ProcessResult result = run_in(folder, tried.arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "reeve: " + tried.message + ": expected another place\n");
    EXPECT_FALSE(fs::exists(folder.path() / "o" / "index.html"));
  }
}

TEST(Outputs, NeverReplaceAnInputBehindALink) {
  const TemporaryFolder folder;
  folder.write("h.toml", hardware);
  fs::create_symlink("h.toml", folder.path() / "drawing.svg");
  fs::create_hard_link(folder.path() / "h.toml", folder.path() / "other.svg");
  for (const std::string drawing : {"drawing.svg", "other.svg"}) {
    const ProcessResult result =
        run_in(folder, {"show", "TR7", "--hardware", "h.toml", "--svg", drawing});
    EXPECT_EQ(result.err, "reeve: --svg: '" + drawing +
                              "' would be written over the hardware: expected another place\n");
    EXPECT_TRUE(read_text(folder.path() / "h.toml") == hardware);
  }
}

TEST(Outputs, NeverReplaceAStoreOrTakeItsName) {
  const TemporaryFolder folder;
  const Arguments command("explore --store o/../o/designs.csv --out o");
  const std::string refused =
      "reeve: --out 'o': 'o/designs.csv' would be written over the store: expected another place\n";
  EXPECT_EQ(run_in(folder, command).err, refused);
  EXPECT_EQ(
      run_in(folder, {"explore", "--store", "o/figures", "--out", "o"}).err,
      "reeve: --out 'o': 'o/figures' would be written over the store: expected another place\n");
  EXPECT_FALSE(fs::exists(folder.path() / "o"));
  fs::create_directory(folder.path() / "o");
  ASSERT_EQ(run_in(folder, {"explore", "--store", "o/designs.csv", "--out", "p"}).exit_code, 0);
  const std::string store = read_text(folder.path() / "o" / "designs.csv");
  EXPECT_EQ(run_in(folder, {"explore", "--store", "o/designs.csv", "--out", "o"}).err, refused);
  EXPECT_EQ(run_in(folder, {"merge", "o/designs.csv", "--out", "o"}).exit_code, 2);
  EXPECT_TRUE(read_text(folder.path() / "o" / "designs.csv") == store);
}

TEST(Outputs, NeverReplaceAShardThatIsMerged) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "m");
  const std::vector<Arguments> shards{
      "explore --shard 1/2 --out a",
      {"explore", "--shard", "2/2", "--out", "b", "--store", "m/designs.csv"}};
  for (const Arguments& shard : shards) ASSERT_EQ(run_in(folder, shard).exit_code, 0);
  const std::string store = read_text(folder.path() / "m" / "designs.csv");
  EXPECT_EQ(run_in(folder, {"merge", "a", "m/designs.csv", "--out", "m"}).err,
            "reeve: --out 'm': 'm/designs.csv' would be written over the store: expected another "
            "place\n");
  EXPECT_TRUE(read_text(folder.path() / "m" / "designs.csv") == store);

  fs::create_directory(folder.path() / "n");
  fs::create_symlink("../a/shard.json", folder.path() / "n" / "summary.json");
  const std::string shard = read_text(folder.path() / "a" / "shard.json");
  EXPECT_EQ(run_in(folder, {"merge", "a", "b", "--out", "n"}).exit_code, 2);
  EXPECT_TRUE(read_text(folder.path() / "a" / "shard.json") == shard);
}

TEST(Outputs, MayGoToADevice) {
  const TemporaryFolder folder;
  EXPECT_EQ(
      run_in(folder, {"show", "TR7", "--hardware", "/dev/null", "--svg", "/dev/null"}).exit_code,
      0);
}

}  // namespace
}  // namespace reeve::testing
