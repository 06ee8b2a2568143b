// Friction of tubes and sheaths depends on the temperature.
//
//   phi' = phi (1 - k (temperature - 20 C)), not below 0
//
// k in 1/K; 0: no dependence, positive: warm liners slide better. Literature: PTFE's friction falls
// as it warms, by up to about 1 per cent for each kelvin (order of magnitude; D. L. Burris,
// S. S. Perry, W. G. Sawyer, Tribol. Lett. 27, 2007, for the dependence). A row without temperature
// is taken as 20 C.
#include <algorithm>
#include <cmath>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class Temperature final : public Cause {
 public:
  const char* name() const override { return "temperature"; }
  Reach reach() const override { return Reach::conditions; }
  const char* meaning() const override {
    return "friction of tubes and sheaths changes with the temperature";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"slope", "1/K", 0, {-0.02, 0.03}, Range{0, 0.01}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = survey.has_temperature && has_tube_or_sheath(survey);
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double exponent(double phi, const ContactLoad& contact, const Conditions& conditions,
                  const Effect& effect) const override {
    if (!is_tube_or_sheath(contact.kind)) return phi;
    return phi * std::max(0.0, 1 - effect.values[0] * (conditions.temperature_C - 20));
  }
};

}  // namespace

const Cause& temperature_cause() {
  static const Temperature cause;
  return cause;
}

}  // namespace reeve::causes
