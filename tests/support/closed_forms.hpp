// The strands of TR1 to TR7 with finger 1 held, T1 to T4 in units of the tightest: the closed forms
// of the paper, not what the solver says.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace reeve::testing {

struct ClosedForm {
  const char* word;
  std::array<double, 4> tension;
};

inline std::array<ClosedForm, 7> closed_forms(double tube, double sheath) {
  const double t = std::exp(-tube * std::numbers::pi);
  const double s = std::exp(-2 * 2 * sheath * std::numbers::pi);  // of two sheaths
  const double b = std::exp(-0.001 * std::numbers::pi);
  return {{{"M-1-T-2-F", {1, t, t * t, t * t * t}},
           {"M-1-T-2-M", {1, t, t * t, t}},
           {"F-1-P-2-F", {t, 1, b, b * t}},
           {"M-1-P-2-F", {1, t, t * s * b, t * t * s * b}},
           {"M-1-P-2-M", {1, t, t * s * b, t * t * s * b}},
           {"1-T-2-P-1", {1, t, t * b, b}},
           {"1-P-2-P-1", {1, 1, b, b}}}};
}

}  // namespace reeve::testing
