// One channel's sensor is dead: unplugged, overloaded, its bridge broken.
//
//   reading = 0 whatever pulls    (with a gain and offset of its own: that offset)
//
// No size: it is so or not.
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class DeadChannel final : public Cause {
 public:
  const char* name() const override { return "dead_channel"; }
  Reach reach() const override { return Reach::reading; }
  const char* meaning() const override { return "one force sensor reads nothing whatever pulls"; }
  std::vector<Parameter> parameters(const Hardware&) const override { return {}; }
  std::vector<Subject> subjects(const Survey& survey) const override {
    return channel_subjects(survey);
  }
  SubjectKind subject_kind() const override { return SubjectKind::channel; }
  std::string subject_name(const Subject& subject) const override {
    return segment_name(*subject.channel);
  }
  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    return is_channel(segment, effect.subject) ? 0 : tension_N;
  }
};

}  // namespace

const Cause& dead_channel_cause() {
  static const DeadChannel cause;
  return cause;
}

}  // namespace reeve::causes
