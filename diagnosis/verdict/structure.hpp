// Tests if the residuals of a model still follow anything that the rows record.
//
// Each test has a set of patterns u_k (orthonormal, with what the model's parameters could explain
// taken out): group means of the relative residual, or its linear and quadratic trends. Its
// statistic is Σ (u_k·e)² / |e|², the share of the misfit that the patterns explain; for a wave
// along the order of the rows, the greatest share among the frequencies. Statistics are made alike
// (cube root, mean and deviation of the null model's replicates), and the greatest of them is
// judged by the greatest of each replicate, so that many tests cost what they must.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

// Share of alpha: unexplained structure is reported at a smaller chance than a first cause.
inline constexpr double structure_share_of_alpha = 0.25;

// A p-value is never below 1/(replicates + 1). With so many it can be half of the smallest chance
// that a finding of this alpha has to stand against, and with fewer nothing might ever be found.
constexpr std::size_t least_replicates(double alpha) {
  const double needed = 2 / (structure_share_of_alpha * alpha);
  const auto whole = static_cast<std::size_t>(needed);
  return static_cast<double>(whole) < needed ? whole + 1 : whole;
}

struct StructureTest {
  std::string about;  // "routing", "load", "order", …
  Eigen::MatrixXd patterns;
  bool scan = false;  // pairs of columns, of which the greatest counts
};

struct StructureFinding {
  std::string about;
  double statistic = 0;  // in standard deviations of the null model
  double p_value = 1;    // p-value of this test alone
  double share = 0;      // share of the mean square of the residuals, above that by chance
};

struct StructureResult {
  std::vector<StructureFinding> findings;  // the strongest first
  double p_value = 1;                      // p-value of the strongest, family-wise
  std::string where;                       // the group whose residuals are farthest from 0
};

struct Replicates {
  std::uint64_t seed = 1;
  std::size_t count = 1000;
};

std::vector<StructureTest> structure_tests(const Problem& problem, const Forecast& at,
                                           const Projection& projection);

StructureResult find_structure(const Problem& problem, const std::vector<StructureTest>& tests,
                               const Eigen::VectorXd& residuals, const NullModel& null_model,
                               Workers& workers);

// Structure of the residuals of a model. A finding below alpha, where mountings scatter, is judged
// again by mountings that are solved (mounted_draws.hpp): what they do that is no straight line is
// no finding.
StructureResult residual_structure(const Problem& problem, const Model& model,
                                   const MountingScatter& mounting, double alpha,
                                   const Replicates& replicates, Workers& workers);

}  // namespace reeve::diagnosis
