// One channel's zero drifts while the data are taken.
//
//   reading = T + b s    s: the place of the reading in its file, from 0 (the first) to 1 (the
//   last)
//
// b in N over the whole file; 0: none. The clock is not asked: readings are taken as evenly spread,
// in the order of the file. No literature: bridges and amplifiers drift as they warm.
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class Drift final : public Cause {
 public:
  const char* name() const override { return "drift"; }
  Reach reach() const override { return Reach::reading; }
  const char* meaning() const override {
    return "the zero of one force sensor drifts from reading to reading";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"drift_N", "N", 0, {-20, 20}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    return channel_subjects(survey);
  }
  SubjectKind subject_kind() const override { return SubjectKind::channel; }
  std::string subject_name(const Subject& subject) const override {
    return segment_name(*subject.channel);
  }
  void read(std::span<Sensor> sensors, const Conditions& conditions,
            const Effect& effect) const override {
    Sensor* own = find_sensor(sensors, *effect.subject.channel);
    if (own != nullptr) own->reading_N += effect.values[0] * conditions.order;
  }
};

}  // namespace

const Cause& drift_cause() {
  static const Drift cause;
  return cause;
}

}  // namespace reeve::causes
