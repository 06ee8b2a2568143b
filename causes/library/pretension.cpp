// Every strand carries a further tension that the motor does not give: springs that open the
// fingers, or a tendon that was knotted tight.
//
//   T_strand' = T_strand + T_p
//
// T_p in N; 0: none. Literature: soft gloves are mounted with 0 to 2 N (order of magnitude).
#include <algorithm>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class Pretension final : public Cause {
 public:
  const char* name() const override { return "pretension"; }
  Reach reach() const override { return Reach::reading; }
  const char* meaning() const override { return "every strand carries a further constant tension"; }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"tension_N", "N", 0, {0, 10}, Range{0, 2}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = std::any_of(survey.channels.begin(), survey.channels.end(), is_strand);
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    return is_strand(segment) ? tension_N + effect.values[0] : tension_N;
  }

 private:
  static bool is_strand(const Segment& segment) { return segment.kind == SegmentKind::strand; }
};

}  // namespace

const Cause& pretension_cause() {
  static const Pretension cause;
  return cause;
}

}  // namespace reeve::causes
