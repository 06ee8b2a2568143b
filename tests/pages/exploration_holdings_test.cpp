#include "pages/exploration/exploration_holdings.hpp"

#include <gtest/gtest.h>

#include "tests/pages/explored.hpp"

namespace reeve {
namespace {

constexpr std::size_t room = 2'000'000;  // bytes

TEST(HeldDesigns, AreAllWhereThereIsRoom) {
  EXPECT_EQ(pages::held_designs(testing::large(500)).listed, 500U);
}

// Neither more than there is room for, nor much less.
TEST(HeldDesigns, FillTheRoomWhereTheyAreFarTooMany) {
  const pages::HeldDesigns held = pages::held_designs(testing::large(100'000));
  EXPECT_LT(held.listed, 80'000U);
  EXPECT_EQ(held.designs.size(), held.listed);
  EXPECT_LE(held.packed.size(), room);
  EXPECT_GT(held.packed.size(), room * 9 / 10);
}

}  // namespace
}  // namespace reeve
