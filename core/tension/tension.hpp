// Tensions of a routing in a grasp, at motor tension T_M = 1.
//
// Contact law (capstan): where the tendon slides from the left segment to the right one,
// T_l = T_r e^{-phi}; the other way, T_r = T_l e^{-phi}; where it does not slide,
// e^{-phi} <= T_l / T_r <= e^{phi}. At a movable pulley "slides" is relative to the pulley.
//
// Directions are derived, never given: of all tensions and slips that carriage and fingers allow,
// nature takes those that minimise, in u = ln T, Σ_i [ L_i e^{u_i} − e_i u_i ] over the capstan
// cone. Reported is the limit of a nearly inextensible tendon (take-up a fraction epsilon -> 0 of
// the carriage's travel; kinematics.hpp): contacts that slide are exact ratios, and only contacts
// that do not slide need the elastic part (elastic_chain.hpp). On a loop, some contact is always
// still; opened there, the loop is a chain.
//
// Assumptions: quasi-static, proportional loading from a slack tendon, massless tendon of constant
// EA, Coulomb friction that does not depend on load or speed. Several tendons hang on one carriage
// and take up the same fraction of their travel; one that jams takes the whole motor tension. With
// several motors T_M is the sum of their tensions, and the grasp says how their carriages move. An
// end on a spool of its own travels r D, so that T_M = Σ r_i T_i over the motor-side segments. An
// end that the grasp locks travels 0, and its tension is no part of T_M; a tendon all of whose ends
// are locked carries nothing. Springs in series and slack: mechanics.hpp, kinematics.hpp.
// Tendons that floating blocks and bars tie together are solved as one (tree_tension.hpp).
// Source: Exo-Glove II supplement, Eqs. 1–24, which this reproduces for the grasp "finger 1 held".
#pragma once

#include <array>
#include <vector>

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/elastic_chain.hpp"
#include "core/tension/kinematics.hpp"
#include "core/tension/tension_fault.hpp"
#include "core/tension/tree_tension.hpp"

namespace reeve::core {

// Arrays parallel to the network's segments, contacts and fingers.
struct TensionState {
  bool jams = false;     // no finger of some tendon can move: the carriage is blocked
  bool in_range = true;  // otherwise the tensions are no numbers
  TensionFault fault = TensionFault::none;  // and this says why
  int opposed = 0;              // finger that a second tendon does not let move: why it jams
  std::vector<double> tension;  // N per N of motor tension; T_M is 1
  std::array<double, max_carriages> motor_tension{};  // likewise, of each motor's carriage
  double motor_work = 1;                              // Σ T_M D over the motors, per T_M D
  std::vector<double> slip;                           // left to right, per unit of carriage travel
  std::vector<double> closing;  // dl of fingers 1 … n, per unit of carriage travel
  // Travel of the blocks towards their tails, likewise; in release, back from there.
  std::vector<double> block_travel;
};

// Keeps its memory from call to call: in the steady state a solve allocates nothing.
class TensionSolver {
 public:
  // Says in the state whether it has tensions.
  void solve(const Network& network, const Mechanics& mechanics, Grasp grasp, Direction direction,
             TensionState& state);

  // The same before the motor-side tensions are made to add up to 1: what several tendons on one
  // carriage, or trees of them, share is the scale alone, and which of them jam.
  void solve_relative(const Network& network, const Mechanics& mechanics, Grasp grasp,
                      Direction direction, TensionState& state);

  // The solve before, with other friction: `state` is what it left. What carriage and fingers
  // impose stays, but for what goes round a loop.
  void solve_again(const Network& network, const Mechanics& mechanics, Grasp grasp,
                   Direction direction, TensionState& state);
  // Likewise behind solve_relative().
  void solve_relative_again(const Network& network, const Mechanics& mechanics, Grasp grasp,
                            Direction direction, TensionState& state);

 private:
  const Mechanics& past_guides(const Network& network, const Mechanics& mechanics);
  void solve_in_motion(const Network& network, const Mechanics& mechanics, TensionState& state);
  void solve_tendons(const Network& network, const Mechanics& mechanics, TensionState& state);
  void solve_tendon(const Network& network, const TendonSpan& tendon, const Mechanics& mechanics,
                    TensionState& state);
  void solve_open(const Network& network, const TendonSpan& tendon, const Mechanics& mechanics,
                  std::size_t first, TensionState& state);
  void add_contact(const Network& network, const Mechanics& mechanics, const TendonSpan& tendon,
                   std::size_t contact);
  void solve_tree(const Network& network, const Mechanics& mechanics, std::size_t tree,
                  TensionState& state);
  bool begins_tree(const Network& network, std::size_t tendon) const;
  void solve_loop(const Network& network, const TendonSpan& tendon, const Mechanics& mechanics,
                  TensionState& state);

  Kinematics kinematics_;
  Motion motion_;
  ElasticChain chain_;
  TreeTension tree_tension_;
  std::vector<ChainSegment> segments_;
  std::vector<ChainContact> contacts_;
  std::vector<std::size_t> places_;  // of the segments in the chain
  std::vector<double> chain_tension_;
  Mechanics past_guides_;
};

// Returns the tension of each motor that the network has.
std::vector<double> motor_tensions(const Network& network, const TensionState& state);

// The exponent by which the tension falls across a contact that slides in this state: without the
// guides of a tip's finger where both strands pass them alike (finger_guides.hpp).
double sliding_exponent(const Network& network, const Mechanics& mechanics, std::size_t contact,
                        const TensionState& state);

// The state itself, of this grasp. Throws OutOfRange that names the grasp if it has no tensions.
const TensionState& require_in_range(const TensionState& state, Grasp grasp);

// Throws OutOfRange.
TensionState tensions(const Network& network, const Mechanics& mechanics, Grasp grasp,
                      Direction direction = Direction::pull);

}  // namespace reeve::core
