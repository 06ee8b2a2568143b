// Out of memory: wherever it happens, one message, exit code 3, and no piece of a file.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;

constexpr const char* no_memory = "reeve: not enough memory\n";
constexpr const char* no_threads =
    "reeve: no more threads: not enough memory, or too many threads\n";

struct Starved {
  const char* name;
  Arguments command;
  const char* large = "16000";  // bytes
};

class OutOfMemory : public ::testing::TestWithParam<Starved> {
 protected:
  void SetUp() override {
    // It would be asked past the failing malloc; the release build runs these tests.
    if (has_sanitizer()) GTEST_SKIP() << "sanitizers have an allocator of their own";
    run({});
    ASSERT_EQ(result_.exit_code, 0) << result_.err;
    whole_ = files_below(folder_.path() / "out");
    ASSERT_FALSE(whole_.empty());
  }

  void run(const std::map<std::string, std::string>& environment) {
    fs::remove_all(folder_.path() / "out");
    ProcessOptions options{.directory = folder_.path(),
                           .environment = environment,
                           .timeout = std::chrono::seconds(60)};
    result_ = reeve(GetParam().command, options);
  }

  void expect_a_clean_end() {
    EXPECT_FALSE(result_.timed_out);
    EXPECT_EQ(result_.signal, 0);
    EXPECT_EQ(result_.err, result_.exit_code == 0 ? "" : no_memory);
    EXPECT_TRUE(result_.exit_code == 0 || result_.exit_code == 3) << result_.exit_code;
    for (const auto& [name, text] : files_below(folder_.path() / "out")) {
      ASSERT_TRUE(whole_.contains(name)) << name;
      EXPECT_TRUE(text == whole_.at(name)) << name;
    }
  }

  TemporaryFolder folder_;
  ProcessResult result_;
  std::map<std::string, std::string> whole_;
};

// A single one can be done without, as some of the runtime library; so many in a row are behind the
// last.
constexpr int enough_without_harm = 5;

// The first ones one by one, before main and in it; then ever more sparsely.
std::vector<long> calls(long most) {
  std::vector<long> list;
  for (long n = 1; n < most; n = n < 12 ? n + 1 : n + n / 10) list.push_back(n);
  return list;
}

