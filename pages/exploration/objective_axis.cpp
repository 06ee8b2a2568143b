#include "pages/exploration/objective_axis.hpp"

#include <fmt/format.h>

#include <string_view>

#include "pages/exploration/objective_title.hpp"

namespace reeve {
namespace {

// Ratios of a part to a whole; what force transmission counts, mechanical advantage, has no limit.
bool is_share(const ObjectiveRow& row) {
  return std::string_view(row.unit) == "1" && row.objective != Objective::force_transmission;
}

bool is_count(const ObjectiveRow& row) {
  const std::string_view unit = row.unit;
  return unit == "parts" || unit == "grasps";
}

}  // namespace

chart::Axis objective_axis(Objective objective) {
  const ObjectiveRow& about = row(objective);
  const std::string unit =
      std::string_view(about.unit) == "1" ? "" : fmt::format(", {}", about.unit);
  chart::Axis axis;
  axis.title = fmt::format("{}{} ({} is better)", objective_title(about), unit,
                           about.better == Better::higher ? "higher" : "lower");
  axis.least = 0;
  if (is_share(about)) axis.greatest = 1;
  axis.whole = is_count(about);
  return axis;
}

}  // namespace reeve
