#include "core/finger_guides.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::core {
const char* guide_name(JointGuide guide) {
  constexpr const char* names[] = {"", "pulley", "tube"};
  return names[static_cast<std::size_t>(guide)];
}

std::vector<FingerJoint> with_guide_coefficients(std::vector<FingerJoint> joints,
                                                 const Hardware& hardware) {
  for (FingerJoint& joint : joints) {
    if (joint.guide == JointGuide::none || joint.mu) continue;
    joint.mu = joint.guide == JointGuide::tube ? hardware.tube.mu : hardware.bearing.mu;
  }
  return joints;
}

std::vector<FingerJoint> without_guides(std::vector<FingerJoint> joints) {
  for (FingerJoint& joint : joints) joint.guide = JointGuide::none;
  return joints;
}

bool has_guides(const std::vector<FingerJoint>& joints) {
  return std::any_of(joints.begin(), joints.end(),
                     [](const FingerJoint& joint) { return joint.guide != JointGuide::none; });
}

double guide_exponent(const FingerJoint& joint, double flexion_rad) {
  if (joint.guide == JointGuide::none) return 0;
  return joint.mu.value_or(0) * (in_rad(joint.wrap_deg) + flexion_rad);
}

double closed_exponent(const std::vector<FingerJoint>& joints) {
  double sum = 0;
  for (const FingerJoint& joint : joints) {
    sum += guide_exponent(joint, in_rad(joint.range_deg));
  }
  return sum;
}

double held_exponent(const std::vector<FingerJoint>& joints) {
  double sum = 0;
  for (const FingerJoint& joint : joints) {
    sum += guide_exponent(joint, in_rad(joint.held_flexion_deg()));
  }
  return sum;
}

double FingerPull::behind_guide_N(double decay) const {
  if (guide_factor != 1) decay = std::pow(decay, guide_factor);
  if (decay == 1) return sum_N();
  if (right_N < 0) return left_N * decay + right_N / decay;
  const double round_tip = tip_decay / decay;
  return std::max(left_N * decay, right_N * round_tip) +
         std::max(right_N * decay, left_N * round_tip);
}

FingerPull FingerPull::in_posture(double decay_ratio) const {
  FingerPull pull = *this;
  if (decay_ratio != 1) pull.tip_decay *= std::pow(decay_ratio, 2 * guide_factor);
  return pull;
}

FingerPullArray finger_pulls_of(const Network& network, const Mechanics& mechanics,
                                const TensionState& state) {
  FingerPullArray pulls{};
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind != SegmentKind::strand) continue;
    FingerPull& pull = pulls[static_cast<std::size_t>(segment.finger)];
    (segment.number % 2 == 1 ? pull.left_N : pull.right_N) = segment.way() * state.tension[i];
  }
  for (std::size_t k = 0; k < network.contacts.size(); ++k) {
    const Contact& contact = network.contacts[k];
    if (contact.place != ContactPlace::tip) continue;
    FingerPull& pull = pulls[static_cast<std::size_t>(contact.finger)];
    pull.tip_decay = mechanics.decay[k];
    const double plain = mechanics.guided_tips.empty() ? 0 : mechanics.guided_tips[k].phi;
    if (plain > 0) pull.guide_factor = mechanics.phi[k] / plain;
  }
  return pulls;
}

}  // namespace reeve::core
