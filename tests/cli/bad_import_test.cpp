// Logs and options that `import` refuses, and nothing is written.
#include <gtest/gtest.h>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {
namespace {

// A log beside the files of bad_line.hpp.
void expect_refused(const std::string& log, Arguments options, const std::string& message) {
  SCOPED_TRACE(log);
  const TemporaryFolder folder;
  folder.write("log.csv", log);
  const std::vector<std::string> before = everything_in(folder.path());
  ProcessOptions process{.directory = folder.path()};
  Arguments arguments("import log.csv");
  arguments.insert(arguments.end(), options.begin(), options.end());
  const ProcessResult result = reeve(arguments, process);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "reeve: " + message + "\n");
  EXPECT_EQ(everything_in(folder.path()), before);
}

const std::string plain = "t,motor_tension_N,T1_N\n0,20,6\n1,20,6\n";

TEST(BadImport, NamesAnOptionThatItCannotTake) {
  expect_all_bad({
      {"import", "log is required"},
      {"import none.csv", "none.csv: cannot be read: No such file or directory"},
      {"import empty.csv", "empty.csv: is empty: expected a header and rows below it"},
      {"import ok.csv", "ok.csv:1: the header has no column of time: expected one of "},
      {"import ok.csv --min-duration 0", "--min-duration"},
      {"import ok.csv --tolerance 2", "--tolerance"},
      {"import ok.csv --readings-per-stroke 0", "--readings-per-stroke"},
      {"import ok.csv --direction back", "--direction"},
      {"import ok.csv -o ok.csv", "would be written over the data"},
      {"import ok.csv --plot ok.csv", "would be written over the data"},
      {"import ok.csv -o a.csv --plot ./a.csv",
       "--plot: './a.csv' would be written over the file of -o: expected another place"},
      {"import ''", "log: Value '': expected a file or folder"},
      {"import ok.csv -o none/readings.csv", "-o 'none/readings.csv': expected a file that"},
      {"import ok.csv -o no_catalog", "-o 'no_catalog': expected the name of a file"},
  });
}

TEST(BadImport, NamesAnImpossibleLabel) {
  expect_refused(plain, {"-o", "readings.csv"},
                 "log.csv:1: the header has no column 'routing': expected a routing such as "
                 "M-1-T-2-F in each row, or given by --routing");
  expect_refused(
      plain, {"--routing", "TR1", "--held", "3"},
      "--held '3': expected nothing (none held), or finger numbers from 1 to 2, each once, such as "
      "1;2");
  expect_refused(plain, {"--routing", "TR1", "--run", ""},
                 "--run '': expected a name or number for the run");
  expect_refused(plain, {"--routing", "TR1", "--run", "Tare"},
                 "--run 'Tare': expected another name: a row of that run holds the sensors' zeros");
  expect_refused("t,routing,motor_tension_N,T1_N\n0,TR1,20,6\n1,TR,20,6\n", {"--routing", "TR1"},
                 "log.csv: the log has a column 'routing', and 'TR1' is given too: expected one of "
                 "them");
  expect_refused("t,routing,motor_tension_N,T1_N\n0,TR1,20,6\n1,,20,6\n", {},
                 "log.csv:3: column 'routing' = '': expected a routing such as M-1-T-2-F, in a "
                 "column of the log or given");
  expect_refused(plain, {"--routing", "TR1", "--map", "T1_N=T1", "--map", "T1_N=T2"},
                 "log.csv:1: column 3 'T1_N': expected one meaning, and 2 are given");
  expect_refused("t,direction,motor_tension_N,T1_N\n0,,20,6\n1,up,20,6\n", {"--routing", "TR1"},
                 "log.csv:3: column 'direction' = 'up': expected pull, release, or an empty cell");
  expect_refused("t,motor_tension_N,T5_N\n0,20,\n1,20,6\n", {"--routing", "TR1"},
                 "log.csv:3: column 'T5_N': the routing 'TR1' has no segment T5: expected an empty "
                 "cell");
}

TEST(BadImport, ListsAllImpossibleLabels) {
  expect_refused(
      "t,run,routing,held,direction,motor_tension_N,T1_N,T5_N\n0,A,TR1,3,,20,6,\n"
      "1,,TR1,,up,20,6,\n2,B,TR1,,,20,6,1\n",
      {},
      "log.csv: 4 faults:\n"
      "  log.csv:2: column 'held' = '3': expected nothing (none held), or finger numbers from 1 "
      "to 2, each once, such as 1;2\n"
      "  log.csv:3: column 'run' = '': expected a name or number for the run\n"
      "  log.csv:3: column 'direction' = 'up': expected pull, release, or an empty cell\n"
      "  log.csv:4: column 'T5_N': the routing 'TR1' has no segment T5: expected an empty cell");
}

TEST(BadImport, ListsAllMissingColumnsAndPointsToAMapping) {
  expect_refused("Zeit [s];Kraft 1 [N]\n0;6\n1;6\n", {},
                 "log.csv: 3 faults:\n"
                 "  log.csv:1: the header has no column of time: expected one of time_s, t_s, t, "
                 "time, timestamp (seconds), time_ms and t_ms; it has 'Zeit [s]', 'Kraft 1 [N]'; "
                 "name it with --map 'COLUMN=time_s'; --guess proposes a meaning for "
                 "each column\n"
                 "  log.csv:1: the header has no column of tensions: expected motor_tension_N and "
                 "at least one such as T1_N (strand), Ta_N (motor-side segment) or Th1_N (stretch "
                 "at the hand), or two without it; name it with --map 'COLUMN=T1_N'; "
                 "--guess proposes a meaning for each column\n"
                 "  log.csv:1: the header has no column 'routing': expected a routing such as "
                 "M-1-T-2-F in each row, or given by --routing");
}

TEST(BadImport, ListsAllFaultsOfALog) {
  expect_refused("t,motor_tension_N,T1_N\n0,x,6\n1,20,1e300\n", {"--routing", "TR1"},
                 "log.csv: 2 faults:\n"
                 "  log.csv:2: column 'motor_tension_N' = 'x': expected a number from -1000000000 "
                 "to 1000000000, or an empty cell\n"
                 "  log.csv:3: column 'T1_N' = '1e300': expected a number from -1000000000 to "
                 "1000000000, or an empty cell");
  expect_refused("t,Position [rev],motor_tension_N,T1_N\n0,1,20,6\n", {"--routing", "TR1"},
                 "log.csv:1: column 2 'Position [rev]': expected the carriage's position with a "
                 "unit of length (mm, cm, m, µm, in), its speed with one of speed (mm/s, cm/s, "
                 "m/s, mm/min, m/min, in/s), or another name if it is neither");
}

}  // namespace
}  // namespace reeve::testing
