// A command line that must be refused, in a folder with good and bad files: exit code 2, one line
// on stderr that names the culprit and what was expected, nothing on stdout, nothing written.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/support/has.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {

struct BadLine {
  Arguments arguments;
  std::string message;  // without "reeve: "; a piece of it is enough
  std::map<std::string, std::string> environment = {};
};

inline std::string text(const Arguments& arguments) {
  std::string line = "reeve";
  for (const std::string& argument : arguments) line += " '" + argument.substr(0, 80) + "'";
  return line;
}

inline std::vector<std::string> everything_in(const std::filesystem::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    names.push_back(entry.path().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

inline void fill(const TemporaryFolder& folder) {
  folder.write("empty.toml", "");
  folder.write("negative.toml", "[tube]\nmu = -0.1\n");
  folder.write("nan.toml", "[tube]\nmu = nan\n");
  folder.write("unknown.toml", "[tube]\nnu = 0.1\n");
  folder.write("type.toml", "[tube]\nmu = \"smooth\"\n");
  folder.write("syntax.toml", "[tube\n");
  folder.write("contact.toml", "[contact.\"a-T9\"]\nmu = 0.2\n");
  folder.write("spool.toml", "[spools]\nb = 0.5\n");
  folder.write("tendon.toml", "[tendon]\nEA_N = 2e4\n[tendon.7]\nstiffness_N_mm = 5\n");
  folder.write("slack.toml", "[tendon]\ntravel_mm = 30\n[tendon.1]\nslack_mm = 5\n");
  folder.write("twice.toml", "[contact.\"T1-T2\"]\nmu = 0.1\n[contact.\"T2-T1\"]\nmu = 0.2\n");
  folder.write("strong.toml", "[contact.\"T2-T1\"]\nmu = 6\n");
  // Blocks are as uncertain as bearings, as a part of their coefficient.
  folder.write("infinite.toml", "[bearing]\nmu = 1e-310\n[block]\nmu = 0.1\n");
  folder.write("cause.toml", "[[effect]]\ncause = \"rust\"\n");
  folder.write("steep.toml", "[sheath]\nmu = 0.1\nangle_rad = 20\n");
  const std::string joints = "joints = [{ arm_mm = 8, range_deg = 90, lever_mm = 60 }]\n";
  folder.write("one_finger.toml", "[finger.1]\nforce_N = 5\n" + joints);
  folder.write("one_finger_more.toml",
               "[finger.1]\nforce_N = 5\n" + joints + "[finger.2]\ntip_mu = 0.1\n");
  folder.write("one_force.toml", "[finger.1]\nforce_N = 5\n[hand]\n" + joints);
  folder.write("bad_force.toml", "[hand]\nforce_N = -1\n" + joints);
  folder.write("bad_joint.toml", "[hand]\nforce_N = 5\njoints = [{ arm_mm = 8 }]\n");
  const std::string joint =
      "[hand]\nforce_N = 5\njoints = [{ arm_mm = 8, range_deg = 90, lever_mm = 60, ";
  folder.write("guide_name.toml", joint + "guide = \"rope\" }]\n");
  folder.write("no_guide.toml", joint + "wrap_deg = 10 }]\n");
  folder.write("guide_mu.toml", joint + "guide = \"tube\", mu = 3 }]\n");
  folder.write("object.toml", joint + "object_deg = 100 }]\n");
  folder.write("wraps.toml", joint + "guide = \"tube\", mu = 1, wrap_deg = 700 }]\n");
  folder.write("vary.toml", "[vary]\ntip_angle = [4, 1]\n");
  folder.write("vary_name.toml", "[vary]\nangle = [1, 4]\n");
  folder.write("vary_finger.toml", "[vary]\n\"tip_angle[3]\" = [1, 4]\n");
  folder.write("vary_same.toml", "[vary]\ntip_angle = [1, 4]\nequal = [\"all\"]\n");
  folder.write("ok.csv", "run,routing,motor_tension_N,T1_N\nA,TR1,20,6\n");
  folder.write("residuals.csv", "run,routing,motor_tension_N,T1_N\nA,TR1,20,6\n");
  folder.write("norun.csv", "routing,motor_tension_N,T1_N\nTR1,20,6\n");
  folder.write("cell.csv", "run,routing,T1_N\nA,TR1,x\n");
  folder.write("empty.csv", "");
  folder.write("tiny.csv", "run,routing,motor_tension_N,T1_N\nA,TR1,20,6\nA,TR1,20,1e-200\n");
  const std::string long_name(10000, 'A');
  folder.write("run.csv", "run,routing,motor_tension_N,T1_N\n" + long_name + ",TR1,20,6\n");
  folder.write("name_of_column.csv", "run,routing,T1_N," + long_name + "\nA,TR1,20,6\n");
  folder.write("log_run.csv", "t,run,T1_N,T2_N\n0," + long_name + ",6,6\n");
  folder.write("nan.csv", "run,routing,motor_tension_N,T1_N\nA,TR1,20,nan\n");
  folder.write("column.csv", "run,routing,motor_tension_N,t0_N\nA,TR1,20,6\n");
  folder.write("name.csv", "run,routing,T1_N\nA,TR9,1\n");
  folder.write("ragged.csv", "run,routing,T1_N\nA,TR1\n");
  folder.write("alone.csv", "run,routing,T1_N\nA,TR1,1\n");
  folder.write("latin1.csv", "run,routing,motor_tension_N,T1_N\nF\xFChrung,TR1,20,6\n");
  folder.write("latin1.toml", "# F\xFChrung\n[tube]\nmu = 0.1\n");
  std::filesystem::create_directory(folder.path() / "no_catalog");
  std::filesystem::create_directory(folder.path() / "explored");
  folder.write("explored/designs.csv", "rank,front,routing,name\n1,1,M-1-T-2-F,TR1\n2,1,M-1-Q,\n");
  std::filesystem::create_directory(folder.path() / "broken_catalog");
  folder.write("broken_catalog/tr1.toml", "name = \n");
}

inline void expect_bad(const BadLine& line) {
  SCOPED_TRACE(text(line.arguments));
  const TemporaryFolder folder;
  fill(folder);
  const std::vector<std::string> before = everything_in(folder.path());
  ProcessOptions options{.directory = folder.path(), .environment = line.environment};
  const ProcessResult result = reeve(line.arguments, options);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  EXPECT_TRUE(result.err.starts_with("reeve: ")) << result.err;
  EXPECT_TRUE(has(result.err, line.message))
      << "  said: " << result.err << "  should: " << line.message;
  EXPECT_LT(result.err.size(), 1000U);
  EXPECT_EQ(everything_in(folder.path()), before);
}

inline void expect_all_bad(const std::vector<BadLine>& lines) {
  for (const BadLine& line : lines) expect_bad(line);
}

}  // namespace reeve::testing