TEST_P(OutOfMemory, AtAnyAllocationEndsWithAMessage) {
  for (const bool all_that_follow : {false, true}) {
    int starved = 0;
    int unharmed = 0;
    for (const long n : calls(2'000'000)) {
      SCOPED_TRACE(n);
      std::map<std::string, std::string> environment{{"LD_PRELOAD", REEVE_FAILING_MALLOC},
                                                     {"FAIL_AT", std::to_string(n)}};
      if (all_that_follow) environment["FAIL_ON"] = "1";
      run(environment);
      expect_a_clean_end();
      starved += result_.exit_code == 3 ? 1 : 0;
      if (HasFailure()) return;
      unharmed = result_.exit_code == 0 ? unharmed + 1 : 0;
      if (unharmed == enough_without_harm) break;
    }
    EXPECT_GT(starved, 50);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, OutOfMemory,
    ::testing::Values(
        Starved{"Show", {"show", "TR5", "--out", "out"}},
        Starved{"Rank", {"rank", "TR1", "TR5", "--distribution-mu", "0.18", "--out", "out"}},
        Starved{"Explore", {"explore", "--parts", "full", "--threads", "2", "--out", "out"}},
        Starved{"Diagnose", {"diagnose", readings, "--threads", "2", "--out", "out"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

class OutOfLargeMemory : public OutOfMemory {};

// There are so few of them that each can fail once.
TEST_P(OutOfLargeMemory, AtAnyAllocationEndsWithAMessage) {
  int starved = 0;
  int unharmed = 0;
  for (long n = 1; n < 400 && unharmed < enough_without_harm; ++n) {
    SCOPED_TRACE(n);
    run({{"LD_PRELOAD", REEVE_FAILING_MALLOC},
         {"FAIL_ABOVE", GetParam().large},
         {"FAIL_AT", std::to_string(n)}});
    expect_a_clean_end();
    if (HasFailure()) return;
    starved += result_.exit_code == 3 ? 1 : 0;
    unharmed = result_.exit_code == 0 ? unharmed + 1 : 0;
  }
  EXPECT_GT(starved, 5);
}

INSTANTIATE_TEST_SUITE_P(
    Of, OutOfLargeMemory,
    ::testing::Values(Starved{"Show", {"show", "TR5", "--out", "out"}},
                      // Its archive is thinned out again and again.
                      Starved{"Explore",
                              {"explore", "--fingers", "4", "--parts", "full", "--top", "10",
                               "--threads", "2", "--out", "out"},
                              "100000"},
                      Starved{"Diagnose",
                              {"diagnose", readings, "--threads", "2", "--out", "out"}}),
    [](const auto& tested) { return std::string(tested.param.name); });

// SQLite asks for a page and what goes with it, and says in its own way that there is no memory.
TEST(OutOfMemoryInAStore, EndsWithAMessage) {
  if (has_sanitizer()) GTEST_SKIP() << "sanitizers have an allocator of their own";
  const TemporaryFolder folder;
  ProcessOptions options{.directory = folder.path()};
  const Arguments explore("explore --threads 1 --out out --store s.db");
  ASSERT_EQ(reeve(explore, options).exit_code, 0);
  for (const Arguments& command : {explore, Arguments("rank --store s.db")}) {
    int starved = 0;
    int unharmed = 0;
    for (int n = 1; n < 140 && unharmed < enough_without_harm; ++n) {
      SCOPED_TRACE(command[0] + std::to_string(n));
      options.environment = {{"LD_PRELOAD", REEVE_FAILING_MALLOC},
                             {"FAIL_ABOVE", "4000"},
                             {"FAIL_AT", std::to_string(n)}};
      const ProcessResult result = reeve(command, options);
      EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 3) << result.exit_code;
      EXPECT_EQ(result.err, result.exit_code == 0 ? "" : no_memory);
      starved += result.exit_code == 3 ? 1 : 0;
      unharmed = result.exit_code == 0 ? unharmed + 1 : 0;
    }
    EXPECT_GT(starved, 20);
  }
}

// As `ulimit -v` has it.
TEST(MemoryLimit, IsSaidToBeReached) {
  // Terabytes of address space, so that nothing would start; the release build runs this test.
  if (has_sanitizer()) GTEST_SKIP() << "sanitizers reserve more than any limit";
  int starved = 0;
  int unharmed = 0;
  for (int limit_kB = 20000; limit_kB <= 80000 && unharmed < 2; limit_kB += 6000) {
    SCOPED_TRACE(limit_kB);
    const TemporaryFolder folder;
    const std::string out = (folder.path() / "out").string();
    const auto limited = [&](const std::string& arguments) {
      return run_process({"bash", "-c",
                          "ulimit -v " + std::to_string(limit_kB) + "; exec \"$0\" " + arguments,
                          reeve_path(), out});
    };
    if (limited("--version").exit_code != 0) continue;  // not enough to load it
    const ProcessResult result = limited("explore --fingers 5 --threads 4 --out \"$1\"");
    EXPECT_EQ(result.signal, 0);
    EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 3) << result.exit_code;
    const bool of_threads = result.err == no_threads;
    EXPECT_EQ(result.err, result.exit_code == 0 ? "" : of_threads ? no_threads : no_memory);
    if (result.exit_code == 3) {
      EXPECT_TRUE(files_below(out).empty());
    }
    starved += result.exit_code == 3 ? 1 : 0;
    unharmed = result.exit_code == 0 ? unharmed + 1 : 0;
  }
  EXPECT_GT(starved, 0);
}

}  // namespace
}  // namespace reeve::testing
