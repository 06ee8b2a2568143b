// The motor pulls more or less than recorded, by a constant: a current that is not zero at rest.
//
//   T_M' = T_M + b, not below 0    T_M: as recorded
//
// b in N; 0: right. No literature range. Pulling, it is a constant loss of -b; releasing, the loss
// turns its sign and this does not.
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class MotorOffset final : public Cause {
 public:
  const char* name() const override { return "motor_offset"; }
  Reach reach() const override { return Reach::motor; }
  const char* meaning() const override {
    return "the motor pulls more or less than recorded, by a constant";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"offset_N", "N", 0, {-20, 20}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = survey.has_motor_tension;
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double at_tendon(double motor_tension_N, Direction, const Conditions&,
                   const Effect& effect) const override {
    return motor_tension_N + effect.values[0];
  }
};

}  // namespace

const Cause& motor_offset_cause() {
  static const MotorOffset cause;
  return cause;
}

}  // namespace reeve::causes
