#include "readings/row_reader.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/readings/read_data.hpp"

namespace reeve {
namespace {

using testing::data_error;
using testing::read_data;

TEST(MeasuredData, HaveEveryValueOfARow) {
  const MeasuredData data = read_data(
      "run,routing,held,direction,motor_tension_N,speed_mm_s,cycle,temperature_C,"
      "sheath_angle_rad,T1_N,Ta_N,humidity\n"
      "A,TR5,1;2,release,20,10,7,21.5,6.1,2.5,9,40\n");
  ASSERT_EQ(data.readings.size(), 1U);
  const Reading& reading = data.readings[0];
  EXPECT_EQ(reading.line, 2U);
  EXPECT_EQ(data.runs, std::vector<std::string>{"A"});
  EXPECT_EQ(data.routings[reading.routing].word, "M-1-P-2-M");
  EXPECT_EQ(reading.grasp, hold({1, 2}));
  EXPECT_EQ(reading.direction, Direction::release);
  EXPECT_EQ(reading.motor_tension_N, 20);
  EXPECT_EQ(reading.speed_mm_s, 10);
  EXPECT_EQ(reading.cycle, 7);
  EXPECT_EQ(reading.temperature_C, 21.5);
  EXPECT_EQ(reading.sheath_angle_rad, 6.1);
  EXPECT_EQ(reading.tension_N, (std::vector<std::optional<double>>{2.5, 9}));
  EXPECT_EQ(reading.covariates, std::vector<std::optional<double>>{40});
  EXPECT_EQ(data.channels[0].name, "T1");
  EXPECT_EQ(data.channels[1].name, "a");
  EXPECT_EQ(data.covariates, std::vector<std::string>{"humidity"});
}

TEST(MeasuredData, TakeEmptyCellsAsMissingAndUseTheDefaults) {
  const MeasuredData data = read_data(
      "run,routing,held,direction,motor_tension_N,T1_N,T2_N,x\n"
      "A,TR5,,,, ,3,\n");
  const Reading& reading = data.readings[0];
  EXPECT_EQ(reading.grasp, Grasp{});
  EXPECT_EQ(reading.direction, Direction::pull);
  EXPECT_FALSE(reading.motor_tension_N);
  EXPECT_FALSE(reading.speed_mm_s);
  EXPECT_FALSE(reading.tension_N[0]);
  EXPECT_EQ(reading.tension_N[1], 3);
  EXPECT_FALSE(reading.covariates[0]);
}

TEST(MeasuredData, TakeANameAndItsWordAsOneRouting) {
  const MeasuredData data =
      read_data("run,routing,T1_N\nA,TR5,1\nB,M-1-P-2-M,2\nA,TR3,3\nA,M-2-P-1-M,4\n");
  ASSERT_EQ(data.routings.size(), 3U);
  EXPECT_EQ(data.readings[1].routing, data.readings[0].routing);
  EXPECT_EQ(data.runs, (std::vector<std::string>{"A", "B"}));
  EXPECT_EQ(data.readings[2].run, 0U);
}

TEST(MeasuredData, ReadHeldFingersInEachWayOfWriting) {
  const MeasuredData data =
      read_data("run,routing,held,T1_N\nA,TR5,none,1\nA,TR5,2,1\nA,TR5,2;1,1\nA,TR5,\"1, 2\",1\n");
  EXPECT_EQ(data.readings[0].grasp, Grasp{});
  EXPECT_EQ(data.readings[1].grasp, hold({2}));
  EXPECT_EQ(data.readings[2].grasp, hold({1, 2}));
  EXPECT_EQ(data.readings[3].grasp, hold({1, 2}));
}

TEST(MeasuredData, ReadHeldFingersAsPandasWritesThem) {
  const MeasuredData data = read_data(
      "run,routing,held,T1_N\nA,TR5,1.0,1\nA,TR5,[2],1\nA,TR5,\"[1, 2]\",1\nA,TR5,[],1\n");
  EXPECT_EQ(data.readings[0].grasp, hold({1}));
  EXPECT_EQ(data.readings[1].grasp, hold({2}));
  EXPECT_EQ(data.readings[2].grasp, hold({1, 2}));
  EXPECT_EQ(data.readings[3].grasp, Grasp{});
  EXPECT_EQ(
      data_error("run,routing,held,T1_N\nA,TR5,0,1\n"),
      "d.csv:2: column 'held' = '0': expected none (no finger held), or finger numbers from 1 "
      "to 2, each once, such as 1;2");
}

TEST(MeasuredData, MayComeWithSemicolonsAndDecimalCommas) {
  const MeasuredData data = read_data("run;routing;held;T1_N\nA;TR5;\"1;2\";2,5\n");
  EXPECT_EQ(data.readings[0].tension_N[0], 2.5);
  EXPECT_EQ(data.readings[0].grasp, hold({1, 2}));
  EXPECT_EQ(
      data_error("run;routing;T1_N\nA;TR5;2,5\nA;TR5;2.5\n"),
      "d.csv:3: column 'T1_N' = '2.5': the file has decimal commas (line 2) and decimal points "
      "(line 3): expected one of them throughout");
}

TEST(MeasuredData, TakeTheDecimalMarkFromNumbersNotFromDatesAndWords) {
  const std::string header = "run;routing;T1_N;Datum;Bemerkung\n";
  const MeasuredData data =
      read_data(header + "A;TR5;2,5;12.03.2026;1.5\nA;TR5;2,5;12.03.2026;neu\nA;TR5;2,5;;alt\n");
  EXPECT_EQ(data.readings.size(), 3U);
  EXPECT_TRUE(data.covariates.empty());
  EXPECT_EQ(data_error("run;routing;T1_N;humidity_pct\nA;TR5;2,5;40.5\nA;TR5;2,6;41.5\n"),
            "d.csv: column 'humidity_pct': the file has decimal commas (line 2) and decimal points "
            "(line 2): expected one of them throughout");
}

TEST(MeasuredData, OfABenchHaveItsStretchAtTheHand) {
  const MeasuredData data = read_data("run,routing,Ta_N,Th1_N\nA,M-F,10,4\n");
  const MeasuredRouting& bench = data.routings[0];
  EXPECT_EQ(segment_name(bench.network.segments[*bench.segments[0]]), "a");
  EXPECT_EQ(segment_name(bench.network.segments[*bench.segments[1]]), "h1");
}

TEST(MeasuredData, AreSimulatedIfACommentSaysSo) {
  EXPECT_TRUE(read_data("# SIMULATED with mu = 0.1\nrun,routing,T1_N\nA,TR5,1\n").simulated);
  EXPECT_TRUE(read_data("run,routing,T1_N\nA,TR5,1\n# these were simulated").simulated);
  EXPECT_FALSE(read_data("# simulation lab\nrun,routing,T1_N\nsimulated,TR5,1\n").simulated);
}

std::string cell_error(const std::string& column, const std::string& cell) {
  return data_error("run,routing,T1_N," + column + "\n1,TR5,1,\n2,TR5,1," + cell + "\n");
}

TEST(BadCell, IsNamedWithLineColumnValueAndWhatWasExpected) {
  const auto expect = [](const std::string& column, const std::string& cell,
                         const std::string& message) {
    EXPECT_EQ(cell_error(column, cell),
              "d.csv:3: column '" + column + "' = '" + cell + "': " + message);
  };
  expect("T2_N", "-2e9", "expected a number from -1000000000 to 1000000000, or an empty cell");
  expect("T2_N", "1e999", "expected a number from -1000000000 to 1000000000, or an empty cell");
  expect("T2_N", "2 N", "expected a number from -1000000000 to 1000000000, or an empty cell");
  expect("motor_tension_N", "-2e9",
         "expected a number from -1000000000 to 1000000000, or an empty cell");
  expect("speed_mm_s", "-1", "expected a number from 0 to 1000000000, or an empty cell");
  expect("temperature_C", "-300", "expected a number from -273.15 to 10000, or an empty cell");
  expect("sheath_angle_rad", "360", "expected a number from 0 to 100, or an empty cell");
  expect("direction", "push", "expected pull, release, or an empty cell");
  const std::string held =
      "expected nothing (none held), or finger numbers from 1 to 2, each once, such as 1;2";
  for (const char* cell : {"3", "1.5", "1;1", "1;", "one"}) expect("held", cell, held);
}

TEST(BadRow, NamesTheRoutingThatIsNone) {
  EXPECT_EQ(
      data_error("run,routing,T1_N\nA,,1\n"),
      "d.csv:2: column 'routing' = '': expected a routing such as M-1-T-2-F (if cells were merged, fill them down)");
  EXPECT_EQ(
      data_error("run,routing,T1_N\n,TR5,1\n"),
      "d.csv:2: column 'run' = '': expected a name or number for the run (if cells were merged, fill them down)");
  EXPECT_EQ(
      data_error("run,routing,T1_N\nA,M-1-Q,1\n"),
      "d.csv:2: column 'routing' = 'M-1-Q': routing 'M-1-Q', column 5: unknown token 'Q': "
      "expected M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such as W1");
  EXPECT_EQ(data_error("run,routing,T1_N\nA,F-1-F,1\n"),
            "d.csv:2: column 'routing' = 'F-1-F': routing 'F-1-F': the tendon with T1 is not "
            "actuated: it has no M and no P, so the motor cannot pull it");
}

// In quotes, a cell may have line ends.
TEST(BadRow, IsNamedInOneLine) {
  const RoutingResolver refuse = [](const std::string& text) -> Routing {
    throw InputError("no such routing: " + text);
  };
  EXPECT_EQ(testing::input_error(
                [&] { parse_measured_data("run,routing,T1_N\nA,\"M-\nF\",1\n", "d.csv", refuse); }),
            "d.csv:2: column 'routing' = 'M-?F': no such routing: M-?F");
  EXPECT_EQ(
      data_error("run,routing,T1_N,\"a\nb\"\nA,M-1-F,1,7\nA,M-1-F,1,\"x\ny\"\n"),
      "d.csv:4: column 'a b' = 'x?y': expected a finite number such as 12.5, or an empty cell");
}

TEST(BadRow, NamesTheStrandThatTheRoutingDoesNotHave) {
  EXPECT_EQ(data_error("run,routing,T1_N,T5_N\nA,TR5,1,\nA,TR5,1,2\n"),
            "d.csv:3: column 'T5_N' = '2': the routing 'M-1-P-2-M' has no segment T5: expected an "
            "empty cell; its segments are a, T1, T2, b, c, T3, T4, d");
  EXPECT_EQ(data_error("run,routing,held,Th1_N\nA,M-F,1,2\n"),
            "d.csv:2: column 'held' = '1': expected nothing: the routing has no fingers");
}

TEST(BadRow, MayHaveNoTension) {
  EXPECT_EQ(data_error("run,routing,motor_tension_N,T1_N,T2_N\nA,TR5,20,,\n"),
            "d.csv:2: the row has no tension: expected a number in column 'T1_N' or another one of "
            "tensions");
  EXPECT_EQ(data_error("run,routing,T1_N\n# none\n"),
            "d.csv:1: expected rows below the header, and there are none");
}

TEST(MeasuredDataFault, HasTheCellInParts) {
  const auto parts = [](const std::string& text) {
    return testing::input_fault([&] { read_data(text); });
  };
  EXPECT_EQ(
      parts("run,routing,T1_N\nA,TR5,1\nA,TR5,x\n"),
      "d.csv:3 | column 'T1_N' | x | a number from -1000000000 to 1000000000, or an empty cell");
  EXPECT_EQ(parts("run,routing,held,T1_N\nA,TR5,3,1\n"),
            "d.csv:2 | column 'held' | 3 | nothing (none held), or finger numbers from 1 to "
            "2, each once, such as 1;2");
  EXPECT_EQ(
      parts("run,routing,T1_N\nA,M-1-Q,1\n"),
      "d.csv:2: column 'routing' = 'M-1-Q': routing 'M-1-Q', column 5 | unknown token | Q | "
      "M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such as W1");
  EXPECT_EQ(parts("run,routing,T1_N,Th0_N\n"),
            "d.csv:1 | column 4 | Th0_N | a tension written as T1_N (strand), Ta_N (motor-side "
            "segment), Th1_N (stretch at the hand) or at_T1_N (the motor-side segment at T1)");
  EXPECT_EQ(parts("run,routing,T1_N\nA,TR5\n"),
            "d.csv:2:6 | 2 fields | - | 3, as many as the header in line 1 has");
}

}  // namespace
}  // namespace reeve
