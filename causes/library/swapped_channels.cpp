// Two columns are exchanged: plugs, or names in the logger.
//
//   column i has the reading of the sensor at j, and column j that of the sensor at i
//
// Gains, offsets and other faults are those of the sensors and travel with them. Routings that have
// only one of the two segments are left as they are. No size: it is so or not.
#include <utility>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class SwappedChannels final : public Cause {
 public:
  const char* name() const override { return "swapped_channels"; }
  Reach reach() const override { return Reach::reading; }
  const char* meaning() const override { return "two columns of tensions are exchanged"; }
  std::vector<Parameter> parameters(const Hardware&) const override { return {}; }
  std::vector<Subject> subjects(const Survey& survey) const override {
    return channel_pair_subjects(survey);
  }
  SubjectKind subject_kind() const override { return SubjectKind::channels; }
  std::string subject_name(const Subject& subject) const override {
    return segment_name(*subject.channel) + "," + segment_name(*subject.other_channel);
  }
  void read(std::span<Sensor> sensors, const Conditions&, const Effect& effect) const override {
    Sensor* one = find_sensor(sensors, *effect.subject.channel);
    Sensor* other = find_sensor(sensors, *effect.subject.other_channel);
    if (one != nullptr && other != nullptr) std::swap(one->reading_N, other->reading_N);
  }
};

}  // namespace

const Cause& swapped_channels_cause() {
  static const SwappedChannels cause;
  return cause;
}

}  // namespace reeve::causes
