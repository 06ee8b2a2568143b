// The motor pulls more or less than recorded, in proportion: another torque constant, another
// radius of the drum.
//
//   T_M' = g T_M    T_M: as recorded
//
// g in 1; 1: right. No literature range: data sheets give a tolerance for each motor. Where nothing
// but strands beyond one sheath each is measured, pulling, it is the same as another friction of
// the sheaths; releasing tells them apart.
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class MotorGain final : public Cause {
 public:
  const char* name() const override { return "motor_gain"; }
  Reach reach() const override { return Reach::motor; }
  const char* meaning() const override {
    return "the motor pulls more or less than recorded, in proportion";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"gain", "1", 1, {0.3, 3}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = survey.has_motor_tension;
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double at_tendon(double motor_tension_N, Direction, const Conditions&,
                   const Effect& effect) const override {
    return effect.values[0] * motor_tension_N;
  }
};

}  // namespace

const Cause& motor_gain_cause() {
  static const MotorGain cause;
  return cause;
}

}  // namespace reeve::causes
