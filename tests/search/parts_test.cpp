#include "search/enumerate/parts.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

TEST(Parts, PaperPartsAreTheFourOfThePaper) {
  const PartSet parts = paper_parts();
  EXPECT_EQ(tips_text(parts), "tube");
  EXPECT_EQ(joins_text(parts), "T,P");
  EXPECT_EQ(ends_text(parts), "M,F");
}

TEST(Parts, FullPartsAddTheBearings) {
  const PartSet parts = full_parts();
  EXPECT_EQ(tips_text(parts), "tube,bearing");
  EXPECT_EQ(joins_text(parts), "T,B,P");
  EXPECT_EQ(ends_text(parts), "M,F");
}

TEST(Parts, AllPartsAddAnchoredTipsAndABlock) {
  const PartSet parts = all_parts();
  EXPECT_EQ(tips_text(parts), "tube,bearing");
  EXPECT_EQ(joins_text(parts), "T,B,P");
  EXPECT_EQ(ends_text(parts), "M,F");
  EXPECT_TRUE(parts.anchored);
  EXPECT_EQ(parts.blocks, 1);
  EXPECT_FALSE(full_parts().anchored);
  EXPECT_EQ(full_parts().blocks, 0);
}

TEST(Parts, ParsedListsPrintBack) {
  for (const char* tips : {"", "tube", "bearing", "tube,bearing"}) {
    EXPECT_EQ(tips_text({parse_tips(tips), {}, {}}), tips);
  }
  for (const char* joins : {"", "T", "B", "P", "T,B", "T,P", "B,P", "T,B,P"}) {
    EXPECT_EQ(joins_text({{}, parse_joins(joins), {}}), joins);
  }
  for (const char* ends : {"", "M", "F", "M,F"}) {
    EXPECT_EQ(ends_text({{}, {}, parse_ends(ends)}), ends);
  }
}

TEST(Parts, ParsedListsAreSortedAndWithoutRepeats) {
  EXPECT_EQ(parse_tips("bearing,tube,bearing"), full_parts().tips);
  EXPECT_EQ(parse_joins("P,T,B,T,P"), full_parts().joins);
  EXPECT_EQ(parse_ends("F,M,F"), full_parts().ends);
}

TEST(Parts, UnknownItemsAreNamedWithWhatWasExpected) {
  EXPECT_EQ(testing::input_error([] { parse_tips("tube,ring"); }),
            "tips 'tube,ring': 'ring': expected a comma-separated list of tube, bearing");
  EXPECT_EQ(testing::input_error([] { parse_joins("T,X,P"); }),
            "joins 'T,X,P': 'X': expected a comma-separated list of T, B, P");
  EXPECT_EQ(testing::input_error([] { parse_ends("m"); }),
            "ends 'm': 'm': expected a comma-separated list of M, F");
}

TEST(Parts, EmptyItemsAndBlanksAreErrors) {
  EXPECT_EQ(testing::input_error([] { parse_joins(","); }),
            "joins ',': '': expected a comma-separated list of T, B, P");
  EXPECT_EQ(testing::input_error([] { parse_tips("tube,"); }),
            "tips 'tube,': '': expected a comma-separated list of tube, bearing");
  EXPECT_EQ(testing::input_error([] { parse_ends("M,,F"); }),
            "ends 'M,,F': '': expected a comma-separated list of M, F");
  EXPECT_EQ(testing::input_error([] { parse_joins("T, P"); }),
            "joins 'T, P': ' P': expected a comma-separated list of T, B, P");
}

TEST(Parts, SomeRoutingMustBePossible) {
  const PartSet paper = paper_parts();
  EXPECT_EQ(testing::input_error([&] {
              validate({{}, paper.joins, paper.ends});
            }),
            "tips '': expected at least one of tube, bearing");
  EXPECT_EQ(testing::input_error([&] {
              validate({paper.tips, {}, {}});
            }),
            "joins '' without ends: expected at least one join or one end");
  EXPECT_NO_THROW(validate({paper.tips, paper.joins, {}}));
  EXPECT_NO_THROW(validate({paper.tips, {}, paper.ends}));
}

TEST(Parts, PassivePartsLackWhatHangsOnTheCarriage) {
  const PartSet passive = passive_parts(full_parts());
  EXPECT_EQ(tips_text(passive), "tube,bearing");
  EXPECT_EQ(joins_text(passive), "T,B");
  EXPECT_EQ(ends_text(passive), "F");

  const PartSet none = passive_parts({parse_tips("tube"), parse_joins("P"), parse_ends("M")});
  EXPECT_EQ(tips_text(none), "tube");
  EXPECT_TRUE(none.joins.empty());
  EXPECT_TRUE(none.ends.empty());
}

}  // namespace
}  // namespace reeve
