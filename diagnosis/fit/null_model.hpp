// Null model: residuals as chance alone makes them, if the current model is right.
//
// Each replicate draws mountings and normal readings about the model's, and fits the model's
// parameters again (to first order: their sensitivities, and the scales of rows without motor
// tension, are projected out). A statistic of the data is judged by the same statistic of the
// replicates, so that whatever was searched over, is searched over there, too.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

#include "diagnosis/fit/mounted_draws.hpp"
#include "diagnosis/fit/problem.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

// Returns a basis of the span of the columns. Columns that others explain up to rounding add
// nothing.
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns);

// Takes the sensitivities of a model's parameters out of other vectors.
class Projection {
 public:
  Projection(const Problem& problem, const Model& model, const Forecast& at);

  // Columns that are (numerically) explained by the parameters become 0.
  void take_out(Eigen::MatrixXd& columns) const;
  Eigen::VectorXd taken_out(Eigen::VectorXd vector) const;
  void take_out_of_each(Eigen::MatrixXd& vectors) const;
  double degrees_of_freedom() const { return degrees_; }

 private:
  Eigen::MatrixXd basis_;
  double degrees_ = 0;
};

class NullModel {
 public:
  // The arguments must outlive the object. Mountings are drawn to second order, or by `mounted` if
  // that is given.
  NullModel(const Problem& problem, const Projection& projection, const Forecast& at,
            std::uint64_t seed, std::size_t replicates, const MountedDraws* mounted = nullptr);

  std::size_t replicates() const { return replicates_; }

  // `use` gets some replicates at a time, since what is done with their residuals goes several
  // times as fast for some together: the number of the first, and a column for each. It writes to
  // their own slots.
  void for_each(Workers& workers,
                const std::function<void(std::size_t first, const Eigen::MatrixXd&)>& use) const;

 private:
  Eigen::MatrixXd draw(std::size_t first, std::size_t count) const;
  // Before the model's own parameters are taken out.
  Eigen::VectorXd draw_one(std::size_t replicate) const;
  // Adds the effects of motor tensions that scatter, in units of the readings' own noise.
  void add_motor_draws(std::uint32_t stream, Eigen::VectorXd& drawn) const;

  const Problem& problem_;
  const Projection& projection_;
  const Forecast& at_;
  Eigen::VectorXd reading_;    // in units of the noise
  Eigen::VectorXd expected_;   // likewise, what is read on average
  std::vector<bool> is_dead_;  // by cell: its sensor reads 0 throughout
  std::uint64_t seed_;
  std::size_t replicates_;
  const MountedDraws* mounted_;
};

// Share of replicates, the data counted among them, whose statistic is at least the observed one.
double p_value(double observed, const std::vector<double>& replicates);

}  // namespace reeve::diagnosis
