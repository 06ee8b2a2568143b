// The readings of one routing were taken in another grasp than was written down.
//
//   rows recorded with one grasp were measured in another
//
// No size: it is so or not. Every recorded grasp may really have been any other of the routing, so
// long as something closes.
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class WrongGrasp final : public Cause {
 public:
  const char* name() const override { return "wrong_grasp"; }
  Reach reach() const override { return Reach::grasp; }
  const char* meaning() const override {
    return "a routing was measured in another grasp than recorded";
  }
  std::vector<Parameter> parameters(const Hardware&) const override { return {}; }
  std::vector<Subject> subjects(const Survey& survey) const override {
    std::vector<Subject> subjects;
    for (const SurveyedRouting& routing : survey.routings) {
      for (const Grasp& recorded : routing.recorded) add(routing, recorded, subjects);
    }
    return subjects;
  }
  SubjectKind subject_kind() const override { return SubjectKind::grasp; }
  std::string subject_name(const Subject& subject) const override { return subject.routing; }
  Grasp actual_grasp(const std::string& routing, Grasp recorded,
                     const Effect& effect) const override {
    const Subject& subject = effect.subject;
    return routing == subject.routing && recorded == *subject.recorded ? *subject.actual : recorded;
  }

 private:
  static void add(const SurveyedRouting& routing, Grasp recorded, std::vector<Subject>& subjects) {
    // With more fingers than this, at most one is held: the sets of held fingers are too many to
    // try.
    constexpr int all_grasps_up_to = 4;
    const int fingers = routing.network->fingers;
    if (fingers == 0) return;
    for (const WeightedGrasp& actual :
         fingers <= all_grasps_up_to ? all_grasps(fingers) : single_grasps(fingers)) {
      if (actual.grasp == recorded) continue;
      Subject subject;
      subject.routing = routing.word;
      subject.recorded = recorded;
      subject.actual = actual.grasp;
      subjects.push_back(subject);
    }
  }
};

}  // namespace

const Cause& wrong_grasp_cause() {
  static const WrongGrasp cause;
  return cause;
}

}  // namespace reeve::causes
