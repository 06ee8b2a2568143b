// Started with others, as a launcher's variables say, by a program that was built without MPI: here
// the program alone, without what lies beside it.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

class Launched : public ::testing::Test {
 protected:
  Launched() {
    std::filesystem::create_directory(folder_.path() / "bin");
    std::filesystem::copy_file(reeve_path(), program());
  }

  std::filesystem::path program() const { return folder_.path() / "bin/reeve"; }
  std::filesystem::path out() const { return folder_.path() / "out"; }

  ProcessResult run(Arguments arguments, const std::map<std::string, std::string>& environment) {
    arguments.insert(arguments.begin(), program().string());
    ProcessOptions options{.directory = folder_.path(), .environment = environment};
    return run_process(arguments, options);
  }

  TemporaryFolder folder_;
};

using Variables = std::map<std::string, std::string>;

TEST_F(Launched, WithoutMpiIsRefused) {
  for (const Variables& launcher :
       {Variables{{"OMPI_COMM_WORLD_SIZE", "2"}, {"OMPI_COMM_WORLD_RANK", "0"}},
        Variables{{"PMI_SIZE", "2"}, {"PMI_RANK", "0"}},
        Variables{{"SLURM_STEP_NUM_TASKS", "2"}, {"PMIX_RANK", "0"}}}) {
    const ProcessResult result = run("explore --out out", launcher);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(
        result.err.starts_with("reeve: started as 2 processes, which would all write the "
                               "same files: this reeve was built without MPI (there is no "))
        << result.err;
    EXPECT_TRUE(result.err.ends_with(
        "install libopenmpi-dev and openmpi-bin and build it with -DREEVE_MPI=ON\n"))
        << result.err;
    EXPECT_FALSE(std::filesystem::exists(out()));
  }
}

// The first one has said it; and a launcher ends all when one of them fails.
TEST_F(Launched, TheOthersKeepQuiet) {
  const Variables second{{"OMPI_COMM_WORLD_SIZE", "2"}, {"OMPI_COMM_WORLD_RANK", "1"}};
  for (const Arguments arguments : {"--version", "explore --help"}) {
    const ProcessResult result = run(arguments, second);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out + result.err, "");
    EXPECT_FALSE(std::filesystem::exists(out()));
  }
}

// After a while, in which the first one would have said it, and all would have been ended.
TEST_F(Launched, OthersReportErrorsThatTheFirstDoesNotHave) {
  const auto start = std::chrono::steady_clock::now();
  const ProcessResult result =
      run("explore --nonsense", {{"OMPI_COMM_WORLD_SIZE", "2"}, {"OMPI_COMM_WORLD_RANK", "1"}});
  EXPECT_GT(std::chrono::steady_clock::now() - start, std::chrono::seconds(4));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.starts_with("reeve: rank 1 of 2, on ")) << result.err;
  EXPECT_TRUE(has(result.err, "--nonsense"));
}

// On a machine where it was built without MPI, while the first one has it: that one would wait.
TEST_F(Launched, AProcessThatCannotReachTheFirstSaysWhy) {
  const ProcessResult result =
      run("explore --out out", {{"OMPI_COMM_WORLD_SIZE", "3"}, {"OMPI_COMM_WORLD_RANK", "2"}});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.out, "");
  EXPECT_TRUE(result.err.starts_with("reeve: rank 2 of 3, on ")) << result.err;
  EXPECT_TRUE(has(result.err, "this reeve was built without MPI"));
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(Launched, AloneOrEachOnItsOwnNeedsNoMpi) {
  const Arguments count("count --fingers 2");
  const std::string expected = reeve(count).out;
  for (const Variables& alone :
       {Variables{{"OMPI_COMM_WORLD_SIZE", "1"}, {"OMPI_COMM_WORLD_RANK", "0"}},
        Variables{
            {"OMPI_COMM_WORLD_SIZE", "2"}, {"OMPI_COMM_WORLD_RANK", "1"}, {"REEVE_MPI", "off"}},
        Variables{{"PMIX_RANK", "1"}}, Variables{{"PMI_SIZE", "two"}, {"PMI_RANK", "0"}}}) {
    const ProcessResult result = run(count, alone);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, expected);
  }
  const ProcessResult result = run(count, {{"REEVE_MPI", "on"}});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "reeve: environment: REEVE_MPI = on: expected off, or nothing\n");
}

}  // namespace
}  // namespace reeve::testing
