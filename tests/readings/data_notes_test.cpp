#include "readings/data_notes.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/readings/read_data.hpp"

namespace reeve {
namespace {

using testing::count_notes;
using testing::noted_lines;
using testing::read_data;

using Lines = std::vector<std::size_t>;

const std::string notes_header = "run,routing,held,motor_tension_N,T1_N,Ta_N,x\n";

Lines lines(const std::string& rows, NoteKind kind) {
  return noted_lines(read_data(notes_header + rows).notes, kind);
}

TEST(AMotorSideSegment, WithMoreThanTheMotorGivesIsNoted) {
  EXPECT_EQ(lines("A,TR5,,20,4,20.9,1\nA,TR5,,20,4,21.1,1\n", NoteKind::motor_side_above_motor),
            Lines{3});
  // Strands may carry more than the motor: releasing, or behind a pulley.
  EXPECT_EQ(lines("A,TR5,,20,30,10,1\n", NoteKind::motor_side_above_motor), Lines{});
}

std::size_t unit_notes(const std::string& rows) {
  return count_notes(read_data("run,routing,motor_tension_N,T1_N\n" + rows).notes, NoteKind::units);
}

TEST(UnitsOffByAThousand, AreSuspected) {
  EXPECT_EQ(unit_notes("A,TR5,20,4\nA,TR5,25,5\n"), 0U);
  EXPECT_EQ(unit_notes("A,TR5,20,4000\nA,TR5,25,5000\n"), 1U);        // mN over N
  EXPECT_EQ(unit_notes("A,TR5,20,0.03\nA,TR5,25,0.03\n"), 1U);        // kN over N
  EXPECT_EQ(unit_notes("A,TR5,20000,4000\nA,TR5,25000,3000\n"), 1U);  // motor in mN
  EXPECT_EQ(unit_notes("A,TR5,,0.004\nA,TR5,,0.005\n"), 1U);
  EXPECT_EQ(unit_notes("A,TR5,20,0\nA,TR5,25,0\n"), 0U);
  const auto notes =
      read_data("run,routing,direction,motor_tension_N,T1_N\nA,TR5,release,20,4000\n").notes;
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(
      notes[0].text,
      "the median of T1_N over motor_tension_N is 200, and from 0.002 to 20 is plausible: is it "
      "in another unit than newton?");
}

// What is above zero is noise, too, of a sensor that reads nothing.
TEST(UnitsOfASensorThatReadsNothing, AreNotAskedFor) {
  EXPECT_EQ(unit_notes("A,TR5,20,0.03\nA,TR5,25,0.02\nA,TR5,22,0.03\n"), 1U);
  EXPECT_EQ(unit_notes("A,TR5,20,0.03\nA,TR5,25,0.02\nA,TR5,22,-0.03\n"), 0U);
  EXPECT_EQ(unit_notes("A,TR5,20,0.03\nA,TR5,25,0.02\nA,TR5,22,0.03\nA,TR5,22,-0.03\n"), 1U);
}

TEST(ColumnsAndCommentsThatAreNoReadings, AreNoted) {
  const MeasuredData data =
      read_data("# source\n" + notes_header + "A,TR5,,20,4,10,1\n#A,TR5,,20,5,10,1\n");
  EXPECT_EQ(count_notes(data.notes, NoteKind::covariate), 1U);
  EXPECT_EQ(noted_lines(data.notes, NoteKind::comment), Lines{4});
}

// It gives rows their order, and `import` itself writes it.
TEST(AClockOfReadings, IsNoNews) {
  const std::string header = "run,routing,humidity,time_s,T1_N\n";
  const MeasuredData data = read_data(header + "A,TR5,1,0.5,4\nA,TR5,1,1.5,5\n");
  EXPECT_EQ(count_notes(data.notes, NoteKind::covariate), 1U);
  EXPECT_EQ(data.covariates.size(), 2U);
  // It has no time of one row, and orders none.
  const MeasuredData part = read_data(header + "A,TR5,1,0.5,4\nA,TR5,1,,5\n");
  EXPECT_EQ(count_notes(part.notes, NoteKind::covariate), 2U);
}

}  // namespace
}  // namespace reeve
