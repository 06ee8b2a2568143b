// Stopped, killed, or out of space: what is there is whole, and says what it is.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

using namespace std::chrono_literals;

// Hours of work.
const Arguments long_work("--fingers 9 --parts full --threads 2 --top 100");
// Half a megabyte of designs and more of summary.
const Arguments long_files("--fingers 4 --parts full --top 10000");

void expect_whole_csv(const std::string& csv, const std::string& first_line) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_TRUE(line.starts_with(first_line)) << line;
  std::getline(lines, line);
  EXPECT_TRUE(line.starts_with("rank,front,routing,name,")) << line;
  const auto columns = std::count(line.begin(), line.end(), ',');
  while (std::getline(lines, line)) EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
  EXPECT_TRUE(csv.ends_with('\n'));
}

class StoppingSignal : public ::testing::TestWithParam<int> {};

TEST_P(StoppingSignal, EndsAnExplorationWithWholeFilesThatSayPartial) {
  const Explored explored(long_work, disturbed(GetParam(), after_it_catches(GetParam(), 1s)));
  ASSERT_FALSE(explored.result.timed_out);
  EXPECT_EQ(explored.result.signal, 0);
  EXPECT_EQ(explored.result.exit_code, 3);
  EXPECT_EQ(explored.result.err, "");
  EXPECT_TRUE(has(explored.result.out, "\nPARTIAL: "));
  EXPECT_EQ(explored.files(),
            (Arguments(
                "designs.csv figures index.html pareto.csv sample.csv summary.json tradeoff.csv")));

  const Json summary = explored.summary();
  EXPECT_TRUE(summary["partial"]);
  EXPECT_GT(summary["generated"], 0);
  EXPECT_LT(summary["generated"], summary["total"]);
  EXPECT_EQ(summary["evaluated"].get<std::uint64_t>() +
                summary["rejected"]["not actuated"].get<std::uint64_t>(),
            summary["generated"]);
  expect_whole_csv(explored.file("designs.csv"), "# partial: stopped after ");
  expect_whole_csv(explored.file("pareto.csv"), "# partial: stopped after ");
  EXPECT_TRUE(has(explored.file("index.html"), "This exploration is partial: stopped after "));
  EXPECT_EQ(words(explored.file("designs.csv")).size(), summary["top"].size());
}

INSTANTIATE_TEST_SUITE_P(Signals, StoppingSignal, ::testing::Values(SIGINT, SIGTERM, SIGHUP),
                         [](const auto& tested) {
                           return std::string(tested.param == SIGINT    ? "Interrupt"
                                              : tested.param == SIGTERM ? "Terminate"
                                                                        : "HangUp");
                         });

// A first signal when the process catches it, and the disturbance's that much later.
ProcessOptions told_twice(int signal, std::chrono::milliseconds apart) {
  const auto since = std::make_shared<std::optional<std::chrono::steady_clock::time_point>>();
  return disturbed(signal, [=](const RunningProcess& process) {
    const auto now = std::chrono::steady_clock::now();
    if (!*since && catches(process.id, signal)) {
      ::kill(process.id, signal);
      *since = now;
    }
    return *since && now - **since >= apart;
  });
}

// The kernel and a shell each hang up when a terminal is closed, and timeout(1) terminates its
// child and the child's group.
TEST(EndingSignal, TwiceAtOnceCountsOnce) {
  for (const int signal : {SIGHUP, SIGTERM}) {
    const Explored explored(long_work, told_twice(signal, 1ms));
    EXPECT_EQ(explored.result.signal, 0);
    EXPECT_EQ(explored.result.exit_code, 3);
    EXPECT_TRUE(explored.summary()["partial"]);
  }
}

// A reader that has opened a pipe and does not read it holds the page up.
TEST(HangUp, AgainLaterEndsTheProcess) {
  Explored explored("--fingers 2");
  const std::filesystem::path pipe = explored.out() / "index.html";
  std::filesystem::remove(pipe);
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  explored.run("--fingers 2", told_twice(SIGHUP, 1500ms));
  EXPECT_EQ(explored.result.signal, SIGHUP);
  ::close(reader);
}

// The wait for an input, too, of which a writer may never come or never write.
TEST_P(StoppingSignal, EndsTheWaitForAnInput) {
  TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const bool has_writer : {false, true}) {
    const int writer = has_writer ? ::open(pipe.c_str(), O_RDWR) : -1;
    for (const char* command : {"diagnose pipe", "import pipe --routing TR5"}) {
      ProcessOptions options = disturbed(GetParam(), after_it_catches(GetParam(), 0ms));
      options.directory = folder.path();
      const ProcessResult result = reeve(command, options);
      EXPECT_EQ(result.exit_code, 3) << command << has_writer;
      EXPECT_TRUE(has(result.err, "interrupted: nobody writes to 'pipe'"));
    }
    if (has_writer) ::close(writer);
  }
}

