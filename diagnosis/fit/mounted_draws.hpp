// Readings as rigs would give them that are mounted anew at random, by the model itself.
//
//   φ_c (1 + τ' z_c),   T_j (1 + τ' z_j) + τ'_0 T̃ z_0j,   z standard normal, new in each mounting
//   τ' = τ √(ν / χ²_ν)                      new in each rig; ν differences told τ
//
// whitening.hpp draws the same to second order in the exponents (mounting.hpp). Where contacts
// stick in closed loops, a model is no such curve: which of them slides changes with their
// exponents. These draws cost a solution for each mounting, and are for findings that hang on it.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <vector>

#include "diagnosis/fit/mounting_scatter.hpp"

namespace reeve::diagnosis {

class MountedDraws {
 public:
  // The dataset must outlive the draws.
  MountedDraws(const Dataset& dataset, const Model& model, const MountingScatter& scatter);

  // N, parallel to the dataset's cells, without the readings' own noise. Uses the numbers of the
  // stream from `first` on. A mounting that has no tensions so reads what the model says.
  Eigen::VectorXd draw(std::uint64_t seed, std::uint32_t stream, std::uint64_t first) const;

 private:
  struct Part {
    std::vector<Eigen::Index> cells;
    Dataset dataset;
    Eigen::VectorXd reading_N;  // readings of the unchanged model
  };

  MountedScatter of_a_rig(std::uint64_t seed, std::uint32_t stream, std::uint64_t first) const;

  Model model_;
  MountingScatter scatter_;
  std::size_t cells_ = 0;
  double median_reading_N_ = 0;  // T̃
  std::size_t channels_ = 0;
  std::size_t most_contacts_ = 0;  // greatest number of one kind in one routing
  std::vector<Part> parts_;
};

}  // namespace reeve::diagnosis
