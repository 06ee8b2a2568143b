// A second, independent solver of the tension model, for tests only. It shares no code and no
// method with the library that it judges.
//
// Model. A tendon is a path (or a closed loop) of segments i with tension T_i = e^{u_i}, length
// L_i and EA = 1, joined by contacts k with friction exponent phi_k = mu * angle. Carriage and
// fingers impose e_i = e0_i + eps E_i on segment i; the tensions minimise
//
//     sum_i [ L_i e^{u_i} - (E_i + e0_i / eps) u_i ]   subject to |u_left - u_right| <= phi_k
//
// in the limit eps -> 0 of a nearly inextensible tendon (u is counted from ln eps). With D = 1:
//
//     pull             e0 = +1 on motor-side segments, -dl on the strands of closing fingers;
//                      E = +dl on those strands
//     release          e0 reversed; E = +1 on motor-side segments
//     jammed pull      e0 = 0; E = 1 on motor-side segments
//     jammed release   e0 = 0; E = L (the same strain) on all the others
//
// Carriages of several motors travel v_c D: in each line the +1 of a motor-side segment is v_c, and
// E = max(0, -e0) but where a tendon jams. A tendon whose carriages stand still carries nothing. An
// end on a spool of its own has r v_c in place of v_c, and pulls its motor with r T.
//
// dl is shared among the closing fingers of a tendon by weight so that its e0 sums to zero; a
// tendon without closing finger jams, and then the jammed tendons carry the whole motor tension.
//
// For eps below a threshold the minimiser no longer depends on eps (exact regularisation of the
// linear program that e0 poses), so that nothing is extrapolated. Tendons that share fingers close
// them as reference_shared.hpp says. Blocks (reference_tree.hpp) join tendons into trees; a tendon
// without blocks is a tree alone. With z_b the movement of block b,
//
//     sum of c_i (e0_i + C_i z) = 0 along each tendon     gives dl, one for the closing fingers of
//                                                         a tree, and z; D = 1
//     sum_i C_ib T_i = 0 for each block                   gives the z at order eps
//
// The balances are no part of the potential, so cones, lengths and balances are solved together: an
// interior-point method (reference_tree_interior.hpp) finds which contacts are at a bound; from
// these the limit is solved in closed form (reference_tree_limit.hpp) and its conditions are
// verified. An unverified answer is never returned.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace reeve::testing {

/// phi = mu * angle.
struct ReferenceLaw {
  double mu;
  double angle;
};

struct ReferenceHardware {
  ReferenceLaw tube, bearing, sheath;
  double strand_length = 1, motor_side_length = 1, hand_length = 1;
  /// Friction exponent of one contact, by the names of its left and right segment.
  std::function<double(const std::string& left, const std::string& right, double nominal_phi)>
      phi_override;
  std::function<double(const std::string& segment, double nominal)> length_override;
  /// Fingers that are not listed have weight 1.
  std::map<int, double> closing_weight;
  /// Of a sheave of a floating block; the bearing's if it is not given.
  std::optional<ReferenceLaw> block = std::nullopt;
  /// v_c, travel of carriage c over D; carriages that are not listed have 1.
  std::map<int, double> carriage_travel = {};
  /// r of the ends at motors that have spools of their own, by segment; they travel r v_c D.
  std::map<std::string, double> spool = {};
  /// Motor-side segments whose ends stand still and pull no motor.
  std::set<std::string> locked = {};
  /// s / D of the tendon that the segment belongs to: with m the travel of its motor sides, it
  /// carries nothing while m <= s / D, and then has 1 - s / (m D) of E.
  std::map<std::string, double> slack = {};
};

enum class ReferenceDirection { pull, release };

/// Its two segments, in walk order.
using ContactName = std::pair<std::string, std::string>;

struct ReferenceContact {
  std::string left, right;
  std::string kind;  ///< "tube", "bearing", "sheath", "block" or "bar"
  double phi;
  /// From left to right, in the limit, at D = 1; 0 everywhere if the grasp jams. The free
  /// circulation of a loop minimises sum phi |slip|; from an interval of minimisers, its middle.
  /// At a block, relative to it; of a bar, half the difference of its arms' movements.
  double slip;
};

struct ReferenceResult {
  bool jams;
  /// Tendons that share fingers ask for two closings: the grasp jams, and only that is said.
  bool opposed = false;
  /// By segment name (T1, ...; a, b, ...; h1, ...); the motor-side segments sum to 1, each
  /// times its spool's r.
  std::map<std::string, double> tension;
  std::vector<ReferenceContact> contacts;
  /// Finger -> dl at D = 1 (its opening, in release), below 0 if extensors pull; 0 if held or if
  /// the grasp jams.
  std::map<int, double> closing;
};

/// `word` must be valid: tokens M F T B P, M2 and P2 and so on, fingers, plain or with suffix b, 1x
/// or 1e at an end, and blocks Y1, Y1k, W1, W1/2:1. Throws std::invalid_argument on any other
/// token, on a tendon (a tree) without motor-side segment, and with blocks: on one without tail or
/// without pass and becket or that hangs on itself, on a bar with more than one pass or with
/// unequal arms in a loop, where the motion of the blocks is not determined, where it would open a
/// finger and where tendons share fingers. std::logic_error if the conditions could not be met.
ReferenceResult reference_tensions(const std::string& word, const std::set<int>& held,
                                   ReferenceDirection direction, const ReferenceHardware& hardware);

}  // namespace reeve::testing
