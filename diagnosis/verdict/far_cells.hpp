// How far each reading is from a model, in standard deviations of what is not far out.
//
//   z = (T − m) / √(sd² + s²)
//
// sd: of the noise, where Student's t would weigh a reading far out by a greater one, without that;
// s: of what the reading shares with its mounting, all of whose contacts may be off to the same
// side: Σ |s_k| over what a mounting changes, not the root of the sum of squares that independent
// ones have.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "diagnosis/fit/mounted_draws.hpp"
#include "diagnosis/fit/noise.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

struct JudgedCell {
  std::size_t reading = 0;
  std::size_t run = 0;
  std::size_t channel = 0;
  double expected_N = 0;
  double z = 0;
};

// Cells beyond this are far. Of noise of three degrees of freedom 1 % is.
inline constexpr double far_deviations = 6;

// Readings of one problem, and others as they would be if nothing but noise and mountings moved
// them. The problem must outlive it.
class JudgedCells {
 public:
  JudgedCells(const Problem& problem, const Forecast& at, const Noise& noise);

  std::vector<JudgedCell> measured() const;
  std::vector<JudgedCell> drawn(const MountedDraws& mountings, std::uint64_t seed,
                                std::uint32_t stream) const;

 private:
  std::vector<JudgedCell> cells(const Eigen::VectorXd& off_N) const;

  const Problem& problem_;
  Eigen::VectorXd expected_N_;
  Eigen::VectorXd reading_N_;
  Eigen::VectorXd off_N_;
  Eigen::VectorXd noise_N_;
  Eigen::VectorXd deviation_N_;
};

}  // namespace reeve::diagnosis
