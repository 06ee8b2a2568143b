// How much mountings of a routing differ (mounting.hpp), estimated from the differences between
// mountings of the same routing (mounted_comparison.hpp: A and b).
//
// With D = diag(τ²) the scatters are those of the greatest restricted likelihood (H. D. Patterson
// and R. Thompson, Biometrika 58, 1971)
//
//   −2 ℓ = ln |I + D^{1/2} A D^{1/2}| − bᵀ D^{1/2} (I + D^{1/2} A D^{1/2})⁻¹ D^{1/2} b
//
// times τ e^{−τ/s}, a gamma density of shape 2 about the assumed scatter s: where readings tell
// much it moves the estimate by about a standard error from 0, where they tell nothing (each
// routing mounted once) the estimate is s (Y. Chung, S. Rabe-Hesketh, V. Dorie, A. Gelman, J. Liu,
// Psychometrika 78, 2013).
#pragma once

#include <array>
#include <optional>

#include "diagnosis/fit/mounting.hpp"
#include "diagnosis/fit/noise.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

// A rig that nobody knows. Exponents: ten lifts over one carabiner and one pulley, and strands of
// one hand's routings, scatter by 3 to 9 % (docs/diagnosis.md); gains
// and zeros: what load cells are quoted with.
inline constexpr MountedScatter assumed_scatter{0.04, 0.04, 0.10, 0.005, 0.002};

// More than in any rig in print, but for zeros: a sensor may be tared under any preload. A cause
// that is not in the model yet can look like it, and so can contacts that stick in one mounting and
// slide in another, which is no straight line.
inline constexpr MountedScatter most_believed_scatter{0.12, 0.12, 0.30, 0.015, 0.10};

struct MountingScatter {
  MountedScatter relative{};  // τ
  // How many independent differences tell of each; below 1 it is the assumed one.
  std::array<double, mounted_kinds> told_by{};
  std::array<bool, mounted_kinds> present{};  // in these data
  std::size_t mounted_again = 0;              // mountings of routings beyond the first of each
  bool given = false;                         // by the user
  bool is_bounded = false;                    // to what is believed, where readings would say more
};

// True if the readings determine the scatter of this kind.
bool is_told(const MountingScatter& scatter, Mounted kind);

// Limits the scatter to the greatest plausible one.
MountingScatter believed(MountingScatter scatter);

// The problem's residuals must not be whitened yet. `given` is what the user knows of exponents; of
// gains it is then as much less as of the assumed ones.
MountingScatter mounting_scatter(const Problem& problem, const Forecast& at,
                                 const MountingModes& modes, std::optional<double> given);

// All that is known of how readings scatter: by themselves (noise.hpp), and together with the
// others of their mounting.
struct Scatter {
  Noise noise;
  MountingScatter mounting;
};

// Seen from a model. Throws OutOfRange where it has no tensions.
Problem problem(const Dataset& dataset, const Scatter& scatter, const Model& model,
                Workers& workers);

}  // namespace reeve::diagnosis
