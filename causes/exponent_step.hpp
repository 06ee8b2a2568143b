// A step of Newton's method for friction exponents that depend on the tensions that they bring
// about: phi_k = f_k(T_high,k).
//
// To first order, with v = d ln T of a segment and d phi_k = way_k + slope_k v_high,
//
//   v_high = v_low + d phi_k          across a contact at the limit of its cone
//   Σ L_i T_i v_i = y Σ L_i T_i       over a run of segments between contacts that are not: a run
//                                     keeps its take-up, up to the scale y that all share
//   Σ T_i v_i = 0                     over the motor-side segments, which carry T_M; or y = 0
//                                     where the take-up is given in place of T_M
//
// Along a run each v is linear in that of its first segment, so that a step costs a few products a
// contact. Assumes that the contacts that slide, and those at the limit of their cone, stay those;
// where they do not, the step is worse than it could be, but what it leads to, being solved again,
// is as true. Not for networks with floating blocks, whose balances it does not know.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/tension.hpp"

namespace reeve::causes {

// Parallel to the contacts.
struct ExponentErrors {
  std::vector<double> way;    // f_k(T_high,k) - phi_k
  std::vector<double> slope;  // d f_k / d ln T_high,k
};

// What stays as the exponents change.
enum class Prescribed : std::uint8_t { motor_tension, take_up };

// Keeps its memory.
class ExponentStep {
 public:
  // The changes d phi_k, valid until the next call. The state is that of these mechanics.
  const std::vector<double>& changes(const Network& network, const Mechanics& mechanics,
                                     const TensionState& state, const ExponentErrors& errors,
                                     Prescribed prescribed = Prescribed::motor_tension);

 private:
  struct Place {
    const Network& network;
    const Mechanics& mechanics;
    const std::vector<double>& tension;
    const ExponentErrors& errors;
  };

  void relate(const Place& place, const TendonSpan& tendon);
  void go_on(const Place& place, std::size_t contact, std::size_t from, std::size_t to);
  void end_run(const Place& place);
  double motion(std::size_t segment) const;

  // v_i = gain_i y + shift_i; within a run first in place of y the v of its first segment.
  std::vector<double> gain_;
  std::vector<double> shift_;
  std::vector<std::size_t> run_;  // its segments
  double motor_gain_ = 0;
  double motor_shift_ = 0;
  double scale_ = 0;  // y
  std::vector<double> changes_;
};

}  // namespace reeve::causes
