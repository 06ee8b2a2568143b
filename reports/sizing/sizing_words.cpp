#include "reports/sizing/sizing_words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace reeve::reports {

std::string goal_text(const SizingOptions& options) {
  const std::string what =
      options.goal.is_target() ? "the miss of the " + to_text(options.goal) : to_text(options.goal);
  if (!options.robust) return what + " at the nominal coefficients";
  const double quantile =
      options.goal.better() == Better::higher ? robust_quantile : 1 - robust_quantile;
  return fmt::format("the {:.0f} % quantile of {} over {} draw{} of the coefficients",
                     100 * quantile, what, options.draws, options.draws == 1 ? "" : "s");
}

std::string title_of(const SizedRouting& routing) {
  return routing.name.empty() ? routing.word : fmt::format("{} ({})", routing.name, routing.word);
}

std::string gain_text(const SizingOptions& options, const SizedDesign& design) {
  const double before = on_grid(design.before.goal);
  const double after = on_grid(design.after.goal);
  std::string text = fmt::format("{:.4g} -> {:.4g}", before, after);
  if (options.goal.is_target() || before == 0) return text;
  text += fmt::format(" ({:+.1f} %)", 100 * (after - before) / std::abs(before));
  return text;
}

}  // namespace reeve::reports
