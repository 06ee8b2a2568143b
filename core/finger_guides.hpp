// Friction between the tendon and the guides at a finger's joints.
//
// A guide sits on the link before its joint j. The tendon wraps it by w_j + q_j: w_j with the hand
// open, and the flexion q_j besides. With the friction coefficient mu_j its exponent is
//
//   phi_j = mu_j (w_j + q_j)
//
// The tension solve puts all guides of a finger into the contact at its tip: Phi = phi_tip + 2 S_n,
// S_j = phi_1 + … + phi_j, as each strand passes all n guides. But where the finger closes by more
// than slides round its tip, both strands slide to the palm past every guide, and lose as much
// there: between the palm ends phi_tip alone counts, and in release likewise, both ways turned. By
// just as much: one strand rests at the palm. As the finger closes, its guides hold up to S_n
// either way; as it opens, and if blocks tie the tendon, they count as sliding. From the tensions
// T_l and T_r of both strands at the palm, e^{−Phi} <= T_l / T_r <= e^{Phi}, follow those behind
// guide j, which joint j feels:
//
//   T_l,j = max(T_l e^{−S_j}, T_r e^{−(Phi − S_j)})      and T_r,j likewise, l and r exchanged
//
// Each stretch carries the greater of what comes past the contacts from one palm end and from the
// other. Where the tendon slides round the tip from l to r, T_l = T_r e^{−Phi}: then T_r,j =
// T_r e^{−S_j} falls towards the tip and T_l,j = T_l e^{+S_j} rises towards it. Where it does not
// slide, in a held finger, the same law tells how far the tighter strand loads the other one: round
// the tip and up to the palm if T_l / T_r is at an end of the cone, up to some contact otherwise.
// If both palm ends are pulled alike, each strand is loaded from the palm.
//
// Derivation: no length is imposed between both palm ends of a held finger, so that in u = ln T the
// potential of tension.hpp is Σ L_i e^{u_i} over the stretches there. Its minimum over the cones
// |u_l − u_r| <= phi_k is the least u that they allow: the greater of both falling lines. It keeps
// all cones, as the greater of two functions does that change by at most phi_k at contact k; and at
// the palm it is T_l and T_r themselves.
//
// Two flexors that no tip joins are each loaded from the palm. An extensor passes the same guides
// on the finger's back. As the finger closes, its strand slides to the tip, and its tension may
// rise by e^{+S_j} up to behind guide j, which is what counts:
//
//   P_j = T_flexor e^{−S_j} − T_extensor e^{+S_j}
//
// Where contacts scatter, or a model changes the exponent of the tip, tip and guides change by the
// same factor. At the end of the range of a finger that closes, S_j and Phi are those of that
// posture.
//
// Assumptions: Coulomb friction; both strands pass guides of equal wrap; a strand slides one way at
// all of its guides, as at the palm; the finger's own stretches are short beside the strands. The
// pulls of a grasp at the palm
// are those of the posture that holds.
// Source: capstan law (tension/tension.hpp), guide by guide; wrap = bend of the joint, as for
// tendon sheaths: M. Kaneko, T. Yamashita, K. Tanie, Basic considerations on transmission
// characteristics for tendon drive robots, ICAR, 1991.
#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "core/hardware.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/tension.hpp"

namespace reeve::core {

constexpr double in_rad(double degrees) { return degrees * std::numbers::pi / 180; }
constexpr double in_deg(double radians) { return radians * 180 / std::numbers::pi; }

// "pulley", "tube"; "" of none.
const char* guide_name(JointGuide guide);

// The joints with the coefficients of tubes and bearings where a guide has none of its own.
std::vector<FingerJoint> with_guide_coefficients(std::vector<FingerJoint> joints,
                                                 const Hardware& hardware);
std::vector<FingerJoint> without_guides(std::vector<FingerJoint> joints);

// True if the tendon loses tension at some joint.
bool has_guides(const std::vector<FingerJoint>& joints);

// mu (w + q), q in rad; 0 without a guide.
double guide_exponent(const FingerJoint& joint, double flexion_rad);

// S_n with every joint at the end of its range, and in the posture that holds.
double closed_exponent(const std::vector<FingerJoint>& joints);
double held_exponent(const std::vector<FingerJoint>& joints);

// Tensions of a finger's strands at the palm; an extensor's is negative.
struct FingerPull {
  double left_N = 0;   // T(2f−1)
  double right_N = 0;  // T(2f)
  // e^{−Phi} between both in the posture that holds; 0 if no contact joins them.
  double tip_decay = 0;
  double guide_factor = 1;  // S_j over that of the hardware

  double sum_N() const { return left_N + right_N; }
  // Returns P_j = T_l,j + T_r,j; `decay` = e^{−S_j} of the hardware.
  double behind_guide_N(double decay) const;
  // The same pull where `decay_ratio` = e^{−(S_n' − S_n)}, S_n' that of another posture.
  FingerPull in_posture(double decay_ratio) const;
};

// Pulls of fingers 1 … n at their numbers, while the carriage pulls. `mechanics` holds the
// exponents that the tensions were solved with.
using FingerPullArray = std::array<FingerPull, max_fingers + 1>;
FingerPullArray finger_pulls_of(const Network& network, const Mechanics& mechanics,
                                const TensionState& state);

}  // namespace reeve::core
