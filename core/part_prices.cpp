#include "core/part_prices.hpp"

#include <numeric>

namespace reeve::core {
namespace {

constexpr std::array<PriceRow, priced_parts> table{{
    {"sheath", &PartPrices::sheath, &PartCount::sheaths},
    {"tube", &PartPrices::tube, &PartCount::tubes},
    {"tip_bearing", &PartPrices::tip_bearing, &PartCount::tip_bearings},
    {"fixed_pulley", &PartPrices::fixed_pulley, &PartCount::fixed_pulleys},
    {"movable_pulley", &PartPrices::movable_pulley, &PartCount::movable_pulleys},
    {"block", &PartPrices::block, &PartCount::blocks},
    {"bar", &PartPrices::bar, &PartCount::bars},
    {"anchor", &PartPrices::anchor, &PartCount::anchors},
    {"fixed_end", &PartPrices::fixed_end, &PartCount::fixed_ends},
    {"knot", &PartPrices::knot, &PartCount::knots},
}};

}  // namespace

const std::array<PriceRow, priced_parts>& price_table() { return table; }

double cost(const PartCount& count, double tendon_mm, const PartPrices& prices) {
  double sum = prices.tendon_mm * tendon_mm;
  for (const PriceRow& row : table) sum += prices.*row.price * count.*row.count;
  return sum;
}

double tendon_length(const Mechanics& mechanics) {
  const auto sum_mm = [](const std::vector<double>& parts_mm) {
    return std::accumulate(parts_mm.begin(), parts_mm.end(), 0.0);
  };
  return sum_mm(mechanics.length) - sum_mm(mechanics.springs_mm);
}

}  // namespace reeve::core
