// Motor-side segments by their letters, and by the strands that they are beside.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "tests/readings/read_data.hpp"

namespace reeve::testing {
namespace {

TEST(AColumnBesideAStrand, IsThatSegmentWhateverItsLetter) {
  const MeasuredData data = read_data(
      "run,routing,T1_N,at_T1_N,at_T4_N\nA,M-1-T-2-M,1,2,3\nA,1-T-2-P-1,1,2,3\nA,TR5,1,2,3\n");
  const auto reading = [&](std::size_t row, const std::string& segment) -> std::optional<double> {
    for (std::size_t c = 0; c < data.channels.size(); ++c) {
      if (data.channels[c].name == segment) return data.readings[row].tension_N[c];
    }
    return std::nullopt;
  };
  EXPECT_EQ(reading(0, "a"), 2);
  EXPECT_EQ(reading(0, "b"), 3);
  EXPECT_EQ(reading(1, "a"), 3);
  EXPECT_EQ(reading(1, "b"), 2);
  EXPECT_EQ(reading(2, "a"), 2);
  EXPECT_FALSE(reading(2, "b"));
  EXPECT_EQ(reading(2, "d"), 3);
  const MeasuredRouting& loop = data.routings[1];
  EXPECT_FALSE(loop.segments.back());  // d
  EXPECT_EQ(data_error("run,routing,T1_N,at_T2_N\nA,M-1-T-2-M,1,2\n"),
            "d.csv:2: column 'at_T2_N' = '2': the routing 'M-1-T-2-M' has no motor-side segment at "
            "T2: expected an empty cell; its segments are a, T1, T2, T3, T4, b");
  EXPECT_EQ(data_error("run,routing,Ta_N,at_T1_N\nA,M-1-T-2-M,1,2\n"),
            "d.csv:2: column 'at_T1_N' = '2': in the routing 'M-1-T-2-M' that is segment a, which "
            "another column has: expected an empty cell in one of the two");
}

TEST(Letters, ThatThePaperUsesOtherwiseAreNoted) {
  const auto letters = [](const std::string& column, const std::string& routing) {
    return note_text(read_data("run,routing,T1_N," + column + "\nA," + routing + ",1,2\n").notes,
                     NoteKind::letters);
  };
  EXPECT_EQ(letters("Ta_N", "1-T-2-P-1"),
            "letters run in walk order: in 1-T-2-P-1 a is beside T4. Where a, b, c, d were meant "
            "beside T1, T2, T3, T4, name the columns at_T1_N and so on");
  for (const char* same : {"M-1-T-2-F", "M-1-P-2-F", "M-1-P-2-M"}) {
    EXPECT_EQ(letters("Ta_N", same), "") << same;
  }
  for (const char* other : {"M-1-T-2-M", "F-1-P-2-F", "1-P-2-P-1"}) {
    EXPECT_NE(letters("Tb_N", other), "") << other;
  }
  EXPECT_EQ(letters("at_T4_N", "1-T-2-P-1"), "");
  const MeasuredData none = read_data("run,routing,T1_N,Ta_N\nA,1-T-2-P-1,1,\nA,M-1-F,1,2\n");
  EXPECT_EQ(count_notes(none.notes, NoteKind::letters),
            0U);  // no letter of that routing is measured
}

}  // namespace
}  // namespace reeve::testing
