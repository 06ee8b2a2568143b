#include "reports/check_words.hpp"

#include <fmt/format.h>

#include <array>

namespace reeve::reports {
namespace {

constexpr std::array indicator_names{"adaptability", "torsional balance", "reliability",
                                     "authors' efficiency", "transmission"};

}  // namespace

std::string quantity_text(const CheckedQuantity& quantity) {
  switch (quantity.kind) {
    case CheckedKind::strand_tension:
      return fmt::format("T{}", quantity.number);
    case CheckedKind::strand_share:
      return fmt::format("share of T{}, %", quantity.number);
    case CheckedKind::motor_tension:
      return "T_M that the printed tensions ask for";
    case CheckedKind::motor_tension_of_equation:
      return "T_M that the equation as printed asks for";
    case CheckedKind::idle_fault:
      return fmt::format("numbers explained by listed fault {}", quantity.number);
    case CheckedKind::tension_sum:
      return "sum of the strand tensions, N";
    case CheckedKind::indicator:
      return indicator_names.at(static_cast<std::size_t>(quantity.number - 1));
    case CheckedKind::indicator_mean:
      return "mean of the five indicators";
    case CheckedKind::share_error:
      return "error of the printed shares, %";
    case CheckedKind::share_error_of_equations:
      return "error of the equations' shares, %";
    case CheckedKind::friction_coefficient:
      return "friction coefficient";
    case CheckedKind::design_count:
      return fmt::format("designs of {} fingers", quantity.number);
    case CheckedKind::in_words:
      return "";
  }
  return "";
}

std::string quantity_text(const CheckItem& item) {
  return item.quantity.kind == CheckedKind::in_words ? item.in_words : quantity_text(item.quantity);
}

}  // namespace reeve::reports
