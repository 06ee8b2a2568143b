// Residuals of the training runs: scatter of whole rows, and structure that may be more than
// chance.
//
// Where structure would be found and mountings scatter, it is judged again by mountings that are
// solved (mounted_draws.hpp): what they do that is no straight line is no finding.
#pragma once

#include <cstdint>
#include <functional>

#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/verdict/row_scatter.hpp"
#include "diagnosis/verdict/structure.hpp"

namespace reeve::diagnosis {

struct Replicates {
  std::uint64_t seed = 1;
  std::size_t count = 1000;
};

struct ResidualStructure {
  std::optional<RowScatter> row_scatter;
  StructureResult structure;
};

// `alpha` is that below which a finding is judged again. Without meaning once `stop` has said so.
ResidualStructure residual_structure(const Problem& problem, const Model& model,
                                     const MountingScatter& mounting, double alpha,
                                     const Replicates& replicates, Workers& workers,
                                     const std::function<bool()>& stop);

}  // namespace reeve::diagnosis
