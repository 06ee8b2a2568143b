// Computes the carriage travel that springs in series with tendons take, and what they store.
//
// A spring of stiffness k at the motor-side end a of a tendon stretches by T_a / k. With fingers at
// excursions x_f, the equation of each tendon of a tree (tension/tree_kinematics.hpp) is
//
//   Σ_a w_a (v_a r_a D − T_a / k_a) + blocks = Σ_f c_f x_f
//
// w the segment's weight, v r the travel of the end over that of the carriage. Weighted by the
// tensions λ of the tendons that balance at the blocks without friction, their sum has no block:
//
//   λ·m D = Σ_f λ·c_f x_f + Σ_a λ_a w_a T_a / k_a,    m = Σ_a w_a v_a r_a of each tendon
//
// So springs add to the travel that brings the fingers to x_f, whatever their way there,
//
//   ΔD = Σ_a λ_a w_a T_a / k_a / λ·m
//
// which is T_a / k_a for a tendon with one motor side, and a third of it if two further sides of
// the same tendon hang on the carriage. T_a are the tensions of the grasp (tension/tension.hpp), in
// proportion to the motor tension F.
//
// They are the tensions of a stiff tendon, and also those of fingers that close in proportion to F,
// if every contact slides in spite of the stretch as it does without:
//
//   D₀ ds_k + F dσ_k  has the sign of  ds_k
//
// D₀ is the travel that closes the fingers, ds the slip per D₀, dσ that per newton at fingers that
// stand. That need not hold if several ends of a tree hang on the carriage: tendon slips out of the
// sheath of a soft spring. Where nothing slides with friction as springs stretch, at one motor side
// or without friction, F alone sets T_a.
//
// Trees on one carriage take up alike (tension/tension.hpp). Their ΔD differ by the own stretch of
// their tendons, which no stroke counts; the greatest ΔD counts.
//
// Energy: springs store Σ T_a² / 2 k_a. While F rises from 0 and nothing else moves, the motor does
// ∫ F dΔD = F ΔD / 2: what springs store, if nothing slides with friction then. Otherwise the work
// depends on the way, and only F ΔD bounds it. Several trees part F otherwise on the way than at
// its end.
//
// A tree with slack s is closed at D₀ = (s + Σ c_f x_f) / m and stretches from there on, as without
// slack. If trees on one carriage are closed at D₀ of their own, F is Σ (D − D₀) over ΔD per newton
// of each: not in proportion to the pulls, which the shares by slack (tension/kinematics.hpp) are.
//
// Not counted: a hand that is not closed by its stroke, or by no motor force. Fingers would close
// further than they do with stiff tendons, by what other trees stretch.
//
// Not known: several motors, second tendons of a finger, seized contacts, slack of a tree beside
// others on one carriage, and blocks that tie so many tendons together that springs of unlike
// stretch move fingers.
#pragma once

#include <limits>

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"

namespace reeve::core {

struct TensionState;

struct SeriesStretch {
  double travel_mm_N = 0;   // ΔD per newton of motor tension
  double stored_mJ_N2 = 0;  // energy in the springs per its square
  double sliding_mm_N = 0;  // least D₀ per newton with which all contacts slide as they do
  // Motor tension at which a hand closes by no more than that.
  double most_N = std::numeric_limits<double>::infinity();
  bool is_known = true;
  bool is_lossless = true;  // true if the motor does no other work while the springs stretch

  double travel_mm(double motor_N) const { return travel_mm_N * motor_N; }
  double stored_J(double motor_N) const;
  // Greatest work of the motor as the springs stretch: what they store, if that is all.
  double work_J(double motor_N) const;
};

// The state of a pull, at motor tension 1.
SeriesStretch series_stretch(const Network& network, const Mechanics& mechanics, const Grasp& grasp,
                             const TensionState& state);

// True if trees share a motor's force and slack is given.
bool shares_slack(const Network& network, const Mechanics& mechanics);

// The stretch that is enough for two grasps with the same open hand.
SeriesStretch greatest(const SeriesStretch& one, const SeriesStretch& other);

// True if a hand with this closure and motor force is closed in a known state.
bool is_counted(const SeriesStretch& stretch, double closure, double motor_N);

}  // namespace reeve::core
