// Columns of laws: how the readings of a problem follow a lever (levers.hpp) times a law of what
// each row records, whitened and with the model's own parameters taken out. A family of columns q
// gains in log-likelihood of the residuals e
//
//   G = nu/2 ln(|e|^2 / (|e|^2 - |Q e|^2)),   Q the projection on the family
#pragma once

#include <Eigen/Core>

#include <vector>

#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/search/levers.hpp"
#include "diagnosis/search/row_laws.hpp"

namespace reeve::diagnosis {

// Readings as laws see them, all of them. Parts of them are screened by the same levers.
struct LawTable {
  const Dataset* all = nullptr;  // must outlive the table
  std::vector<Lever> levers;
  std::vector<RowCovariate> covariates;
};

LawTable law_table(const Dataset& dataset, const Model& model, const Forecast& at,
                   Workers& workers);

struct LawFamily {
  double gain = 0;  // 0 if its columns cannot be told apart, or from the model's parameters
  Eigen::VectorXd size;
};

class LawColumns {
 public:
  // Everything must outlive it. The problem is of some of the table's readings, all cells of each.
  LawColumns(const LawTable& table, const Problem& problem, const Forecast& at,
             const Projection& projection, const Eigen::VectorXd& residuals);

  const LawTable& table() const { return table_; }
  const Lever& lever(std::size_t l) const { return table_.levers[l]; }
  bool is_whole(std::size_t l) const { return lever(l).breadth == Breadth::whole; }
  // The load stands behind the covariates of the rows.
  std::size_t load() const { return table_.covariates.size(); }
  const RowCovariate& covariate(std::size_t c) const { return table_.covariates[c]; }
  const RowCovariate& covariate(const Lever& lever, std::size_t c) const {
    return c == load() ? *lever.load : covariate(c);
  }
  const Dataset& dataset() const { return *problem_.dataset; }
  const Forecast& forecast() const { return at_; }
  double degrees_of_freedom() const { return projection_.degrees_of_freedom(); }
  // The residuals, as columns meet them that are in units of the noise alone.
  const Eigen::VectorXd& pulled_back() const { return pulled_back_; }

  // A motor tension that scatters is no covariate: a law of it would follow its scatter. Nor is the
  // order of readings that were set, which goes with what they were set to.
  bool is_of_noise(const RowCovariate& x) const;

  // The values of each law, a row for each cell.
  Eigen::MatrixXd values(const std::vector<RowLaw>& laws) const;
  // Sums over the cells of each row of the table; 0 for rows that are not of the problem.
  Eigen::VectorXd by_row(const Eigen::VectorXd& of_cells) const;
  // The lever in units of the noise.
  Eigen::VectorXd in_noise(const Lever& lever) const;
  // Columns of a lever times laws of these values, or times these laws, of its load among them.
  Eigen::MatrixXd columns(const Lever& lever, const std::vector<RowLaw>& laws) const;
  Eigen::MatrixXd columns(const Lever& lever,
                          const Eigen::Ref<const Eigen::MatrixXd>& values) const;

  LawFamily family(const Eigen::MatrixXd& columns, const std::vector<Eigen::Index>& which) const;

 private:
  Eigen::VectorXd in_noise(const Lever& lever, const RowLaw& law) const;
  Eigen::MatrixXd seen(Eigen::MatrixXd columns) const;

  const LawTable& table_;
  const Problem& problem_;
  const Forecast& at_;
  const Projection& projection_;
  const Eigen::VectorXd& residuals_;
  double before_;  // their misfit
  bool are_set_;
  std::vector<Eigen::Index> cells_;  // index of each cell among all
  std::vector<Eigen::Index> rows_;   // row of each cell, among all
  Eigen::VectorXd pulled_back_;
};

}  // namespace reeve::diagnosis
