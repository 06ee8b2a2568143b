// A tendon that resists bending loses a constant force wherever it is bent and straightened.
//
//   T_low = T_high e^{-phi} - F_b    at each tube and sheath, not below 0
//
// At one that does not slide, the cone is as much wider. F_b in N; 0: a perfectly soft tendon.
// Literature: rope rigidity, some tenths of a newton for cords of 0.5 to 1 mm at bends of some
// centimetres (order of magnitude; it grows with the square of the diameter). Source
// of the idea: J. H. Jung, N. Pan, T. J. Kang, Mech. Mach. Theory 43 (2008).
#include <algorithm>
#include <cmath>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class BendingStiffness final : public Cause {
 public:
  const char* name() const override { return "bending_stiffness"; }
  Reach reach() const override { return Reach::load; }
  const char* meaning() const override {
    return "each tube and sheath takes a further constant force";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"force_N", "N", 0, {0, 5}, Range{0, 1}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = has_tube_or_sheath(survey);
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double exponent(double phi, const ContactLoad& contact, const Conditions&,
                  const Effect& effect) const override {
    return is_tube_or_sheath(contact.kind)
               ? exponent_with_force(phi, contact.high_N, effect.values[0])
               : phi;
  }
};

}  // namespace

const Cause& bending_stiffness_cause() {
  static const BendingStiffness cause;
  return cause;
}

}  // namespace reeve::causes
