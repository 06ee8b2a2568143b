#include "reports/exploration/robust_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/text.hpp"
#include "reports/exploration/decision_words.hpp"

namespace reeve::reports {
namespace {

// Returns the loss relative to the other value; 0 if that is 0.
double loss_against(double own, double other) {
  return own == other || other == 0 ? 0 : (other - own) / std::abs(other);
}

// Returns the loss of the nominal best in the 5 % quantile.
double nominal_loss(const RobustFirst& first) {
  return loss_against(first.nominal.p5, first.robust.p5);
}

// Returns the loss of the most robust design at the nominal coefficients.
double robust_loss(const RobustFirst& first) {
  return loss_against(first.robust.value, first.nominal.value);
}

std::string measure_words(const RobustFirst& first) {
  if (first.by_score) return "5 % quantile of the score";
  return first.over_draws ? "5 % quantile of uniformity x efficiency"
                          : "product of the 5 % quantiles of uniformity and efficiency";
}

const char* over_words(const RobustFirst& first) {
  return first.over_draws ? "over the draws" : "if friction differs between contacts";
}

bool is_same(const RobustFirst& first) {
  return first.nominal.design.ranked.design.word == first.robust.design.ranked.design.word;
}

Json robust_design_json(const RobustDesign& robust, double loss) {
  return {{"routing", robust.design.ranked.design.word},
          {"name", text_or_null(robust.design.name)},
          {"rank", robust.design.ranked.rank},
          {"value", number(robust.value)},
          {"p5", number(robust.p5)},
          {"loss", number(loss)}};
}

}  // namespace

std::vector<DocumentLine> robust_lines(const std::optional<RobustFirst>& first) {
  if (!first) return {};
  const auto& [nominal, robust, by_score, over_draws] = *first;
  if (is_same(*first)) {
    return {
        {fmt::format("It is also the most robust design {}: {} {}, nominal {}", over_words(*first),
                     measure_words(*first), fixed(nominal.p5), fixed(nominal.value))}};
  }
  return {{fmt::format("Most robust design {}: {}: {} {} (best: {}, {}); nominal {} ({})",
                       over_words(*first), design_name(robust.design), measure_words(*first),
                       fixed(robust.p5), fixed(nominal.p5), signed_percent(-nominal_loss(*first)),
                       fixed(robust.value), signed_percent(-robust_loss(*first)))}};
}

Json robust_json(const std::optional<RobustFirst>& first) {
  if (!first) return nullptr;
  return {{"by", first->by_score ? "score" : "product"},
          {"over", first->over_draws ? "draws" : "contacts"},
          {"quantile", 0.05},
          {"nominal", robust_design_json(first->nominal, nominal_loss(*first))},
          {"robust", robust_design_json(first->robust, robust_loss(*first))}};
}

}  // namespace reeve::reports
