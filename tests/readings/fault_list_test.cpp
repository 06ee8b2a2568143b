// What a file that cannot be read says of all its faults.
#include "readings/fault_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/readings/read_data.hpp"

namespace reeve::testing {
namespace {

TEST(AllFaults, AreListedTogetherByTheirLines) {
  EXPECT_EQ(
      data_error("run,routing,direction,T1_N,T1,speed,x\n"
                 "A,TR5,push,x,1,-1,1\n"
                 "A,TR5\n"
                 ",M-1-Q,,1,,1,1\n"
                 "A,TR5,,2,,1,u\n"),
      "d.csv: 8 faults:\n"
      "  d.csv:1: column 5 'T1': expected one column of its meaning, and column 4 'T1_N' has "
      "it\n"
      "  d.csv:2: column 'T1_N' = 'x': expected a number from -1000000000 to 1000000000, or an "
      "empty cell\n"
      "  d.csv:2: column 'speed' = '-1': expected a number from 0 to 1000000000, or an empty "
      "cell\n"
      "  d.csv:2: column 'direction' = 'push': expected pull, release, or an empty cell\n"
      "  d.csv:3:6: 2 fields: expected 7, as many as the header in line 1 "
      "has\n"
      "  d.csv:4: column 'run' = '': expected a name or number for the run (if cells were merged, fill them down)\n"
      "  d.csv:4: column 'routing' = 'M-1-Q': routing 'M-1-Q', column 5: unknown token 'Q': "
      "expected M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a "
      "bar such as W1\n"
      "  d.csv:5: column 'x' = 'u': expected a finite number such as 12.5, or an empty cell");
}

// What follows the broken place is no row, and would be a fault of its own.
TEST(AllFaults, EndWhereTheFileBreaksOff) {
  const std::string header = "run,routing,T1_N,T2_N\n";
  const std::string broken = "A,TR5,1\"2,3\nA,TR5,3,4\n";
  const std::string fault =
      ":8: a quote inside a field: expected the whole field in quotes, and the quote twice";
  EXPECT_EQ(data_error(header + broken), "d.csv:2" + fault);
  EXPECT_EQ(data_error(header + "A,TR5,1,3\n" + broken), "d.csv:3" + fault);
}

TEST(AllFaults, AreCountedWhereTooManyToList) {
  std::string text = "run,routing,T1_N,T2_N\n";
  for (int i = 0; i < 300; ++i) text += i % 3 == 0 ? "A,TR5,x,1\n" : "A,TR5,1,y\n";
  text += "A,TR5,1,\"2\n";
  const std::string message = data_error(text);
  EXPECT_EQ(
      message.substr(0, message.find('\n')),
      "d.csv: 301 faults: 200 in column 'T2_N', 100 in column 'T1_N', 1 where the rest cannot "
      "be read; the first 20, and 281 more:");
  EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 20);
}

TEST(AllFaults, HaveTheirParts) {
  try {
    read_data("run,routing,T1_N\nA,TR5,x\nA,TR5,y\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.fault().where, "d.csv");
    ASSERT_EQ(error.fault().parts.size(), 2U);
    EXPECT_EQ(error.fault().parts[1].where, "d.csv:3");
    EXPECT_EQ(error.fault().parts[1].what, "column 'T1_N'");
    EXPECT_EQ(error.fault().parts[1].value, "y");
    const InputError placed = error.at("file");
    EXPECT_EQ(placed.fault().parts.size(), 2U);
    EXPECT_EQ(std::string(placed.what()).substr(0, 22), "file: d.csv: 2 faults:");
  }
}

}  // namespace
}  // namespace reeve::testing
