#include "catalog/mechanisms/named_values.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/finger_closing.hpp"
#include "core/hand.hpp"
#include "core/performance.hpp"

namespace reeve::catalog {
namespace {

void add_law(NamedValues& values, const std::string& part, const ContactLaw& law) {
  values["mu_" + part] = law.mu;
  values["theta_" + part] = law.whole_angle_rad();
}

// q1, q2, …: joint angles of finger 1 in free motion, deg, at the excursion that the rig names.
void add_angles(NamedValues& values, const MechanismRig& rig) {
  const auto excursion = rig.let.find("excursion_mm");
  const auto known = hand(rig.hardware);
  if (excursion == rig.let.end() || !known || known->finger(1).joints.empty()) return;
  const FingerPosture posture = closing_posture(known->finger(1).joints, excursion->second);
  for (std::size_t j = 0; j < posture.flexion_rad.size(); ++j) {
    values[fmt::format("q{}", j + 1)] = in_deg(posture.flexion_rad[j]);
  }
}

}  // namespace

NamedValues named_values(const MechanismRig& rig, const Network& network, const TensionState& state,
                         Direction direction) {
  NamedValues values;
  add_law(values, "t", rig.hardware.tube);
  add_law(values, "b", rig.hardware.bearing);
  add_law(values, "block", rig.hardware.block.value_or(rig.hardware.bearing));
  add_law(values, "s", rig.hardware.sheath);
  values["T_M"] = 1;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    values[segment_name(network.segments[i])] = state.tension[i];
  }
  for (std::size_t f = 0; f < state.closing.size(); ++f) {
    values[fmt::format("dl{}", f + 1)] = state.closing[f];
  }
  const Performance figures = performance(network, state, direction);
  values["efficiency"] = figures.efficiency;
  values["uniformity"] = figures.uniformity;
  add_angles(values, rig);
  for (const auto& [name, value] : rig.let) {
    if (values.contains(name)) {
      throw InputError({.what = "let",
                        .value = name,
                        .expected = "a name that no segment or coefficient has",
                        .form = InputForm::option});
    }
    values[name] = value;
  }
  return values;
}

NamedValues solved_values(const PublishedNumber& number, const MechanismRig& rig) {
  const Network network = expand(number.routing);
  const TensionState state =
      tensions(network, mechanics(network, rig.hardware), number.grasp, number.direction);
  return named_values(rig, network, state, number.direction);
}

}  // namespace reeve::catalog
