#include "catalog/price_file.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/catalog/mistake.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::Mistake;
using testing::TemporaryFolder;

PartPrices prices_of(const std::string& text) {
  const TemporaryFolder folder;
  return read_price_file(folder.write("p.toml", text));
}

std::string error_in_prices(const std::string& text) {
  const TemporaryFolder folder;
  return folder.error_of([&] { read_price_file(folder.write("p.toml", text)); });
}

TEST(PriceFile, GivesEveryKeyToItsPart) {
  const PartPrices prices = prices_of(
      "unit = \"g\"\nsheath = 1\ntube = 2\ntip_bearing = 3\nfixed_pulley = 4\nmovable_pulley = 5\n"
      "block = 6\nbar = 7\nanchor = 8\nfixed_end = 9\nknot = 10\ntendon_mm = 0.5\n");
  EXPECT_EQ(prices.unit, "g");
  double expected = 1;
  for (const PriceRow& row : price_table()) EXPECT_EQ(prices.*row.price, expected++) << row.name;
  EXPECT_EQ(prices.tendon_mm, 0.5);
}

TEST(PriceFile, TakesTheBearingsPriceForWhatTurnsOnOne) {
  const PartPrices prices = prices_of("fixed_pulley = 9\nbearing = 2\n");
  EXPECT_EQ(prices.tip_bearing, 2);
  EXPECT_EQ(prices.fixed_pulley, 9);
  EXPECT_EQ(prices.movable_pulley, 2);
  EXPECT_EQ(prices.block, 2);
  EXPECT_EQ(prices.bar, 0);
  EXPECT_EQ(prices.sheath, 0);
}

TEST(PriceFile, ReadsTheExample) {
  const PartPrices prices =
      read_price_file(std::string(REEVE_CATALOG_DIR) + "/prices/example.toml");
  EXPECT_EQ(prices.unit, "EUR");
  EXPECT_EQ(prices.tip_bearing, 3.5);
  EXPECT_EQ(prices.movable_pulley, 6);
  EXPECT_EQ(prices.tendon_mm, 0.002);
}

TEST(PriceFile, NamesThePlaceOfAMistake) {
  const std::string keys =
      "unit, bearing, tendon_mm, sheath, tube, tip_bearing, fixed_pulley, movable_pulley, block, "
      "bar, anchor, fixed_end, knot";
  const std::vector<Mistake> mistakes = {
      {"sheath = 1\nmagnet = 2\n", "p.toml:2:1: unknown key 'magnet': expected one of " + keys},
      {"sheath = -1\n", "p.toml:1:10: sheath = -1: expected a number from 0 to 1000000"},
      {"sheath = nan\n", "p.toml:1:10: sheath = nan: expected a number from 0 to 1000000"},
      {"bearing = 1e7\n", "p.toml:1:11: bearing = 10000000: expected a number from 0 to 1000000"},
      {"tendon_mm = \"0.1\"\n",
       "p.toml:1:13: tendon_mm = \"0.1\": expected a number from 0 to 1000000"},
      {"unit = 3\nsheath = 1\n", "p.toml:1:8: unit = 3: expected a text in quotes, not empty"},
      {"[sheath]\nprice = 2\n",
       "p.toml:1:1: sheath = (a table): expected a number from 0 to 1000000"},
      {"unit = \"EUR\"\nsheath = 0\n",
       "p.toml:1:1: no part has a price: expected a price above 0 of one part at least, such as "
       "sheath = 12"}};
  for (const Mistake& mistake : mistakes) {
    EXPECT_EQ(error_in_prices(mistake.text), mistake.message);
  }
}

}  // namespace
}  // namespace reeve
