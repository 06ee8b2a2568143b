// One channel reads less than there is above a limit: an amplifier at the end of its range, a load
// cell at its stop.
//
//   reading = T - s (T - L)  above L      reading = T  up to L
//
// s in 1, from 0 (all is read) to 1 (nothing beyond L): at s = 1 it is min(T, L). L in N. So there
// is a size that vanishes where nothing is cut, which a limit alone, infinite then, would not be.
// No literature range: the limit is that of the sensor. Asked for only of channels that are seen
// well below their greatest reading: one that reads the same throughout is at no limit, its load is
// the same. And only with limits among the readings.
#include <algorithm>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class Saturation final : public Cause {
 public:
  const char* name() const override { return "saturation"; }
  Reach reach() const override { return Reach::reading; }
  const char* meaning() const override {
    return "one force sensor reads less than there is above a limit";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"share", "1", 0, {0, 1}, std::nullopt, true},
            {"limit_N", "N", std::nullopt, {1, 100}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    return channel_subjects(survey.wide_channels);
  }
  SubjectKind subject_kind() const override { return SubjectKind::channel; }
  std::string subject_name(const Subject& subject) const override {
    return segment_name(*subject.channel);
  }
  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    if (!is_channel(segment, effect.subject)) return tension_N;
    return tension_N - effect.values[0] * std::max(0.0, tension_N - effect.values[1]);
  }
  // Below all readings the limit would be a gain and an offset.
  bool shows_between(double least_N, double greatest_N, const Effect& effect) const override {
    constexpr double well_above = 0.1;
    return effect.values[1] > least_N + well_above * (greatest_N - least_N);
  }
  bool reads_linearly() const override { return false; }
};

}  // namespace

const Cause& saturation_cause() {
  static const Saturation cause;
  return cause;
}

}  // namespace reeve::causes
