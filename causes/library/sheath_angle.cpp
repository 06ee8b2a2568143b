// The sheaths that lead to one finger turn by another angle: the wearer's posture.
//
//   theta' = theta + dtheta, not below 0, for the sheaths at the strands of finger f
//
// dtheta in rad; 0: as the hardware says. Literature: a hand and wrist in use bend a Bowden cable
// by up to about 1.5 rad more or less (a bend of 90 degrees).
#include <algorithm>
#include <set>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class SheathAngle final : public Cause {
 public:
  const char* name() const override { return "sheath_angle"; }
  Reach reach() const override { return Reach::hardware; }
  const char* meaning() const override { return "the sheaths of one finger turn by another angle"; }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"angle_rad", "rad", 0, {-6, 12}, Range{-1.5, 1.5}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    std::set<int> fingers;
    for (const SurveyedRouting& routing : survey.routings) {
      for (const Contact& contact : routing.network->contacts) {
        if (contact.kind == ContactKind::sheath && contact.finger > 0) {
          fingers.insert(contact.finger);
        }
      }
    }
    std::vector<Subject> subjects;
    for (const int finger : fingers) {
      Subject subject;
      subject.finger = finger;
      subjects.push_back(subject);
    }
    return subjects;
  }
  SubjectKind subject_kind() const override { return SubjectKind::finger; }
  std::string subject_name(const Subject& subject) const override {
    return std::to_string(subject.finger);
  }
  void change_hardware(Hardware& hardware, const Effect& effect) const override {
    FingerHardware& finger = entry(hardware, effect.subject.finger);
    finger.sheath_angle_rad = std::max(
        0.0, finger.sheath_angle_rad.value_or(hardware.sheath.angle_rad) + effect.values[0]);
  }

 private:
  static FingerHardware& entry(Hardware& hardware, int number) {
    for (FingerHardware& finger : hardware.fingers) {
      if (finger.finger == number) return finger;
    }
    hardware.fingers.emplace_back().finger = number;
    return hardware.fingers.back();
  }
};

}  // namespace

const Cause& sheath_angle_cause() {
  static const SheathAngle cause;
  return cause;
}

}  // namespace reeve::causes
