// The transmission takes a force before the tendon begins that grows with the speed: grease, the
// motor's own damping.
//
//   T_in = T_M - c v  pulling, not below 0      T_in = T_M + c v  releasing
//
// v: the carriage's speed, in mm/s; a row without speed is taken as 10 mm/s. c in N s/mm; 0: none.
// No literature range. It lessens the pull on every routing alike, so that designs are judged
// without it.
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class ViscousLoss final : public Cause {
 public:
  const char* name() const override { return "viscous_loss"; }
  Reach reach() const override { return Reach::motor; }
  const char* meaning() const override {
    return "the transmission takes a force that grows with the speed";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"slope", "N s/mm", 0, {0, 0.5}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = survey.has_motor_tension && survey.has_speed;
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double at_tendon(double motor_tension_N, Direction direction, const Conditions& conditions,
                   const Effect& effect) const override {
    const double force = effect.values[0] * conditions.speed_mm_s;
    return direction == Direction::pull ? motor_tension_N - force : motor_tension_N + force;
  }
};

}  // namespace

const Cause& viscous_loss_cause() {
  static const ViscousLoss cause;
  return cause;
}

}  // namespace reeve::causes
