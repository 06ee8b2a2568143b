// Friction of tubes and sheaths depends on the load: polymers yield, and the true area of contact
// grows more slowly than the load.
//
//   phi' = phi (T_high / 10 N)^(-gamma)    T_high: the larger tension beside the contact
//
// gamma in 1; 0: Coulomb. It is n = 1 - gamma in Howell's law of friction f = a N^n for fibres and
// cables. Literature: n from 0.8 to 1 for polymers, 0.85 for PTFE, so gamma from 0 to 0.2. Below
// T_high = 1 mN the tension is taken as 1 mN: there is nothing to measure there.
// Source of the law: H. G. Howell, J. Text. Inst. 44 (1953); J. H. Jung, N. Pan, T. J. Kang, Mech.
// Mach. Theory 43 (2008), in the capstan equation.
#include <algorithm>
#include <cmath>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class LoadDependentFriction final : public Cause {
 public:
  const char* name() const override { return "load_dependent_friction"; }
  Reach reach() const override { return Reach::load; }
  const char* meaning() const override {
    return "friction of tubes and sheaths falls with the load";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"exponent", "1", 0, {-0.3, 0.7}, Range{0, 0.2}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = has_tube_or_sheath(survey);
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double exponent(double phi, const ContactLoad& contact, const Conditions&,
                  const Effect& effect) const override {
    if (!is_tube_or_sheath(contact.kind)) return phi;
    return phi * std::pow(std::max(contact.high_N, 1e-3) / 10, -effect.values[0]);
  }
};

}  // namespace

const Cause& load_dependent_friction_cause() {
  static const LoadDependentFriction cause;
  return cause;
}

}  // namespace reeve::causes
