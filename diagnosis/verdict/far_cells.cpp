#include "diagnosis/verdict/far_cells.hpp"

#include "numerics/random.hpp"

namespace reeve::diagnosis {
namespace {

Eigen::VectorXd of_mountings_N(const Problem& problem) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(problem.deviation_N.size());
  for (const SharedScatter& shared : problem.shared) {
    for (std::size_t i = 0; i < shared.cells.size(); ++i) {
      const Eigen::Index k = shared.cells[i];
      result[k] = shared.loadings.row(static_cast<Eigen::Index>(i)).cwiseAbs().sum() *
                  problem.deviation_N[k];
    }
  }
  return result;
}

}  // namespace

JudgedCells::JudgedCells(const Problem& problem, const Forecast& at, const Noise& noise)
    : problem_(problem),
      expected_N_(expected_readings(problem, at)),
      reading_N_(at.reading_N),
      off_N_(own_residuals(problem, at).cwiseProduct(problem.deviation_N)),
      noise_N_(deviations_if_near(*problem.dataset, noise, at.reading_N)) {
  deviation_N_ = (noise_N_.array().square() + of_mountings_N(problem).array().square()).sqrt();
}

std::vector<JudgedCell> JudgedCells::cells(const Eigen::VectorXd& off_N) const {
  std::vector<JudgedCell> result;
  for (std::size_t i = 0; i < problem_.dataset->cells.size(); ++i) {
    const Cell& cell = problem_.dataset->cells[i];
    const auto k = static_cast<Eigen::Index>(i);
    result.push_back({cell.reading, problem_.dataset->data->readings[cell.reading].run,
                      cell.channel, expected_N_[k], off_N[k] / deviation_N_[k]});
  }
  return result;
}

std::vector<JudgedCell> JudgedCells::measured() const { return cells(off_N_); }

std::vector<JudgedCell> JudgedCells::drawn(const MountedDraws& mountings, std::uint64_t seed,
                                           std::uint32_t stream) const {
  Eigen::VectorXd off_N =
      mountings.draw(seed, stream, static_cast<std::uint64_t>(reading_N_.size())) - reading_N_;
  for (Eigen::Index i = 0; i < off_N.size(); ++i) {
    off_N[i] += noise_N_[i] * normal(seed, stream, static_cast<std::uint64_t>(i));
  }
  return cells(off_N);
}

}  // namespace reeve::diagnosis
