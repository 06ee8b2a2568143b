// A bearing drags by a constant force, whatever it carries: seals and grease.
//
//   T_low = T_high e^{-phi} - F_d    at each bearing, not below 0
//
// At one that does not turn, the cone is as much wider. F_d in N; 0: none. Literature: some tenths
// of a newton at the rim of a small sealed or greased ball bearing (order of magnitude).
#include <algorithm>
#include <cmath>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class BearingDrag final : public Cause {
 public:
  const char* name() const override { return "bearing_drag"; }
  Reach reach() const override { return Reach::load; }
  const char* meaning() const override { return "each bearing takes a further constant force"; }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"force_N", "N", 0, {0, 5}, Range{0, 1}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = has_bearing(survey);
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double exponent(double phi, const ContactLoad& contact, const Conditions&,
                  const Effect& effect) const override {
    return is_bearing(contact.kind) ? exponent_with_force(phi, contact.high_N, effect.values[0])
                                    : phi;
  }
};

}  // namespace

const Cause& bearing_drag_cause() {
  static const BearingDrag cause;
  return cause;
}

}  // namespace reeve::causes
