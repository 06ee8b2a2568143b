// Pulling and releasing differ by more than the capstan law says: friction of tubes and sheaths is
// another one when releasing.
//
//   phi' = phi (1 + h)    releasing; pulling, phi' = phi
//
// h in 1; 0: the same both ways, positive: releasing holds more. It stands for presliding, creep
// and whatever else remembers the direction, and says nothing of how one goes over into the other.
// No literature range for tendons; climbing ropes raised and lowered over bars have h from 0.3 to 4
// (75 kg over bars of 10 to 60 mm: raising times lowering is 46 to 70 kg squared, where one
// friction both ways would make it 75 squared).
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class Hysteresis final : public Cause {
 public:
  const char* name() const override { return "hysteresis"; }
  Reach reach() const override { return Reach::conditions; }
  const char* meaning() const override {
    return "friction of tubes and sheaths differs when releasing";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"change", "1", 0, {-0.9, 4}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = survey.has_both_directions && has_tube_or_sheath(survey);
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double exponent(double phi, const ContactLoad& contact, const Conditions&,
                  const Effect& effect) const override {
    const bool changed = contact.direction == Direction::release && is_tube_or_sheath(contact.kind);
    return changed ? phi * (1 + effect.values[0]) : phi;
  }
};

}  // namespace

const Cause& hysteresis_cause() {
  static const Hysteresis cause;
  return cause;
}

}  // namespace reeve::causes
