// Computes the cost of a routing's parts: money, grams or volume, whatever the prices are in.
//
//   cost = Σ_k p_k n_k + p_mm Σ_i L_i
//
// n_k parts of kind k at p_k each, and p_mm for each millimetre of the segments, whose lengths L_i
// the hardware says. A part costs the same wherever it stands, and what has no price costs nothing.
// The tendon inside a sheath is no segment: it is priced with the sheath.
#pragma once

#include <array>
#include <string>

#include "core/mechanics.hpp"
#include "core/performance.hpp"

namespace reeve::core {

struct PartPrices {
  std::string unit;  // "EUR", "g"; "" if nobody says
  double sheath = 0;
  double tube = 0;
  double tip_bearing = 0;
  double fixed_pulley = 0;
  double movable_pulley = 0;
  double block = 0;
  double bar = 0;
  double anchor = 0;
  double fixed_end = 0;
  double knot = 0;
  double tendon_mm = 0;
};

// Each kind of part, by the name that it has in files.
struct PriceRow {
  const char* name;
  double PartPrices::*price;
  int PartCount::*count;
};
inline constexpr std::size_t priced_parts = 10;
const std::array<PriceRow, priced_parts>& price_table();

double cost(const PartCount& count, double tendon_mm, const PartPrices& prices);

// The lengths of all segments.
double tendon_length(const Mechanics& mechanics);

}  // namespace reeve::core
