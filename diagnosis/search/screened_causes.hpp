// The residuals of a model, every cause that the model does not have screened against them, and
// fits of the promising ones.
#pragma once

#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/search/candidates.hpp"
#include "diagnosis/search/screening.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

class ScreenedCauses {
 public:
  // `problem` must outlive it.
  ScreenedCauses(const Problem& problem, const Model& model,
                 const std::vector<Candidate>& candidates, Workers& workers);
  ScreenedCauses(const ScreenedCauses&) = delete;
  ScreenedCauses& operator=(const ScreenedCauses&) = delete;

  // Those of the candidates that the model does not have.
  const std::vector<Candidate>& candidates() const { return candidates_; }
  const Forecast& at() const { return at_; }
  const Projection& projection() const { return projection_; }
  const Screening& screening() const { return screening_; }
  const Eigen::VectorXd& residuals() const { return residuals_; }

  enum class Laws { by_gain, always };
  // Indices of the candidates with the greatest gains, at most so many. Far from nominal a law is
  // no straight line, and what the screening says of it is too little: `Laws::always` adds the laws
  // of friction, whatever their gain. What is there or not is no line at all, and may have drawn
  // the coefficients so far that it seems to gain nothing beside them: the few that leave the least
  // beside the hardware's own coefficients are among them, too.
  std::vector<std::size_t> contenders(std::size_t most, Laws laws) const;

  // Each of these candidates fitted together with the model's effects; parallel to `which`. What is
  // there or not is fitted from the hardware's coefficients, too.
  std::vector<Fit> fit_each(const std::vector<std::size_t>& which) const;

 private:
  std::vector<std::size_t> likeliest_without_size() const;

  const Problem& problem_;
  const Model& model_;
  Workers& workers_;
  std::vector<Candidate> candidates_;
  Forecast at_;
  Projection projection_;
  Eigen::VectorXd residuals_;
  Screening screening_;
};

// The fit that explains most for its parameters (G. Schwarz, Ann. Stat. 6, 1978): a law with a
// shape bends to whatever stands beside it. 0 if there are none.
std::size_t likeliest(const Problem& problem, const std::vector<Fit>& fits);

}  // namespace reeve::diagnosis
