#include "reports/shown_value.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "reports/output/telling_digits.hpp"

namespace reeve::reports {

int shown_decimals(Objective objective, double value, int at_least) {
  return objective == Objective::cost ? significant_decimals(value, at_least) : at_least;
}

int shown_decimals(Objective objective, double value) {
  return shown_decimals(objective, value, row(objective).decimals);
}

int shown_decimals(Objective objective, const std::vector<ListedDesign>& designs) {
  int decimals = row(objective).decimals;
  for (const ListedDesign& design : designs) {
    const double shown = value(design.ranked.design.values, objective);
    decimals = std::max(decimals, shown_decimals(objective, shown));
  }
  return decimals;
}

std::string objective_text(Objective objective, double value) {
  return fixed(value, shown_decimals(objective, value, row(objective).is_count() ? 0 : 3));
}

std::string shown_value(Objective objective, double value) {
  return fixed(value, shown_decimals(objective, value));
}

}  // namespace reeve::reports
