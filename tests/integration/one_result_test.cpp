// A folder of --out over that of an earlier run: whatever ends the writing, the files are of the
// earlier result or of the new one, and have its stamp.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "reports/output/stamp.hpp"
#include "tests/integration/explored.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

struct Rewritten {
  const char* name;
  Arguments before;
  Arguments after;
  const char* last;  // of the files, which says that all are there
};

const std::string golden_folder = std::string(REEVE_SOURCE_DIR) + "/tests/golden/";
const std::string other_hardware = REEVE_CATALOG_DIR "/hardware/example.toml";

std::vector<Rewritten> rewritten() {
  return {
      {"Show", {"show", "TR5", "--held", "1"}, {"show", "TR7"}, "routing.json"},
      {"Rank",
       {"rank", "TR1", "TR5", "--distribution-mu", "0.18", "--sweep", "tube_mu=0.1..0.2"},
       {"rank", "TR1", "TR7", "--distribution-mu", "0.18"},
       "ranking.json"},
      {"Size",
       {"size", "TR5", "--vary", "sheath_angle=3..9", "--nominal"},
       {"size", "TR7", "--vary", "tip_angle=1..4", "--nominal"},
       "sizing.json"},
      {"Compare",
       {"compare", readings},
       {"compare", readings, "--hardware", other_hardware},
       "comparison.json"},
      {"Diagnose",
       {"diagnose", golden_folder + "diagnose_cause.csv", "--alpha", "0.1", "--replicates", "99"},
       {"diagnose", readings, "--alpha", "0.1", "--replicates", "99"},
       "diagnosis.json"},
      {"Explore",
       {"explore", "--fingers", "2", "--sweep", "tube_mu=0.1..0.2", "--shard", "1/2"},
       {"explore", "--fingers", "2", "--parts", "paper"},
       "summary.json"}};
}

bool is_temporary(const fs::path& file) { return file.extension() == ".tmp"; }

class OneResult : public ::testing::TestWithParam<Rewritten> {
 protected:
  void SetUp() override {
    run(GetParam().before);
    before_ = files();
    fs::copy(out(), folder_.path() / "kept", fs::copy_options::recursive);
    run(GetParam().after);
    after_ = files();
  }

  fs::path out() const { return folder_.path() / "out"; }

  ProcessResult run(Arguments arguments,
                    const std::map<std::string, std::string>& environment = {}) {
    arguments.insert(arguments.end(), {"--out", "out"});
    ProcessOptions options{.directory = folder_.path(), .environment = environment};
    return reeve(arguments, options);
  }

  // The later run, over what the earlier one left.
  ProcessResult run_again(const char* disturbance, int place) {
    fs::remove_all(out());
    fs::copy(folder_.path() / "kept", out(), fs::copy_options::recursive);
    return run(GetParam().after,
               {{"LD_PRELOAD", REEVE_FAILING_FILES}, {disturbance, std::to_string(place)}});
  }

  Files files() const {
    Files found = files_below(out());
    std::erase_if(found, [](const auto& file) { return is_temporary(file.first); });
    return found;
  }

  bool has_temporary_files() const { return files() != files_below(out()); }

  void expect_files_of_one_result() const {
    const Files found = files();
    std::string old_ones;
    std::string new_ones;
    for (const auto& [name, text] : found) {
      const bool is_old = before_.contains(name) && before_.at(name) == text;
      const bool is_new = after_.contains(name) && after_.at(name) == text;
      EXPECT_TRUE(is_old || is_new) << name;
      if (!is_new) old_ones += name + ' ';
      if (!is_old) new_ones += name + ' ';
    }
    EXPECT_TRUE(old_ones.empty() || new_ones.empty()) << old_ones << "beside " << new_ones;
    if (found.contains(GetParam().last)) {
      EXPECT_TRUE(found == before_ || found == after_) << GetParam().last;
    }
  }

  TemporaryFolder folder_;
  Files before_;
  Files after_;
};

std::set<std::string> ids(const Files& files) {
  std::set<std::string> found;
  for (const auto& [name, text] : files) {
    const std::string extension = fs::path(name).extension();
    if (extension == ".txt" || extension.empty()) continue;
    const std::string kind = files.contains("summary.json") ? exploration_kind : result_kind;
    found.insert(reports::id_in(name, text, kind));
  }
  return found;
}

TEST_P(OneResult, HasOneStampInAllItsFiles) {
  EXPECT_EQ(ids(before_).size(), 1U);
  EXPECT_EQ(ids(after_).size(), 1U);
  EXPECT_EQ(ids(before_).begin()->size(), 16U);
  EXPECT_NE(ids(before_), ids(after_));
  run(GetParam().before);
  EXPECT_EQ(files(), before_);
}

TEST_P(OneResult, IsTheEarlierOrTheNewOneOnAFullDisk) {
  if (has_sanitizer()) GTEST_SKIP() << "nothing is loaded before sanitizers; release runs it";
  int place = 1;
  for (; run_again("FULL_AT", place).exit_code == 2; ++place) {
    SCOPED_TRACE(place);
    expect_files_of_one_result();
    EXPECT_FALSE(has_temporary_files());
    if (HasFailure()) return;
  }
  EXPECT_GT(place, 2 * 2);
  EXPECT_EQ(files(), after_);
}

TEST_P(OneResult, IsTheEarlierOrTheNewOneAfterAKill) {
  if (has_sanitizer()) GTEST_SKIP() << "nothing is loaded before sanitizers; release runs it";
  int place = 1;
  for (; run_again("KILL_AT", place).signal == SIGKILL; ++place) {
    SCOPED_TRACE(place);
    expect_files_of_one_result();
    run(GetParam().after);
    EXPECT_EQ(files(), after_);
    if (HasFailure()) return;
  }
  EXPECT_GT(place, 2 * 3);
}

INSTANTIATE_TEST_SUITE_P(Of, OneResult, ::testing::ValuesIn(rewritten()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace reeve::testing
