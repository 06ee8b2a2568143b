// Friction of tubes and sheaths runs in, or wears, with the number of loading cycles N.
//
//   phi' = phi (1 + beta (1 - e^{-N / N_0})), not below 0
//
// beta in 1; 0: none, negative: the liner runs in. N_0 in cycles, from 10 to 10^5. Literature: a
// transfer film of PTFE forms in tens to thousands of cycles and lowers friction by up to a half
// (order of magnitude; liners differ). A row without cycle is taken as new.
#include <algorithm>
#include <cmath>

#include "causes/cause.hpp"

namespace reeve::causes {
namespace {

class Wear final : public Cause {
 public:
  const char* name() const override { return "wear"; }
  Reach reach() const override { return Reach::conditions; }
  const char* meaning() const override {
    return "friction of tubes and sheaths runs in (or out) with the cycles";
  }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"change", "1", 0, {-1, 2}, Range{-0.5, 0.5}},
            {"cycles", "1", std::nullopt, {10, 1e5}, Range{10, 1e4}}};
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    const bool possible = survey.has_cycle && has_tube_or_sheath(survey);
    return possible ? std::vector<Subject>(1) : std::vector<Subject>{};
  }
  double exponent(double phi, const ContactLoad& contact, const Conditions& conditions,
                  const Effect& effect) const override {
    if (!is_tube_or_sheath(contact.kind)) return phi;
    const double worn = 1 - std::exp(-conditions.cycle / effect.values[1]);
    return phi * std::max(0.0, 1 + effect.values[0] * worn);
  }
};

}  // namespace

const Cause& wear_cause() {
  static const Wear cause;
  return cause;
}

}  // namespace reeve::causes
