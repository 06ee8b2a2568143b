// Friction of tubes and sheaths depends on the sliding speed, for which the carriage's stands.
//
//   phi' = phi (1 + beta ln(v / 10 mm/s)), not below 0
//
// beta in 1; 0: no dependence. Literature: PTFE's friction rises with speed, by some 2 to 15 per
// cent for each factor e between 1 and 100 mm/s (K. G. McLaren, D. Tabor, Nature 197, 1963, for the
// rise and its order of magnitude). A row without speed is taken as 10 mm/s,
// and one below 0.01 mm/s as 0.01 mm/s.
#include <algorithm>
#include <cmath>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class SpeedDependentFriction final : public Cause {
 public:
  const char* name() const override { return "speed_dependent_friction"; }
  Reach reach() const override { return Reach::conditions; }
  const char* meaning() const override {
    return "friction of tubes and sheaths changes with the speed";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"slope", "1", 0, {-0.25, 0.5}, Range{0, 0.15}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = survey.has_speed && has_tube_or_sheath(survey);
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double exponent(double phi, const ContactLoad& contact, const Conditions& conditions,
                  const Effect& effect) const override {
    if (!is_tube_or_sheath(contact.kind)) return phi;
    const double speed = std::max(conditions.speed_mm_s, 0.01);
    return phi * std::max(0.0, 1 + effect.values[0] * std::log(speed / 10));
  }
};

}  // namespace

const Cause& speed_dependent_friction_cause() {
  static const SpeedDependentFriction cause;
  return cause;
}

}  // namespace reeve::causes
