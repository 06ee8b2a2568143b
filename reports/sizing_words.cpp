#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "reports/sizing_report.hpp"

namespace reeve::reports {

std::string goal_text(const SizingOptions& options) {
  const std::string what =
      options.goal.is_target() ? "the miss of the " + to_text(options.goal) : to_text(options.goal);
  if (!options.robust) return what + " at the nominal coefficients";
  const double quantile =
      options.goal.better() == Better::higher ? robust_quantile : 1 - robust_quantile;
  return fmt::format("the {:.0f} % quantile of {} over {} draws of the coefficients",
                     100 * quantile, what, told_draws(options));
}

std::string title_of(const SizedRouting& routing) {
  return routing.name.empty() ? routing.word : fmt::format("{} ({})", routing.name, routing.word);
}

namespace {

// " N"; "" of shares, products and what else has none.
std::string unit_text(const Goal& goal) {
  if (goal.factors.size() != 1) return "";
  const std::string_view unit = row(goal.factors.front()).unit;
  return unit == "1" ? "" : fmt::format(" {}", unit);
}

}  // namespace

std::string gain_text(const SizingOptions& options, const SizedDesign& design) {
  const double before = on_grid(design.before.goal);
  const double after = on_grid(design.after.goal);
  const auto text_of = [](double value) {
    return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
  };
  std::string text =
      fmt::format("{} -> {}{}", text_of(before), text_of(after), unit_text(options.goal));
  const bool compares = std::isfinite(before) && std::isfinite(after) && before != 0;
  if (options.goal.is_target() || !compares) return text;
  text += fmt::format(" ({:+.1f} %)", 100 * (after - before) / std::abs(before));
  return text;
}

std::string tolerance_text(const SizingOptions& options) {
  return options.goal.is_target() ? "0.01 of the shares" : "1 % of the goal";
}

std::string moves_text(const SizedDesign& design, const std::vector<double>& moves,
                       const char* between) {
  std::string text;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (moves[i] == 0) continue;
    const SizeVariable& about = design.variables[i].variable;
    text += fmt::format("{}{} by {:+.3g}{}{}", text.empty() ? "" : between, about.name, moves[i],
                        *about.unit == '\0' ? "" : " ", about.unit);
  }
  return text;
}

std::string any_text(const SizedDesign& design) {
  const bool any = std::ranges::any_of(design.variables, [](const SizedVariable& sized) {
    return !sized.sensitivity.less || !sized.sensitivity.more;
  });
  if (!any || design.variables.size() == 1 || !design.together) return "";
  return fmt::format(
      "any: no limit within the bounds and their width beyond; ≥: no limit up to this change, the "
      "greatest that was tried: {:.3g} times the tolerance of the other side (or a tenth of the "
      "bounds, if both sides are any)",
      design.together->factor);
}

std::string together_text(const SizingOptions& options, const SizedDesign& design) {
  const JointTolerance& together = *design.together;
  if (design.variables.size() == 1) return "";
  if (together.worst.empty()) {
    return "All at once: the same tolerances; no combination was found that costs more than one alone";
  }
  return fmt::format(
      "All at once: {:.3g} of these tolerances cost {}; the worst combination found is {}",
      together.factor, tolerance_text(options), moves_text(design, together.worst, ", "));
}

}  // namespace reeve::reports
