// One channel's sensor has another gain.
//
//   reading = g T
//
// g in 1; 1: right. Literature: load cells of this size are calibrated to 1 to 5 per cent, and a
// mounting that bends them costs more.
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class SensorGain final : public Cause {
 public:
  const char* name() const override { return "sensor_gain"; }
  Reach reach() const override { return Reach::reading; }
  const char* meaning() const override { return "one force sensor has a gain error"; }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"gain", "1", 1, {0.2, 3}, Range{0.95, 1.05}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    return channel_subjects(survey);
  }
  SubjectKind subject_kind() const override { return SubjectKind::channel; }
  std::string subject_name(const Subject& subject) const override {
    return segment_name(*subject.channel);
  }
  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    return is_channel(segment, effect.subject) ? effect.values[0] * tension_N : tension_N;
  }
};

}  // namespace

const Cause& sensor_gain_cause() {
  static const SensorGain cause;
  return cause;
}

}  // namespace reeve::causes
