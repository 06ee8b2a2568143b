// The friction coefficient of the bearings differs from the nominal one.
//
//   phi = mu theta, mu free    (coefficients given for one finger or contact stay)
//
// mu in 1. Literature: 0.001 to 0.005 for ball and needle bearings
// (makers' catalogues quote 0.001 to 0.0018 for deep-groove ball bearings).
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class BearingFriction final : public Cause {
 public:
  const char* name() const override { return "bearing_friction"; }
  Reach reach() const override { return Reach::hardware; }
  const char* meaning() const override {
    return "the friction coefficient of the bearings differs from the nominal one";
  }
  std::vector<Parameter> parameters(const Hardware& hardware) const override {
    return {{"mu", "1", hardware.bearing.mu, {0, 0.4}, Range{0.001, 0.005}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    return has_bearing(survey) ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  const ContactLaw* law(const Hardware& hardware) const override { return &hardware.bearing; }
  void change_hardware(Hardware& hardware, const Effect& effect) const override {
    hardware.bearing.mu = effect.values[0];
  }
};

}  // namespace

const Cause& bearing_friction_cause() {
  static const BearingFriction cause;
  return cause;
}

}  // namespace reeve::causes
