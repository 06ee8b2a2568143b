// The default parts: as many as stay below a number of routings.
#include "search/enumerate/field_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

FieldRequest request_for(int fingers) {
  FieldRequest request;
  request.generator.fingers = fingers;
  return request;
}

std::uint64_t routings(GeneratorOptions generator, const PartSet& parts) {
  generator.parts = parts;
  return RoutingGenerator(generator).total();
}

TEST(FieldParts, PullEachFingerByABlockWhereThatIsFewRoutings) {
  for (int fingers = 1; fingers <= 4; ++fingers) {
    const FieldParts field = field_parts(request_for(fingers));
    EXPECT_EQ(field.parts.blocks, fingers - 1);
    EXPECT_TRUE(field.parts.anchored);
    EXPECT_FALSE(field.left_out);
  }
}

TEST(FieldParts, InSeriesHaveABlockForEachFinger) {
  for (int fingers = 1; fingers <= 4; ++fingers) {
    FieldRequest request = request_for(fingers);
    request.generator.parts.series = true;
    EXPECT_EQ(field_parts(request).parts.blocks, std::min(fingers, 3));
    EXPECT_EQ(field_parts(request).left_out.has_value(), fingers == 4);
  }
}

TEST(FieldParts, AreAsManyAsStayBelowTheLimit) {
  for (int fingers = 5; fingers <= 6; ++fingers) {
    const FieldRequest request = request_for(fingers);
    const FieldParts field = field_parts(request);
    EXPECT_LE(routings(request.generator, field.parts), most_of_identical_fingers);
    PartSet next = field.parts;
    ++next.blocks;
    ASSERT_TRUE(field.left_out);
    EXPECT_EQ(field.left_out->routings, routings(request.generator, next));
    EXPECT_GT(field.left_out->routings, most_of_identical_fingers);
    EXPECT_EQ(field.left_out->from_blocks, next.blocks);
    EXPECT_EQ(field.left_out->to_blocks, fingers - 1);
    EXPECT_FALSE(field.left_out->anchored);
  }
}

TEST(FieldParts, AreThoseOfTheRequestWhereTheseAreTooManyAlready) {
  for (const int fingers : {7, 12, 16}) {
    const FieldParts field = field_parts(request_for(fingers));
    EXPECT_EQ(field.parts.blocks, 0);
    EXPECT_FALSE(field.parts.anchored);
    ASSERT_TRUE(field.left_out);
    EXPECT_TRUE(field.left_out->anchored);
    EXPECT_EQ(field.left_out->from_blocks, 1);
  }
}

TEST(FieldParts, KeepTheNumberOfBlocksThatIsAskedFor) {
  FieldRequest request = request_for(3);
  request.blocks = 1;
  const FieldParts field = field_parts(request);
  EXPECT_EQ(field.parts.blocks, 1);
  EXPECT_TRUE(field.parts.anchored);
  EXPECT_FALSE(field.left_out);
  request = request_for(6);
  request.blocks = 1;
  const FieldParts fewer = field_parts(request);
  EXPECT_EQ(fewer.parts.blocks, 1);
  EXPECT_FALSE(fewer.parts.anchored);
  ASSERT_TRUE(fewer.left_out);
  EXPECT_GT(fewer.left_out->from_blocks, fewer.left_out->to_blocks);
}

// The same parts make more routings of fingers that are told apart, each of which takes longer, and
// fewer of one tendon.
TEST(FieldParts, AreCountedForWhatIsEnumerated) {
  FieldRequest request = request_for(4);
  request.generator.identity = FingerIdentity::distinct;
  const FieldParts distinct = field_parts(request);
  EXPECT_EQ(distinct.parts.blocks, 0);
  EXPECT_FALSE(distinct.parts.anchored);
  ASSERT_TRUE(distinct.left_out);
  EXPECT_EQ(distinct.left_out->limit, most_of_distinct_fingers);
  request = request_for(5);
  EXPECT_EQ(field_parts(request).parts.blocks, 1);
  request.generator.one_tendon = true;
  EXPECT_EQ(field_parts(request).parts.blocks, 2);
}

TEST(FieldParts, AreRefusedWhereNobodyCanCountThem) {
  EXPECT_NE(testing::input_fault([] { field_parts(request_for(64)); }), "");
}

}  // namespace
}  // namespace reeve
