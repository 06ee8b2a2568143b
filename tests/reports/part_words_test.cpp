#include "reports/exploration/part_words.hpp"

#include <gtest/gtest.h>

#include "tests/support/has.hpp"

namespace reeve::reports {
namespace {

using testing::has;

TEST(PartsText, CountsOneBlockAndMore) {
  PartSet parts = search::all_parts();
  EXPECT_EQ(parts_text(parts),
            "tips tube, bearing; joins T, B, P; ends M, F; anchored tips; up to 1 floating block");
  parts.blocks = 2;
  EXPECT_TRUE(has(parts_text(parts), "up to 2 floating blocks"));
  EXPECT_FALSE(has(parts_text(search::paper_parts()), "block"));
}

TEST(PartsText, NamesWhatIsAskedForBesidePlainBlocks) {
  PartSet parts = search::paper_parts();
  for (const char* key :
       {"motors", "beside_ends", "linked", "series", "bars", "beckets", "double_passes"}) {
    EXPECT_FALSE(parts_json(parts).contains(key)) << key;
  }
  parts.motors = 2;
  parts.beside = search::parse_joins("B,P");
  EXPECT_EQ(parts_text(parts), "tips tube; joins T, P; ends M, F; 2 motors; beside ends B, P");
  EXPECT_EQ(parts_json(parts)["motors"], 2);
  EXPECT_EQ(parts_json(parts)["beside_ends"], "B,P");
  parts.linked = true;
  EXPECT_TRUE(has(parts_text(parts), "; beside ends B, P; linked blocks"));
  EXPECT_EQ(parts_json(parts)["linked"], true);
  parts.series = true;
  EXPECT_TRUE(has(parts_text(parts), "; linked blocks; blocks in series"));
  EXPECT_EQ(parts_json(parts)["series"], true);
  parts.bars = true;
  EXPECT_TRUE(has(parts_text(parts), "; blocks in series; bars"));
  EXPECT_EQ(parts_json(parts)["bars"], true);
  parts.beckets = parts.double_passes = true;
  EXPECT_TRUE(has(parts_text(parts), "; bars; beckets; double passes"));
  EXPECT_EQ(parts_json(parts)["beckets"], true);
  EXPECT_EQ(parts_json(parts)["double_passes"], true);
}

TEST(LeftOutText, NamesThePartsAndTheOptionThatAsksForThem) {
  EXPECT_EQ(
      left_out_text({false, 2, 4, 5333880, 2000000}),
      "2 to 4 floating blocks are left out: with --blocks 2 there are at least 5333880 routings, "
      "and the default adds parts up to 2000000");
  EXPECT_TRUE(has(left_out_text({false, 1, 1, 3000000, 2000000}),
                  "1 floating block is left out: with --blocks 1 "));
  EXPECT_TRUE(has(left_out_text({true, 1, 6, 5198166, 2000000}),
                  "anchored tips and 1 to 6 floating blocks are left out: with --anchored "));
  EXPECT_TRUE(has(left_out_text({true, 2, 1, 5198166, 2000000}),
                  "anchored tips are left out in favour of --blocks 1: with --anchored "));
}

}  // namespace
}  // namespace reeve::reports
