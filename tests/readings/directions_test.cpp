#include "readings/directions.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/readings/read_data.hpp"

namespace reeve::testing {
namespace {

TEST(ADirection, ThatIsMissingIsAssumedAndCounted) {
  const MeasuredData data = read_data(
      "run,routing,held,direction,T1_N\nA,TR5,1,,1\nA,TR5,1,release,2\nA,TR5,1,-,3\n"
      "A,TR5,1,pull,4\n");
  EXPECT_TRUE(data.readings[0].direction_assumed);
  EXPECT_FALSE(data.readings[1].direction_assumed);
  EXPECT_FALSE(data.readings[3].direction_assumed);
  EXPECT_EQ(note_text(data.notes, NoteKind::assumed),
            "the direction is not given in 2 of 4 rows: pull is assumed");
  EXPECT_EQ(count_notes(read_data("run,routing,held,direction,T1_N\nA,TR5,1,pull,1\n").notes,
                        NoteKind::assumed),
            0U);
}

// Ten rows of M-1-F, that many of them with those tensions and the others as they are pulled.
std::string suspicion(double motor_N, double first_N, double second_N, int rows) {
  std::string text = "run,routing,direction,motor_tension_N,T1_N,T2_N\n";
  for (int i = 0; i < 10; ++i) {
    const double load = 1 + 0.1 * i;
    text += i < rows ? fmt::format("A,M-1-F,,{},{},{}\n", motor_N * load, first_N * load,
                                   second_N * load)
                     : fmt::format("A,M-1-F,,{},{},{}\n", 10 * load, 5 * load, 3 * load);
  }
  const MeasuredData data = read_data(text);
  EXPECT_EQ(
      noted_lines(data.notes, NoteKind::not_as_pulled).size(),
      count_notes(data.notes, NoteKind::not_as_pulled) == 0 ? 0U : static_cast<std::size_t>(rows));
  const std::string note = note_text(data.notes, NoteKind::not_as_pulled);
  return note.empty() ? note : note.substr(note.find(". ") + 2);
}

TEST(Pulling, IsDoubtedWhereStrandsReadMoreThanTheMotor) {
  EXPECT_EQ(suspicion(10, 5, 3, 10), "");
  EXPECT_EQ(suspicion(10, 10.4, 3, 10), "");
  EXPECT_EQ(suspicion(10, 11, 3, 2), "");
  EXPECT_NE(suspicion(10, 11, 3, 3), "");
}

TEST(Pulling, SuggestsChangesThatMakeTheTensionsPossible) {
  // Released: the first strand has more than the motor, the second most.
  EXPECT_EQ(suspicion(10, 20, 35, 10),
            "This would mend it: direction = release; or motor_tension_N and T2_N exchanged; or "
            "motor_tension_N in daN; or motor_tension_N in kgf; or motor_tension_N in lbf");
  // Exchanged: the strand beside the sheath has too little for a release.
  EXPECT_EQ(suspicion(10, 9, 20, 10),
            "This would mend it: motor_tension_N and T2_N exchanged; or motor_tension_N in daN; or "
            "motor_tension_N in kgf; or motor_tension_N in lbf");
  // A unit explains no motor of which the strands have less than a fifth.
  const std::string exchanged = "This would mend it: motor_tension_N and T2_N exchanged";
  EXPECT_EQ(suspicion(1, 0.4, 210, 10), exchanged + "; or motor_tension_N in kN");
  EXPECT_EQ(suspicion(1, 0.4, 190, 10), exchanged);
}

// M-1-F pulled and released in turn: the first strand has less than the motor, then more than it.
std::string cycles(const char* direction) {
  std::string text = "run,routing,direction,motor_tension_N,T1_N,T2_N\n";
  for (int i = 0; i < 5; ++i) {
    const double load = 1 + 0.1 * i;
    text += fmt::format("A,M-1-F,{},{},{},{}\n", direction, 10 * load, 5 * load, 3 * load);
    text += fmt::format("A,M-1-F,{},{},{},{}\n", direction, 10 * load, 20 * load, 35 * load);
  }
  return text;
}

TEST(Pulling, IsMendedByReleaseInRowsOfWhichNothingIsSaid) {
  const std::string remedy = "direction = release in these rows";
  const MeasuredData unknown = read_data(cycles(""));
  EXPECT_NE(note_text(unknown.notes, NoteKind::not_as_pulled).find(remedy), std::string::npos);
  EXPECT_EQ(noted_lines(unknown.notes, NoteKind::not_as_pulled).size(), 5U);
  const MeasuredData pulled = read_data(cycles("pull"));
  EXPECT_EQ(note_text(pulled.notes, NoteKind::not_as_pulled).find(remedy), std::string::npos);
}

TEST(Pulling, IsNotDoubtedWhereBlocksMultiplyTensions) {
  const std::string rows = "A,M-Y1+1x-Y1-2x,pull,10,15,6\nA,M-Y1+1x-Y1-2x,pull,20,30,12\n";
  const MeasuredData data = read_data("run,routing,direction,motor_tension_N,T1_N,T3_N\n" + rows);
  EXPECT_EQ(count_notes(data.notes, NoteKind::not_as_pulled), 0U);
}

}  // namespace
}  // namespace reeve::testing
