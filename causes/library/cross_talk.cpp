// One channel also reads a part of its neighbours: a frame that bends under them, wires side by
// side.
//
//   reading_j = T_j + c (T_{j-1} + T_{j+1})    neighbours: the columns beside it
//
// Columns in the order of the data; one that the routing does not have carries nothing, one whose
// cell is empty carries what the model says. c in 1; 0: none. No literature range: data sheets of
// multi-axis load cells give it for each. Of several such channels the earlier one is read first.
#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class CrossTalk final : public Cause {
 public:
  const char* name() const override { return "cross_talk"; }
  Reach reach() const override { return Reach::reading; }
  const char* meaning() const override {
    return "one force sensor also reads a part of its neighbours";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"part", "1", 0, {-0.3, 0.5}, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    return survey.channels.size() > 1 ? channel_subjects(survey) : std::vector<Subject>{};
  }
  SubjectKind subject_kind() const override { return SubjectKind::channel; }
  std::string subject_name(const Subject& subject) const override {
    return segment_name(*subject.channel);
  }
  void read(std::span<Sensor> sensors, const Conditions&, const Effect& effect) const override {
    Sensor* own = find_sensor(sensors, *effect.subject.channel);
    if (own == nullptr || !own->column) return;
    double beside_N = 0;
    for (const Sensor& sensor : sensors) {
      const bool is_beside = sensor.column && (*sensor.column + 1 == *own->column ||
                                               *own->column + 1 == *sensor.column);
      if (is_beside) beside_N += sensor.reading_N;
    }
    own->reading_N += effect.values[0] * beside_N;
  }
};

}  // namespace

const Cause& cross_talk_cause() {
  static const CrossTalk cause;
  return cause;
}

}  // namespace reeve::causes
