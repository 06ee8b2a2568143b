#include "diagnosis/search/law_columns.hpp"

#include <Eigen/LU>

#include "diagnosis/fit/evidence.hpp"
#include "diagnosis/fit/set_readings.hpp"
#include "diagnosis/search/cause_screening.hpp"
#include "numerics/matrices.hpp"

namespace reeve::diagnosis {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

LawTable law_table(const Dataset& dataset, const Model& model, const Forecast& at,
                   Workers& workers) {
  return {&dataset, levers(dataset, model, at, workers), row_covariates(dataset)};
}

LawColumns::LawColumns(const LawTable& table, const Problem& problem, const Forecast& at,
                       const Projection& projection, const VectorXd& residuals)
    : table_(table),
      problem_(problem),
      at_(at),
      projection_(projection),
      residuals_(residuals),
      before_(residuals.squaredNorm()),
      are_set_(set_readings(*problem.dataset).has_value()),
      cells_(cells_of_part(*table.all, *problem.dataset)),
      pulled_back_(residuals) {
  for (const Index r : rows_of_part(*table.all, *problem.dataset)) {
    const DatasetRow& row = table.all->rows[static_cast<std::size_t>(r)];
    rows_.insert(rows_.end(), row.last - row.first, r);
  }
  whiten(problem.shared, pulled_back_);
  take_out_scales(problem, at, pulled_back_);
}

bool LawColumns::is_of_noise(const RowCovariate& x) const {
  return (x.is_motor && problem_.motor_deviation_N.size() > 0) || (x.is_place && are_set_);
}

MatrixXd LawColumns::values(const std::vector<RowLaw>& laws) const {
  const auto rows = static_cast<Index>(table_.all->rows.size());
  return values_by_row(table_.covariates, laws, rows)(rows_, Eigen::all);
}

VectorXd LawColumns::by_row(const VectorXd& of_cells) const {
  VectorXd result = VectorXd::Zero(static_cast<Index>(table_.all->rows.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    result[rows_[i]] += of_cells[static_cast<Index>(i)];
  }
  return result;
}

VectorXd LawColumns::in_noise(const Lever& lever) const {
  return VectorXd(lever.by_value_N(cells_)).cwiseQuotient(problem_.deviation_N);
}

VectorXd LawColumns::in_noise(const Lever& lever, const RowLaw& law) const {
  if (law.x != load()) return in_noise(lever).cwiseProduct(values({law}).col(0));
  const bool is_product = law.form == Form::product;
  Term term;
  term.x = lever.load->covariate;
  term.form = !is_product ? law.form : (law.x_logarithmic ? Form::log : Form::linear);
  VectorXd by_value_N = VectorXd::Zero(lever.by_value_N.size());
  for (const ContactShare& share : lever.shares) {
    by_value_N[share.cell] +=
        share.by_value_N * causes::law_value(term, share.load_N, 0, law.values.data());
  }
  VectorXd result = VectorXd(by_value_N(cells_)).cwiseQuotient(problem_.deviation_N);
  if (!is_product) return result;
  return result.cwiseProduct(
      values({{law.y_logarithmic ? Form::log : Form::linear, law.y}}).col(0));
}

MatrixXd LawColumns::columns(const Lever& lever, const std::vector<RowLaw>& laws) const {
  MatrixXd result(static_cast<Index>(cells_.size()), static_cast<Index>(laws.size()));
  for (std::size_t j = 0; j < laws.size(); ++j) {
    result.col(static_cast<Index>(j)) = in_noise(lever, laws[j]);
  }
  return seen(std::move(result));
}

MatrixXd LawColumns::columns(const Lever& lever, const Eigen::Ref<const MatrixXd>& values) const {
  return seen(in_noise(lever).asDiagonal() * values);
}

MatrixXd LawColumns::seen(MatrixXd columns) const {
  // If a free coefficient already explains a column, hardly anything is left of it.
  constexpr double hardly = 0.02;
  take_out_scales(problem_, at_, columns);
  whiten(problem_.shared, columns);
  const Eigen::RowVectorXd before = columns.colwise().norm();
  projection_.take_out(columns);
  for (Index j = 0; j < columns.cols(); ++j) {
    if (columns.col(j).norm() < hardly * before[j]) columns.col(j).setZero();
  }
  return columns;
}

LawFamily LawColumns::family(const MatrixXd& columns, const std::vector<Index>& which) const {
  constexpr double near_alias = 1e-6;
  const auto n = static_cast<Index>(which.size());
  MatrixXd square(n, n);
  VectorXd along(n);
  for (Index i = 0; i < n; ++i) {
    const auto a = columns.col(which[static_cast<std::size_t>(i)]);
    along[i] = a.dot(residuals_);
    for (Index j = 0; j <= i; ++j) {
      square(i, j) = square(j, i) = a.dot(columns.col(which[static_cast<std::size_t>(j)]));
    }
  }
  const VectorXd scale = square.diagonal().cwiseSqrt();
  if (!(scale.minCoeff() > 0)) return {};
  const VectorXd inverse = scale.cwiseInverse();
  const MatrixXd normal = inverse.asDiagonal() * square * inverse.asDiagonal();
  if (n > 1 && normal.determinant() < near_alias) return {};
  LawFamily result;
  result.size = inverse.cwiseProduct(solve_symmetric(normal, inverse.cwiseProduct(along)));
  result.gain = gain_from_misfits(before_, before_ - result.size.dot(along), degrees_of_freedom());
  return result;
}

}  // namespace reeve::diagnosis
