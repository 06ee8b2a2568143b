// Computes the forces at the fingertips that one routing gives a hand, and the demand on the motor.
//
//   motor force F     least motor tension at which every finger presses with its wanted force in
//                     every grasp (core/hand.hpp), at the nominal coefficients
//                     (with several motors, of the one that needs most: motor_force.hpp)
//   stroke D          of the carriage from the open hand (core/hand_closing.hpp), and what springs
//                     in series take at F in the same grasp (core/series_stretch.hpp), the greatest
//                     over the grasps: D = max (D₀ + ΔD)
//   speed             D over the time to close
//   work              Σ F (D₀ − S) over the motors, at most, if the hand closes against F all the
//                     way behind the travel S on which all tendons are slack; and the work of
//                     stretching springs in series while the force rises to F; the greatest over
//                     the grasps
//   power             Σ F D over the time to close, at most
//   torque            F times the spool's radius; the spool turns with speed over radius
//   friction cost     1 − F0 / F, F0 the motor force of the same hand without any friction
//
// The work of one motor parts into what the springs keep, in fingers and in series, what friction
// takes, and what is left to the fingers: work at objects and stops. In a finger that does not
// close whole, all joints stand at the same share of their ranges. Friction and fingers are not
// told apart if springs in series stretch with other work than what they store.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/finger_closing.hpp"
#include "core/grasp.hpp"
#include "core/hand.hpp"
#include "core/hand_closing.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "search/uncertainty/motor_force.hpp"

namespace reeve::studies {

// Capability of a motor of a given force and stroke with a hand.
//
//   share of the wanted   least F_f / F_w,f over fingers f and grasps, F_f the fingertip force at
//   the
//                         motor's force: so much of all wanted forces can be had at once. 0 if a
//                         finger that is not held cannot even close against its springs
//   closure               share of its range that the finger closes that closes least, the carriage
//                         going no further than the motor's stroke
struct ForceReach {
  double motor_N = 0;
  // Share of the wanted forces; infinite if no finger wants any.
  double share = 0;
  // The finger that has least of it, of several the one that asks for most motor force; 0: none
  // wants any.
  int weakest = 0;
  Grasp grasp{};  // and the grasp in which it has
  double asks_motor_N = 0;
  std::size_t joint = 0;              // its joint that gives first then, from 0
  double force_N = 0;                 // its fingertip force
  std::optional<double> stroke_mm{};  // at this motor tension; nothing if no stroke is known
};

struct StrokeReach {
  double stroke_mm = 0;  // used part of the stroke
  double closure = 0;
  double stretch_mm = 0;  // part that springs in series take, at this motor tension
  double stretch_N = 0;
  std::vector<int> last;       // the fingers that close least
  std::vector<double> closed;  // share of each finger's range
};

// Closing from one open hand, with stiff tendons, and how springs in series stretch then: the most
// of the grasps that differ in the fingers that they hold alone.
struct ShownWay {
  Grasp open{};
  HandClosing closing{};
  MotorArray loaded_mm{};     // travel of each motor on which some tendon is not slack
  double to_fingers_J_N = 0;  // work that reaches the fingers, per newton of one motor
  SeriesStretch stretch{};

