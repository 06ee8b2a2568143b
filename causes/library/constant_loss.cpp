// The transmission takes a constant force before the tendon begins, whatever it carries: gears,
// seals, the guide of the carriage.
//
//   T_in = T_M - F  pulling, not below 0      T_in = T_M + F  releasing
//
// F in N; 0: none. No literature range: it is a matter of the drive. It lessens the pull on every
// routing alike, so that designs are judged without it.
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class ConstantLoss final : public Cause {
 public:
  const char* name() const override { return "constant_loss"; }
  Reach reach() const override { return Reach::motor; }
  const char* meaning() const override {
    return "the transmission takes a constant force before the tendon";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"force_N", "N", 0, {0, 20}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = survey.has_motor_tension;
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double at_tendon(double motor_tension_N, Direction direction, const Conditions&,
                   const Effect& effect) const override {
    const double force = effect.values[0];
    return direction == Direction::pull ? motor_tension_N - force : motor_tension_N + force;
  }
};

}  // namespace

const Cause& constant_loss_cause() {
  static const ConstantLoss cause;
  return cause;
}

}  // namespace reeve::causes
