// One channel's sensor has a wrong zero.
//
//   reading = T + b
//
// b in N; 0: right. No literature: a zero drifts with temperature and mounting, which is why it is
// taken before each run.
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class SensorOffset final : public Cause {
 public:
  const char* name() const override { return "sensor_offset"; }
  Reach reach() const override { return Reach::reading; }
  const char* meaning() const override { return "one force sensor has a wrong zero"; }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"offset_N", "N", 0, {-20, 20}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    return channel_subjects(survey);
  }
  SubjectKind subject_kind() const override { return SubjectKind::channel; }
  std::string subject_name(const Subject& subject) const override {
    return segment_name(*subject.channel);
  }
  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    return is_channel(segment, effect.subject) ? tension_N + effect.values[0] : tension_N;
  }
};

}  // namespace

const Cause& sensor_offset_cause() {
  static const SensorOffset cause;
  return cause;
}

}  // namespace reeve::causes
