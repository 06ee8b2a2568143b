// Bounds on all open tendons without blocks that begin with the same walk.
//
// How far a tendon slips at a contact follows from what is in front of it and from the number m of
// its motor-side segments (evaluate/tendon_sums.hpp). So for a given m the tensions of a beginning
// stand to each other as in every tendon that begins so, but for contacts that do not slip. In a
// grasp
//
//   uniformity <= least / most strand tension of the beginning.
//
// Each motor-side segment loses at its sheath, or at the pulley beside it, what leaves at most
// E = e^{-phi} of its work, so with the power F = Σ |slip| |T_l − T_r| that tips and joins at the
// hand take, and the motor tension M,
//
//   efficiency <= E − F / M.
//
// The rest of the tendon has, in units of the tension between both, an F − λM of at least the least
// that any rest has: a recursion over its fingers from the last one. E − λ is a bound if F − λM of
// both together is not below 0. It is concave in λ, so that a chord between two λ bounds it, too.
//
// Beside other tendons, whose motor tension is at most M' for a take-up that adds up to m, each
// millimetre of tension counts as M'/m of motor tension.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/hardware.hpp"
#include "core/routing.hpp"
#include "search/enumerate/parts.hpp"
#include "search/evaluate/tree_spans.hpp"

namespace reeve::search {

class WalkBounds {
 public:
  // Tendons through so many fingers; no tip is anchored. The motor tension of others is at most
  // `motor_beside`.
  WalkBounds(const Hardware& hardware, const PartSet& parts, int fingers, double motor_beside);

  // Takes the first `passed` fingers of a walk, at least one and not all, and the join behind them.
  // Keeps what it knows of a beginning that the walk before has, too.
  void read(const Walk& walk, int passed);

  int most_motor_sides() const { return 2 * fingers_; }

  // Writes parts and, for each held finger, sums that no tendon with so many motor-side segments
  // exceeds: least and work of a motor tension of 1, most 1. False if there is no such tendon.
  bool outline(int motor_sides, TreeOutline& outline);

 private:
  static constexpr std::size_t lambdas = 9;
  using Costs = std::array<double, lambdas>;

  struct Law {
    double decay = 1;  // e^{-phi}
    double growth = 1;
  };

  // Slips of a tendon in a grasp, in units of 1/c.
  struct Flow {
    int motor_sides = 0;  // m
    int closing = 0;      // c, number of strands that close
    int held = 0;         // held finger, or 0
    double per_mm = 0;    // motor tension for each millimetre of tension

    // Behind so many motor-side segments, and strands up to the first of this finger.
    int slip_at_tip(int finger, int motor_sides_before) const;
    // … to the last of this finger.
    int slip_behind(int finger, int motor_sides_before) const;
  };

  // Bounds on a beginning, in units of the tension at its end.
  struct Beginning {
    double least = 0;  // of the strands; at most
    double most = 0;   // at least
    double ratio = 1;  // least / most of strands that no still contact parts
    double least_behind = 0;
    double most_behind = 0;  // of the strands behind the last still contact
    double loss = 0;         // F, at least
    double motor = 0;        // M, at most
  };

  // The beginnings of a walk that end at the first strand of one finger.
  struct Level {
    int motor_sides = 0;
    int pulleys = 0;
    std::vector<Beginning> beginnings;  // [motor sides of the tendon][held], held later: [finger]
  };

  enum class At { hand, carriage };

  Flow flow(int motor_sides, int held) const;
  std::size_t index(int motor_sides, int held) const;
  Costs& costs(int motor_sides, int held, int finger, int motor_sides_before);

  void find_costs(const Flow& flow);
  Costs from_tip(const Flow& flow, int finger, int before);
  Costs behind_finger(const Flow& flow, int finger, int before);
  Costs of_last(const Flow& flow, int before) const;
  Costs at_motor_side(const Flow& flow, Costs rest) const;
  Costs at_length(const Flow& flow, double length, Costs rest) const;
  Costs crossed(const Flow& flow, const Law& law, int slip, At at, const Costs& rest) const;

  const Law& tip(const Token& token) const;
  bool has_read(const Walk& walk, int level) const;
  void start(const Token& end);
  void pass(const Token& tip, const Token& join, int finger);
  void cross(const Flow& flow, const Law& law, int slip, At at, Beginning& beginning) const;
  void add_strand(const Flow& flow, Beginning& beginning) const;
  void add_motor_side(const Flow& flow, Beginning& beginning) const;
  void pass_join(const Flow& flow, const Token& join, int finger, Beginning& beginning) const;
  double efficiency(const Beginning& beginning, const Costs& rest) const;

  PartSet parts_;
  int fingers_;
  double motor_beside_;
  double strand_mm_;
  double motor_side_mm_;
  Law tube_;
  Law bearing_;
  Law sheath_;
  Costs lambda_{};
  int first_bounded_;  // finger from which rests are bounded
  std::vector<Costs> costs_;
  std::vector<Level> levels_;  // [finger]: up to its first strand
  int read_ = 0;               // the last level in use
  Walk walk_;                  // walk of the levels in use
};

}  // namespace reeve::search