  double stroke_mm(double motor_N) const { return closing.stroke_mm + stretch.travel_mm(motor_N); }
};

// Adds a grasp.
void add_grasp(const Hand& hand, int fingers, Grasp grasp, const HandPulls& pulls,
               ForceReach& reach);

struct ShownFingerForce {
  int finger = 0;
  FingerPull pull_per_motor{};         // pull of its strands at the palm, N/N
  double per_motor_N = 0;              // at the fingertip, N/N, springs aside
  double asks_motor_N = 0;             // infinite if its strands are slack
  double force_N = 0;                  // at the hand's motor force; 0 if that is infinite
  std::size_t gives = 0;               // the joint that gives first then, from 0
  std::optional<double> at_limit_N{};  // at the force that the motor can pull with
};

struct ShownHandGrasp {
  Grasp grasp;
  double motor_force_N = 0;
  double frictionless_N = 0;
  int weakest = 0;
  MotorArray motors_N{};  // force of each motor
  SeriesStretch stretch{};
  std::vector<ShownFingerForce> fingers;
};

struct ShownHandFinger {
  int finger = 0;
  double wanted_N = 0;
  double excursion_mm = 0;
  double closed = 0;  // share of its range at the end of the stroke
};

// Why no motor pulls a finger.
enum class NoPull : std::uint8_t {
  blocked,
  opposed,  // by its extensor
  blocked_at_springs,
  ends_locked,
  ends_stand_still,
  still_slack
};

struct MotorDemand {
  double force_N = 0;
  double frictionless_N = 0;
  MotorArray motors_N{};    // of each motor
  MotorArray strokes_mm{};  // likewise; infinite if its carriage is blocked
  int weakest = 0;          // the finger that asks for it,
  std::size_t joint = 0;    // its joint that does, from 0,
  Grasp grasp{};            // and the grasp in which it does
  NoPull no_pull{};         // if it has no pull in that grasp, and force_N is infinite
  double stroke_mm = 0;
  double closure = 0;
  double speed_mm_s = 0;
  double work_J = 0;
  double power_W = 0;
  double springs_J = 0;
  double friction_J = std::numeric_limits<double>::quiet_NaN();  // if it is told apart
  double fingers_J = std::numeric_limits<double>::quiet_NaN();   // likewise
  std::vector<ShownWay> ways{};
  // Of springs in series on the way with the greatest stroke, if strokes count it; otherwise no way
  // has one.
  std::optional<SeriesStretch> stretch{};
  double series_J = 0;  // that these springs store of the work
  std::optional<double> torque_Nm{};
  std::optional<double> spool_rpm{};

  // Otherwise the carriage is blocked from the open hand on: there is no stroke, nor what follows
  // from one.
  bool can_move() const { return stroke_mm > 0; }
  // Part of the stroke that springs in series take.
  double stretch_mm() const { return stretch ? stretch->travel_mm(force_N) : 0; }
  double friction_cost() const { return force_N > 0 ? 1 - frictionless_N / force_N : 0; }
};

// The closing in free motion of fingers that are alike (core/finger_closing.hpp).
struct ShownClosing {
  std::vector<int> fingers;
  std::vector<FingerJoint> joints;
  FingerClosing motion;
};

struct ShownHand {
  std::vector<ShownHandFinger> fingers;
  std::vector<ShownHandGrasp> grasps;
  GraspSet opening{};  // grasps that open fingers, and that nothing here counts
  MotorDemand demand;
  MotorParts motor;
  int motors = 1;
  bool springs = false;  // in series with tendons
  bool leaves_out_springs() const { return springs && !demand.stretch; }
  // Carriage travel at which trees on one carriage share the motor force, if one of them has slack.
  std::optional<double> slack_shared_at_mm{};
  // Of several motors each by itself, from the open hand on: the other carriages stand still.
  std::vector<HandClosing> motors_alone{};
  // The motor force with its quantile over draws, where somebody asked for it; its nominal one is
  // that of the demand.
  std::optional<MotorForce> drawn{};
  // Reach with the motor's own force and stroke, if these are given (motor_reach.hpp).
  std::optional<ForceReach> force_reach{};
  std::optional<StrokeReach> stroke_reach{};
  std::vector<ShownClosing> closings{};  // closing of the fingers with a guide or an object
};

// Nothing if the hardware has no hand or does not know all fingers, or if all grasps open fingers.
// Pulling, whatever is shown.
std::optional<ShownHand> shown_hand(const Network& network, const std::string& word,
                                    const Model& model, const GraspSet& grasps);

}  // namespace reeve::studies
