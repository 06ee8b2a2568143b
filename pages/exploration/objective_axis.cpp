#include "pages/exploration/objective_axis.hpp"

#include <fmt/format.h>

#include <string_view>

#include "pages/exploration/objective_title.hpp"

namespace reeve::pages {

chart::Axis objective_axis(Objective objective, const std::string& cost_unit) {
  const ObjectiveRow& about = row(objective);
  std::string unit = about.unit == std::string_view("1") ? "" : fmt::format(", {}", about.unit);
  if (objective == Objective::cost && !cost_unit.empty()) unit = ", " + cost_unit;
  chart::Axis axis;
  axis.title = fmt::format("{}{} ({} is better)", objective_title(about), unit,
                           about.better == Better::higher ? "higher" : "lower");
  axis.least = about.least;
  axis.greatest = about.greatest;
  axis.whole = about.is_count();
  return axis;
}

}  // namespace reeve::pages
