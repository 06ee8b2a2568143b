#include "core/finger_guides.hpp"

#include <algorithm>
#include <utility>

namespace reeve::core {
namespace {

// Length per travel by which the tendon slides round each fingertip, from its left strand to its
// right one.
struct TipSlip {
  std::size_t left = 0;
  std::size_t right = 0;
  double slip = 0;
};

std::array<TipSlip, max_fingers + 1> tip_slips(const Network& network, const TensionState& state) {
  std::array<TipSlip, max_fingers + 1> slips{};
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const Contact& contact = network.contacts[tendon.first_contact + k];
      if (contact.place != ContactPlace::tip) continue;
      const ContactEnds ends = ends_of(tendon, k);
      slips[static_cast<std::size_t>(contact.finger)] = {ends.left, ends.right,
                                                         state.slip[tendon.first_contact + k]};
    }
  }
  return slips;
}

}  // namespace

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
    sum += guide_exponent(joint, in_rad(joint.held_deg.value_or(joint.range_deg)));
  }
  return sum;
}

FingerPullArray finger_pulls_of(const Network& network, const TensionState& state) {
  // The slip of a symmetrical loop misses 0 by a rounding error.
  constexpr double rounding = 1e-9;
  const auto slips = tip_slips(network, state);
  FingerPullArray pulls{};
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind != SegmentKind::strand) continue;
    const auto f = static_cast<std::size_t>(segment.finger);
    const TipSlip& tip = slips[f];
    const bool has_tip = tip.left != tip.right;
    const double leaves = !has_tip ? 0 : i == tip.left ? tip.slip : i == tip.right ? -tip.slip : 0;
    const double given = state.closing[f - 1];
    const bool outward = leaves > rounding && given - leaves <= rounding;
    (outward ? pulls[f].outward_N : pulls[f].inward_N) += state.tension[i];
  }
  return pulls;
}

}  // namespace reeve::core
