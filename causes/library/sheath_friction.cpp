// The friction coefficient of the sheaths differs from the nominal one.
//
//   phi = mu theta, mu free    (coefficients given for one finger or contact stay)
//
// mu in 1. Literature: 0.05 to 0.20 for Teflon on steel (Exo-Glove II
// supplement, section I; its own tension test ends at 0.09 instead of 0.18).
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class SheathFriction final : public Cause {
 public:
  const char* name() const override { return "sheath_friction"; }
  Reach reach() const override { return Reach::hardware; }
  const char* meaning() const override {
    return "the friction coefficient of the sheaths differs from the nominal one";
  }
  std::vector<Parameter> parameters(const Hardware& hardware) const override {
    return {{"mu", "1", hardware.sheath.mu, {0, 0.6}, Range{0.05, 0.20}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    return has_contact(survey, ContactKind::sheath) ? std::vector<Subject>(1)
                                                    : std::vector<Subject>{};
  }
  const ContactLaw* law(const Hardware& hardware) const override { return &hardware.sheath; }
  void change_hardware(Hardware& hardware, const Effect& effect) const override {
    hardware.sheath.mu = effect.values[0];
  }
};

}  // namespace

const Cause& sheath_friction_cause() {
  static const SheathFriction cause;
  return cause;
}

}  // namespace reeve::causes
