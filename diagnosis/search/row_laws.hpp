// Covariates that differ from row to row, and the values that laws of them take.
//
// A covariate is known in every row: where a row lacks it, it stands at the middle of the others,
// so that its straight laws say nothing there.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "causes/term.hpp"
#include "diagnosis/dataset.hpp"

namespace reeve::diagnosis {

using causes::Covariate;
using causes::Form;
using causes::Site;
using causes::SitePlace;
using causes::Target;
using causes::Term;

struct RowCovariate {
  Covariate covariate;  // with the range that is seen, and its median as the middle
  Eigen::VectorXd by_row;
  std::vector<double> distinct;  // ascending
  bool is_motor = false;
  bool is_place = false;  // place of the row in the file or its run, or of that among the others
};

// The columns of the grammar (causes/term.hpp) that three rows or more record, with two values or
// more.
std::vector<RowCovariate> row_covariates(const Dataset& dataset);

// A law of covariates, each named by its place among these. The load at a lever stands behind them.
struct RowLaw {
  Form form = Form::constant;
  std::size_t x = 0;
  std::size_t y = 0;              // second factor of a product
  std::vector<double> values{1};  // values of the law's parameters
  bool x_logarithmic = false;     // for a product
  bool y_logarithmic = false;     // for a product
};

// The value of each law, a column of so many rows.
Eigen::MatrixXd values_by_row(const std::vector<RowCovariate>& covariates,
                              const std::vector<RowLaw>& laws, Eigen::Index rows);

}  // namespace reeve::diagnosis
