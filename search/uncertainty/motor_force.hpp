// The force and the stroke that the motor of a hand must have: one definition for all subcommands.
//
//   nominal   F_M, the objective motor_force: the greatest motor tension that a grasp asks for
//             (core/hand.hpp), over all grasps that are asked, at the nominal coefficients
//   p95       95 % quantile of F_M over draws of the coefficients (uncertainty.hpp)
//
//   stroke    the objective stroke, at the nominal coefficients
//
// With several motors, F_M of motor c is max F_g r_c over the grasps g: F_g is the least force of
// the motor that pulls hardest in c's group (core/hand_pulls.hpp) at which its fingers reach their
// forces, r_c the tension of c per newton of it. The objectives are those of the motors that need
// most.
//
// A motor is enough if it pulls with the quantile: then 95 % of the hands reach all wanted forces.
// Its stroke is enough if the hand closes by it.
//   least work  no lossless routing needs less than Σ P_f E_f over the fingers that close in a
//             grasp, the greatest of the grasps: P_f the pull for the wanted force and against the
//             springs without guides, E_f the excursion. In that grasp F_M D η = Σ p_f F_M E_f with
//             η <= 1 and p_f F_M >= P_f, so that F_M D is no less, whatever the routing
//
// The number is the same wherever it is asked of the same routing, model, grasps, draws and seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/routing.hpp"
#include "search/uncertainty/uncertainty.hpp"

namespace reeve::search {

// The number of draws if the user gives none.
inline constexpr std::size_t motor_draws = 1000;

struct MotorNeed {
  double force_N = 0;    // nominal
  double stroke_mm = 0;  // infinite if its carriage cannot move from the open hand
};

struct MotorForce {
  double nominal_N = 0;  // infinite if no force is enough
  // Infinite if none is in more than 5 % of the draws, or if one has more friction than contacts.
  double p95_N = 0;
  std::size_t draws = 0;
  std::uint64_t seed = 0;
  UncertaintyRanges ranges{};       // that the draws are of
  double stroke_mm = 0;             // infinite if the carriage cannot move from the open hand
  double closure = 1;               // at that stroke; below 1 if the carriage is then blocked
  bool leaves_out_springs = false;  // in series with tendons, whose stretch is not in the stroke
  double least_work_J = 0;
  std::vector<MotorNeed> motors{};  // of each motor

  bool is_met_by(double motor_N) const { return p95_N <= motor_N; }
};

// Returns nothing if the hardware has no hand, or does not know the fingers.
std::optional<MotorForce> motor_force(const Routing& routing, const UncertaintyOptions& options);

// Returns the least work of fingers 1 … `fingers`, 0 without a hand.
double least_work_J(const Hardware& hardware, int fingers, const GraspSet& grasps);

}  // namespace reeve::search
