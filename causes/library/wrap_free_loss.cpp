// Each sheath loses a part that does not depend on how far it turns: the tendon's entry and exit, a
// pulley whose own bearing turns with it.
//
//   phi' = phi + c    at each sheath, not below 0
//
// c in 1; 0: a loss by the wrap alone. No literature range; of one flat belt on a pulley, laps of
// 45 to 180 degrees, ln(T1/T2) = 0.43 + 0.099 theta. At a single angle it is another friction
// coefficient, so that it is asked for only where rows say their sheath angle, and not the same
// one.
#include <algorithm>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class WrapFreeLoss final : public Cause {
 public:
  const char* name() const override { return "wrap_free_loss"; }
  Reach reach() const override { return Reach::conditions; }
  const char* meaning() const override {
    return "each sheath loses a part that does not depend on its angle";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"exponent", "1", 0, {-0.5, 2}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = survey.sheath_angle_varies && has_contact(survey, ContactKind::sheath);
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double exponent(double phi, const ContactLoad& contact, const Conditions&,
                  const Effect& effect) const override {
    return contact.kind == ContactKind::sheath ? std::max(0.0, phi + effect.values[0]) : phi;
  }
};

}  // namespace

const Cause& wrap_free_loss_cause() {
  static const WrapFreeLoss cause;
  return cause;
}

}  // namespace reeve::causes
