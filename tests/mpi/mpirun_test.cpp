// `mpirun -n N reeve`: the same bytes as one process, and one clear error where that cannot be.
#include <gtest/gtest.h>
#include <sched.h>

#include <csignal>
#include <fstream>
#include <regex>

#include "numerics/processes.hpp"
#include "tests/integration/stored.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// Hours.
const Arguments long_work{"explore", "--fingers", "9", "--parts", "full", "--top",
                          "50",      "--threads", "1", "--out",   "out"};

class Mpirun : public Stored {
 protected:
  // In a container who runs it may be root, on fewer cores than processes, and without a network.
  ProcessResult together(int size, Arguments arguments, ProcessOptions options = {}) const {
    arguments.insert(arguments.begin(), reeve_path());
    return run_together(size, arguments, std::move(options));
  }

  ProcessResult run_together(int size, const Arguments& program,
                             ProcessOptions options = {}) const {
    Arguments command{REEVE_MPIRUN, "--oversubscribe",   "--mca", "btl", "self,vader",
                      "-n",         std::to_string(size)};
    command.insert(command.end(), program.begin(), program.end());
    options.environment["OMPI_ALLOW_RUN_AS_ROOT"] = "1";
    options.environment["OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"] = "1";
    options.directory = folder_.path();
    options.timeout = std::chrono::seconds(60);
    return run_process(command, options);
  }

  fs::path out() const { return folder_.path() / "out"; }
};

// The processes below it, as the kernel lists them.
std::vector<pid_t> children(pid_t parent) {
  const std::string id = std::to_string(parent);
  std::ifstream list("/proc/" + id + "/task/" + id + "/children");
  std::vector<pid_t> result;
  for (pid_t child = 0; list >> child;) result.push_back(child);
  return result;
}

bool is_rank(pid_t process, int rank) {
  std::ifstream environment("/proc/" + std::to_string(process) + "/environ", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(environment), {}};
  return text.find("OMPI_COMM_WORLD_RANK=" + std::to_string(rank) + '\0') != std::string::npos;
}

std::optional<pid_t> rank_of(const RunningProcess& mpirun, int rank) {
  for (const pid_t child : children(mpirun.id)) {
    if (is_rank(child, rank)) return child;
  }
  return std::nullopt;
}

// Without how long it took.
std::string without_rate(const std::string& text) {
  static const std::regex clock(R"(in [0-9.]+ s:|, [0-9]+ a second)");
  return std::regex_replace(text, clock, "");
}

struct SharedCase {
  const char* name;
  std::vector<int> sizes;
  Arguments arguments;
};

class SharedExploration : public Mpirun, public ::testing::WithParamInterface<SharedCase> {};

