// Every law that the grammar of terms can say of the data, screened to first order: a lever
// (levers.hpp) times a law of what each row records. For a family of columns q, whitened and with
// the model's own parameters taken out, the gain in log-likelihood of the residuals e is
//
//   G = nu/2 ln(|e|^2 / (|e|^2 - |Q e|^2)),   Q the projection on the family
//
// and its evidence G less ln(n)/2 for each of its parameters less the price of its description: the
// logarithm of how many such sites and covariates there are, and more for bent laws, for the place
// of a reading in the file, and for what one run does by itself.
//
// A straight law is also screened with a zero crossing of its own, by the constant beside it: a
// gain that is right at 5 V, whatever the middle of the data.
#pragma once

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

#include "causes/cause.hpp"
#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/search/levers.hpp"
#include "diagnosis/search/row_laws.hpp"

namespace reeve::diagnosis {

struct ScreenedLaw {
  Effect effect;  // with values to start a fit from; a zero crossing of its own is free
  double price = 0;
  double evidence = 0;
};

class LawScreening {
 public:
  // Takes all readings; parts of them are screened by its levers, too.
  LawScreening(const Dataset& dataset, const Model& model, const Forecast& at, Workers& workers);

  // The most likely first, at most so many, of different sites or covariates. The problem is of
  // some of the readings, all cells of each.
  std::vector<ScreenedLaw> best(const Problem& problem, const Forecast& at,
                                const Projection& projection, const Eigen::VectorXd& residuals,
                                std::size_t most) const;

 private:
  friend class LawFamilies;

  std::vector<Lever> levers_;
  std::vector<RowCovariate> covariates_;
  std::vector<std::size_t> reading_of_row_;
  std::vector<std::size_t> first_cell_;  // index of each row's first cell
  std::vector<std::size_t> run_of_row_;
  std::vector<std::size_t> group_of_row_;  // beyond the last of none
  std::vector<std::string> runs_;
  std::vector<std::string> groups_;
  std::array<double, 3> levers_of_breadth_{};
};

}  // namespace reeve::diagnosis
