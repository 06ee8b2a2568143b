// One channel reads nothing of the first newtons: play in its mounting, a guide that sticks.
//
//   reading = max(0, T - d)
//
// d in N; 0: none. No literature range. Above d it is an offset of -d, and wherever sensors cannot
// read below 0 also below d: there it is called so (sensor_offset), and this is asked for only
// where some reading is below 0.
#include <algorithm>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class DeadZone final : public Cause {
 public:
  const char* name() const override { return "dead_zone"; }
  Reach reach() const override { return Reach::reading; }
  const char* meaning() const override {
    return "one force sensor reads nothing of the first newtons";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"width_N", "N", 0, {0, 10}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    return survey.reads_below_zero ? channel_subjects(survey) : std::vector<Subject>{};
  }
  SubjectKind subject_kind() const override { return SubjectKind::channel; }
  std::string subject_name(const Subject& subject) const override {
    return segment_name(*subject.channel);
  }
  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    const double width = effect.values[0];
    if (width == 0 || !is_channel(segment, effect.subject)) return tension_N;
    return std::max(0.0, tension_N - width);
  }
  bool reads_linearly() const override { return false; }
};

}  // namespace

const Cause& dead_zone_cause() {
  static const DeadZone cause;
  return cause;
}

}  // namespace reeve::causes