TEST_P(SharedExploration, GivesTheBytesOfOneProcess) {
  const Explored whole(GetParam().arguments);
  Arguments arguments{"explore", "--out", "out"};
  arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
  const bool is_json = GetParam().arguments.back() == "json";
  for (const int size : GetParam().sizes) {
    SCOPED_TRACE(size);
    fs::remove_all(out());
    const ProcessResult result = together(size, with_full_parts(arguments));
    EXPECT_EQ(result.exit_code, whole.result.exit_code) << result.err;
    // Of another exit code mpirun has something to say.
    if (result.exit_code == 0) {
      EXPECT_EQ(result.err, "");
    }
    EXPECT_EQ(is_json ? without_times(result.out) : without_rate(result.out),
              is_json ? without_times(whole.result.out) : without_rate(whole.result.out));
    expect_same_below(out(), whole.out());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, SharedExploration,
    ::testing::Values(
        SharedCase{"FourFingers", {1, 2, 3, 4}, {"--fingers", "4", "--top", "40"}},
        SharedCase{
            "BlocksOfAShard",
            {1, 2, 3, 4},
            {"--fingers", "3", "--parts", "all", "--blocks", "1", "--shard", "2/2", "--objectives",
             "uniformity,efficiency,sheaths", "--constraint", "jams<=2", "--format", "json"}},
        SharedCase{"NothingThatMeetsIt", {3}, {"--fingers", "3", "--constraint", "uniformity>=2"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(Mpirun, SaysABadOptionOnce) {
  for (
      const auto& [arguments, message] :
      {std::pair<Arguments, std::string>{
           {"explore", "--fingers", "none"},
           "--fingers: Value 'none': expected a whole number such as 10; see reeve explore --help"},
       {{"explore", "--hardware", "h.toml"}, "h.toml: cannot be read: No such file or directory"},
       {{"explore", "--store", "s.db", "--keep", "all"},
        "--keep 'all': expected best under mpirun, where every design would pass through one "
        "process; --shard with a store for each keeps all"},
       {{"rank", "--catalogue"},
        "started as 3 processes, which would all do the same: only explore can be shared out "
        "(REEVE_MPI=off in the environment: each on its own)"}}) {
    const ProcessResult result = together(3, arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    const std::string line = "reeve: " + message + "\n";
    const std::size_t first = result.err.find(line);
    EXPECT_NE(first, std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("reeve: ", first + 1), std::string::npos) << result.err;
    EXPECT_TRUE(fs::is_empty(folder_.path()));
  }
}

// Of what the first one knows nothing.
TEST_F(Mpirun, SaysTheBadOptionOfOneThatFollows) {
  folder_.write("differs",
                "#!/bin/sh\n[ $OMPI_COMM_WORLD_RANK = 1 ] && set -- \"$@\" --bogus\nexec \"$@\"\n");
  const ProcessResult result =
      run_together(3, {"sh", "differs", reeve_path(), "explore", "--fingers", "3"});
  EXPECT_FALSE(result.timed_out);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.err.find("reeve: rank 1 of 3, on "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find(": explore: unexpected --bogus; see reeve explore --help"),
            std::string::npos)
      << result.err;
}

// The cores that this process may run on.
std::vector<int> cores() {
  cpu_set_t mine;
  CPU_ZERO(&mine);
  ::sched_getaffinity(0, sizeof mine, &mine);
  std::vector<int> result;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    if (CPU_ISSET(core, &mine)) result.push_back(core);
  }
  return result;
}

// Ranks 0 and 1 stand on one core and rank 2 on another, in three processes of this test.
TEST_F(Mpirun, CountsTheProcessesOnTheSameCores) {
  const char* chosen = std::getenv("CORES");
  if (chosen == nullptr) {
    const std::vector<int> mine = cores();
    if (mine.size() < 2) GTEST_SKIP() << "there is but one core";
    ProcessOptions options;
    options.environment["CORES"] = std::to_string(mine.front()) + " " + std::to_string(mine.back());
    const ProcessResult result = run_together(
        3, {fs::read_symlink("/proc/self/exe").string(), "--gtest_filter=Mpirun.Counts*"}, options);
    EXPECT_EQ(result.exit_code, 0) << result.out;
    return;
  }
  std::istringstream numbers(chosen);
  std::vector<int> two(std::istream_iterator<int>(numbers), {});
  const bool is_apart = launch_in_environment().rank == 2;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(two.at(is_apart ? 1 : 0), &one);
  ASSERT_EQ(::sched_setaffinity(0, sizeof one, &one), 0);
  const auto processes = connected_processes(REEVE_MPI_MODULE);
  EXPECT_EQ(processes->sharing_cores(), is_apart ? 1 : 2);
  processes->finish();
}

TEST_F(Mpirun, AloneRunsAnything) {
  EXPECT_EQ(together(1, {"count", "--fingers", "2"}).out, reeve({"count", "--fingers", "2"}).out);
  ProcessOptions options;
  options.environment["REEVE_MPI"] = "off";
  EXPECT_EQ(together(2, {"count", "--fingers", "1"}, options).exit_code, 0);
}

// Its store then goes on, with as many processes as there are.
TEST_F(Mpirun, LosesAProcessWithoutLosingWhatWasKept) {
  Arguments arguments{"explore", "--fingers",     "6", "--parts", "full", "--top",
                      "50",      "--threads",     "1", "--out",   "out",  "--store",
                      "s.db",    "--store-every", "0"};
  ProcessOptions options;
  options.disturbance =
      Disturbance{0, [&](const RunningProcess& mpirun) {
                    const std::optional<pid_t> worker = rank_of(mpirun, 2);
                    return generated() > 0 && worker && ::kill(*worker, SIGKILL) == 0;
                  }};
  const ProcessResult killed = together(3, arguments, options);
  EXPECT_FALSE(killed.timed_out);
  EXPECT_EQ(killed.exit_code, 128 + SIGKILL);
  EXPECT_NE(killed.err.find("rank 2 with PID"), std::string::npos) << killed.err;
  EXPECT_EQ(killed.out, "");
  EXPECT_TRUE(fs::is_empty(out()));
  const std::uint64_t kept = generated();
  EXPECT_GT(kept, 0U);

  const ProcessResult resumed = together(2, arguments);
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  expect_same_below(out(), Explored({"--fingers", "6", "--top", "50"}).out());
}

TEST_F(Mpirun, EndsWithWhatItHasAtASignalThatIsPassedOn) {
  ProcessOptions options;
  options.disturbance =
      Disturbance{SIGUSR1, [since = std::optional<std::chrono::steady_clock::time_point>()](
                               const RunningProcess& mpirun) mutable {
                    const auto now = std::chrono::steady_clock::now();
                    const std::optional<pid_t> first = rank_of(mpirun, 0);
                    if (!since && first && catches(*first, SIGUSR1)) since = now;
                    return since && now - *since > 500ms;
                  }};
  const ProcessResult result = together(2, long_work, options);
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_NE(result.out.find("\nPARTIAL: "), std::string::npos) << result.out;
  const Json summary = Json::parse(read_text(out() / "summary.json"));
  EXPECT_TRUE(summary["partial"]);
  EXPECT_GT(summary["generated"], 0);
}

// mpirun asks its processes to end, and soon kills them.
TEST_F(Mpirun, ThatIsInterruptedLeavesNoFiles) {
  ProcessOptions options;
  options.disturbance = Disturbance{SIGINT, [](const RunningProcess& mpirun) {
                                      const std::optional<pid_t> first = rank_of(mpirun, 0);
                                      return first && catches(*first, SIGUSR1);
                                    }};
  const ProcessResult result = together(2, long_work, options);
  EXPECT_FALSE(result.timed_out);
  EXPECT_NE(result.exit_code, 0);
  EXPECT_TRUE(fs::is_empty(out()));
}

}  // namespace
}  // namespace reeve::testing
