#include "search/enumerate/parts.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

std::string text_of(const PartSet& parts) {
  return tips_text(parts) + "; " + joins_text(parts) + "; " + ends_text(parts) +
         (parts.anchored ? "; x" : "") + (parts.blocks > 0 ? "; Y" : "");
}

TEST(Parts, OfThePaperAreFourToWhichBearingsAreAddedAndAnchoredTipsAndABlock) {
  EXPECT_EQ(text_of(paper_parts()), "tube; T,P; M,F");
  EXPECT_EQ(text_of(full_parts()), "tube,bearing; T,B,P; M,F");
  EXPECT_EQ(text_of(all_parts()), "tube,bearing; T,B,P; M,F; x; Y");
  EXPECT_EQ(all_parts().blocks, 1);
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

TEST(Parts, ParsedListsAreSorted) {
  EXPECT_EQ(parse_tips("bearing,tube"), full_parts().tips);
  EXPECT_EQ(parse_joins("P,T,B"), full_parts().joins);
  EXPECT_EQ(parse_ends("F,M"), full_parts().ends);
}

TEST(Parts, ARepeatedItemIsRefused) {
  const auto error = [](auto parse, const char* text) {
    return testing::input_error([&] { parse(text); });
  };
  EXPECT_EQ(error(parse_tips, "tube,bearing,tube"),
            "tips 'tube,bearing,tube': 'tube' is named twice");
  EXPECT_EQ(error(parse_ends, "F,F"), "ends 'F,F': 'F' is named twice");
}

TEST(Parts, UnknownAndEmptyItemsAndBlanksAreNamedWithWhatWasExpected) {
  const auto error = [](auto parse, const char* text) {
    return testing::input_error([&] { parse(text); });
  };
  const std::string tips = "': expected a comma-separated list of tube, bearing";
  const std::string joins = "': expected a comma-separated list of T, B, P";
  const std::string ends = "': expected a comma-separated list of M, F";
  EXPECT_EQ(error(parse_tips, "tube,ring"), "tips 'tube,ring': 'ring" + tips);
  EXPECT_EQ(error(parse_tips, "tube,"), "tips 'tube,': '" + tips);
  const auto plain_joins = [](const char* text) { return parse_joins(text); };
  const auto joins_beside = [](const char* text) { return parse_joins(text, "beside-ends"); };
  EXPECT_EQ(error(plain_joins, "T,X,P"), "joins 'T,X,P': 'X" + joins);
  EXPECT_EQ(error(plain_joins, ","), "joins ',': '" + joins);
  EXPECT_EQ(error(plain_joins, "T, P"), "joins 'T, P': ' P" + joins);
  EXPECT_EQ(error(joins_beside, "M"), "beside-ends 'M': 'M" + joins);
  EXPECT_EQ(error(parse_ends, "m"), "ends 'm': 'm" + ends + "; did you mean M?");
  EXPECT_EQ(error(parse_ends, "M,,F"), "ends 'M,,F': '" + ends);
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

TEST(Parts, WithoutCarriagesNothingHangsOnThem) {
  EXPECT_EQ(text_of(with_carriages(full_parts(), 0)), "tube,bearing; T,B; F");
  EXPECT_EQ(text_of(with_carriages({parse_tips("tube"), parse_joins("P"), parse_ends("M")}, 0)),
            "tube; ; ");
}

TEST(Parts, EachCarriageHasItsEndsAndPulleys) {
  const PartSet parts = with_carriages(paper_parts(), 3);
  EXPECT_EQ(parts.joins,
            (std::vector<TokenKind>{TokenKind::tube_join, TokenKind::movable_pulley,
                                    TokenKind::movable_pulley, TokenKind::movable_pulley}));
  EXPECT_EQ(parts.ends.size(), 4U);
}

TEST(Parts, NoMotorAndMoreThanSixAreRefused) {
  PartSet parts = paper_parts();
  for (const int motors : {0, 7}) {
    parts.motors = motors;
    EXPECT_EQ(testing::input_error([&] { validate(parts); }),
              "motors " + std::to_string(motors) + ": expected a number from 1 to 6");
  }
}

}  // namespace
}  // namespace reeve