TEST(HangUp, UnderNohupIsIgnored) {
  TemporaryFolder folder;
  ProcessOptions options = disturbed(SIGHUP, after_it_catches(SIGINT, 0ms));
  options.directory = folder.path();
  const ProcessResult result = run_process(
      {"bash", "-c", "trap '' HUP; exec \"$0\" explore --fingers 5 --out out", reeve_path()},
      options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_FALSE(Json::parse(read_text(folder.path() / "out/summary.json"))["partial"]);
}

// Its output goes nowhere then, neither the progress line nor the table.
TEST(HangUp, OfTheTerminalLeavesWholeFilesThatSayPartial) {
  ProcessOptions options = disturbed(0, [](const RunningProcess& process) {
    return process.err.find(" s left") != std::string::npos;
  });
  options.stderr_is_terminal = true;
  options.stdout_terminal_width = 80;
  options.environment["TERM"] = "xterm";
  const Explored explored(long_work, options);
  EXPECT_EQ(explored.result.signal, 0);
  EXPECT_EQ(explored.result.exit_code, 3);
  EXPECT_TRUE(explored.summary()["partial"]);
  expect_whole_csv(explored.file("designs.csv"), "# partial: stopped after ");
}

TEST(Interruption, EndsAnImportWithoutAFile) {
  const TemporaryFolder folder;
  std::string log = "t_ms,position_mm,T1_N,T2_N\n";
  for (int i = 0; i < 400'000; ++i) log += std::to_string(10 * i) + ",1,2.5,3.5\n";
  folder.write("log.csv", log);
  ProcessOptions options = disturbed(SIGINT, after_it_catches(SIGINT, 20ms));
  options.directory = folder.path();
  const ProcessResult result = reeve("import log.csv --routing TR5 -o readings.csv", options);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, "reeve: interrupted\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "readings.csv"));
}

TEST(Interruption, EndsARankingUnderUncertaintyWithoutAResult) {
  const ProcessResult result =
      reeve("rank --catalogue --uncertainty --draws 100000 --threads 1 --grasps none/1/2/1,2",
            disturbed(SIGINT, after_it_catches(SIGINT, 50ms)));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "reeve: interrupted\n");
}

// The exploration is done by then, the distributions are not.
TEST(Interruption, WhileDrawingLeavesFilesThatSaySo) {
  const Explored explored("--fingers 4 --uncertainty --draws 100000 --threads 1",
                          disturbed(SIGINT, after_it_catches(SIGINT, 2s)));
  EXPECT_EQ(explored.result.exit_code, 3);
  EXPECT_TRUE(has(explored.result.out, "PARTIAL"));
  EXPECT_TRUE(explored.summary()["partial"]);
  EXPECT_TRUE(explored.file("designs.csv").starts_with("# partial"));
}

TEST(Killing, WhileExploringLeavesNoFile) {
  const Explored explored(long_work, disturbed(SIGKILL, after_it_catches(SIGINT, 300ms)));
  EXPECT_EQ(explored.result.signal, SIGKILL);
  EXPECT_EQ(explored.files(), Arguments{});
}

TEST(Killing, WhileWritingLeavesNoPieceUnderAFinalName) {
  const Explored whole(long_files);
  const std::filesystem::path out = "out";
  for (const char* file : {"designs.csv", "summary.json"}) {
    SCOPED_TRACE(file);
    TemporaryFolder folder;
    ProcessOptions options = disturbed(SIGKILL, [&](const RunningProcess&) {
      std::error_code ignored;
      for (const auto& entry :
           std::filesystem::directory_iterator(folder.path() / "out", ignored)) {
        if (entry.path().filename().string().starts_with(std::string(file) + '.')) return true;
      }
      return false;
    });
    options.directory = folder.path();
    Arguments arguments("explore --out out");
    arguments.insert(arguments.end(), long_files.begin(), long_files.end());
    reeve(arguments, options);
    for (const char* name : {"designs.csv", "pareto.csv"}) {
      if (!std::filesystem::exists(folder.path() / out / name)) continue;
      EXPECT_EQ(read_text(folder.path() / out / name), whole.file(name));
    }
    if (std::filesystem::exists(folder.path() / out / "summary.json")) {
      EXPECT_EQ(without_times(read_text(folder.path() / out / "summary.json")),
                without_times(whole.file("summary.json")));
    }
  }
}

// The kernel kills it in the middle of a file, every time.
TEST(Killing, InTheMiddleOfAFileLeavesTheOlderFilesAsTheyWere) {
  Explored explored("--fingers 2");
  const std::string designs = explored.file("designs.csv");
  const std::string summary = explored.file("summary.json");
  ProcessOptions options{.file_size_limit = 64 * 1024, .dies_at_file_size_limit = true};
  explored.run(long_files, options);
  ASSERT_EQ(explored.result.signal, SIGXFSZ);
  EXPECT_EQ(explored.file("designs.csv"), designs);
  EXPECT_EQ(explored.file("summary.json"), summary);
}

// All are written before one gets its name.
TEST(Killing, InTheMiddleOfALateFileLeavesNone) {
  ProcessOptions options{.file_size_limit = 1024 * 1024, .dies_at_file_size_limit = true};
  const Explored killed(long_files, options);
  ASSERT_EQ(killed.result.signal, SIGXFSZ);
  EXPECT_TRUE(std::filesystem::exists(killed.out() / "figures"));
  for (const std::string& name : killed.files()) {
    EXPECT_TRUE(name == "figures" || name.ends_with(".tmp")) << name;
  }
}

// A pipe that nobody reads holds it up behind the tables.
TEST(Killing, BetweenTwoFilesLeavesAFolderThatIsKnownToBeHalfDone) {
  Explored explored("--fingers 2");
  const std::string designs = explored.file("designs.csv");
  std::filesystem::remove(explored.out() / "index.html");
  ASSERT_EQ(::mkfifo((explored.out() / "index.html").c_str(), 0600), 0);
  explored.run("--fingers 3", disturbed(SIGKILL, [&](const RunningProcess&) {
                 const std::string now = explored.file("designs.csv");
                 return !now.empty() && now != designs;
               }));
  ASSERT_EQ(explored.result.signal, SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(explored.out() / "summary.json"));
  std::filesystem::remove(explored.out() / "index.html");
  const ProcessResult read =
      reeve({"size", "--from", explored.out().string(), "--vary", "tip_angle=1..4"});
  EXPECT_EQ(read.exit_code, 2);
  EXPECT_TRUE(has(read.err, "there is no summary.json, which is written last"));
}

// The page of what is sized would go, and the folder could not be read again.
TEST(MixedFolder, IsNotMadeBySizingIntoTheFolderThatIsSized) {
  const Explored explored("--fingers 2");
  const ProcessResult size = reeve({"size", "--from", explored.out().string(), "--vary",
                                    "tip_angle=1..4", "--out", explored.out().string()});
  EXPECT_EQ(size.exit_code, 2);
  EXPECT_TRUE(has(size.err, "designs.csv' would be written over what is sized"));
}

TEST(MixedFolder, IsNotMadeByAnotherCommand) {
  const Explored explored("--fingers 2");
  EXPECT_EQ(reeve({"show", "TR5", "--out", explored.out().string()}).exit_code, 0);
  EXPECT_EQ(explored.files(), (Arguments{"figures", "index.html", "routing.json"}));
  EXPECT_FALSE(std::filesystem::exists(explored.out() / "figures/pareto.svg"));
}

TEST(MixedFolder, IsKnownByTheIdsOfItsFiles) {
  const Explored two("--fingers 2");
  const Explored three("--fingers 3");
  const Arguments size{"size",  "--from", two.out().string(), "--vary", "tip_angle=1..4",
                       "--top", "1",      "--nominal"};
  EXPECT_EQ(reeve(size).exit_code, 0);
  for (const char* name :
       {"designs.csv", "pareto.csv", "sample.csv", "tradeoff.csv", "index.html"}) {
    SCOPED_TRACE(name);
    const std::string own = two.file(name);
    two.folder.write(std::string("out/") + name, three.file(name));
    const ProcessResult read = reeve(size);
    EXPECT_EQ(read.exit_code, 2);
    EXPECT_TRUE(has(read.err, std::string(name) + " and summary.json are of two explorations"));
    two.folder.write(std::string("out/") + name, own);
  }
}

// Whatever decides what is found, and nothing else.
TEST(ExplorationId, DependsOnWhatDecidesTheDesignsAlone) {
  const auto id = [](const Arguments& arguments) {
    return Explored(arguments).summary()["exploration"].get<std::string>();
  };
  const std::string plain = id({});
  EXPECT_EQ(plain.size(), 16U);
  EXPECT_EQ(id({"--threads", "1", "--details", "2"}), plain);
  EXPECT_EQ(id({"--fingers", "2", "--constraint", "jams<=9"}), id({"--constraint", "jams<=9"}));
  for (const Arguments& other :
       {Arguments("--fingers 3"), Arguments("--top 999"), Arguments("--shard 1/2"),
        Arguments("--grasps none"), Arguments("--constraint jams<=9"),
        Arguments("--uncertainty --draws 2"), Arguments("--tradeoff parts"),
        Arguments{"--hardware", REEVE_CATALOG_DIR "/hardware/example.toml"}}) {
    EXPECT_NE(id(other), plain) << other[0];
  }
}

TEST(FullDisk, IsReportedWithTheFileAndLeavesNoPiece) {
  ProcessOptions options{.file_size_limit = 64 * 1024};
  const Explored explored(long_files, options);
  EXPECT_EQ(explored.result.exit_code, 2);
  EXPECT_EQ(explored.result.err,
            "reeve: file 'out/designs.csv' cannot be written: File too large\n");
  EXPECT_EQ(explored.files(), Arguments{});
}

}  // namespace
}  // namespace reeve::testing
