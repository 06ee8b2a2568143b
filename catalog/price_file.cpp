#include "catalog/price_file.hpp"

#include <string_view>
#include <vector>

#include "catalog/toml_node.hpp"

namespace reeve::catalog {
namespace {

constexpr double dearest = 1e6;

double price(const TomlNode& node) { return node.number_between(0, dearest); }

std::vector<std::string_view> keys() {
  std::vector<std::string_view> keys{"unit", "bearing", "tendon_mm"};
  for (const PriceRow& row : price_table()) keys.push_back(row.name);
  return keys;
}

void read_bearings(const TomlNode& file, PartPrices& prices) {
  const TomlNode* node = file.find("bearing");
  if (node == nullptr) return;
  const double each = price(*node);
  prices.tip_bearing = each;
  prices.fixed_pulley = each;
  prices.movable_pulley = each;
  prices.block = each;
}

bool all_free(const PartPrices& prices) {
  double sum = prices.tendon_mm;
  for (const PriceRow& row : price_table()) sum += prices.*row.price;
  return sum == 0;
}

}  // namespace

PartPrices read_price_file(const std::filesystem::path& path) {
  const TomlNode file = read_toml(path);
  file.allow_only(keys());
  PartPrices prices;
  if (const TomlNode* unit = file.find("unit")) prices.unit = unit->text();
  read_bearings(file, prices);
  for (const PriceRow& row : price_table()) {
    if (const TomlNode* node = file.find(row.name)) prices.*row.price = price(*node);
  }
  if (const TomlNode* node = file.find("tendon_mm")) prices.tendon_mm = price(*node);
  if (all_free(prices)) {
    file.fail_at_key({.what = "no part has a price",
                      .expected = "a price above 0 of one part at least, such as sheath = 12"});
  }
  return prices;
}

}  // namespace reeve::catalog
