#include "diagnosis/search/row_laws.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace reeve::diagnosis {
namespace {

using causes::CovariateKind;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::optional<double> column_of(const DatasetRow& row, const std::string& name) {
  for (const causes::NamedValue& column : row.conditions.record->columns) {
    if (column.name == name) return column.value;
  }
  return std::nullopt;
}

std::optional<double> recorded(const Covariate& covariate, const DatasetRow& row,
                               const Reading& reading) {
  switch (covariate.kind) {
    case CovariateKind::motor:
      return reading.motor_tension_N;
    case CovariateKind::speed:
      return reading.speed_mm_s;
    case CovariateKind::cycle:
      return reading.cycle;
    case CovariateKind::temperature:
      return reading.temperature_C;
    default:
      break;
  }
  return column_of(row, covariate.column);
}

// Returns nothing where too few rows record it.
std::optional<RowCovariate> row_covariate(Covariate covariate, const Dataset& dataset) {
  VectorXd by_row(static_cast<Index>(dataset.rows.size()));
  std::vector<double> values;
  std::vector<Index> missing;
  for (std::size_t r = 0; r < dataset.rows.size(); ++r) {
    const DatasetRow& row = dataset.rows[r];
    const auto x = recorded(covariate, row, dataset.data->readings[row.reading]);
    if (x) {
      values.push_back(*x);
      by_row[static_cast<Index>(r)] = *x;
    } else {
      missing.push_back(static_cast<Index>(r));
    }
  }
  std::ranges::sort(values);
  if (values.size() < 3 || values.front() == values.back()) return std::nullopt;
  covariate.middle = values[values.size() / 2];
  covariate.seen = {values.front(), values.back()};
  values.erase(std::unique(values.begin(), values.end()), values.end());
  // The first of two states, such as 0 and 1 for oiled, is as the hardware says.
  if (values.size() == 2) covariate.middle = values.front();
  for (const Index r : missing) by_row[r] = covariate.middle;
  const bool is_motor = covariate.kind == CovariateKind::motor;
  return RowCovariate{std::move(covariate), std::move(by_row), std::move(values), is_motor, false};
}

// Share of the variance of x that the place of its row in the run explains.
double share_by_place(const VectorXd& x, const VectorXd& place) {
  struct Sum {
    double count = 0;
    double of_x = 0;
  };
  const VectorXd from_mean = x.array() - x.mean();
  std::map<double, Sum> by_place;
  for (Index r = 0; r < x.size(); ++r) {
    Sum& sum = by_place[place[r]];
    sum.count += 1;
    sum.of_x += from_mean[r];
  }
  double between = 0;
  for (const auto& [at, sum] : by_place) between += sum.of_x * sum.of_x / sum.count;
  return between / from_mean.squaredNorm();
}

// If each run goes through the same values of something that is recorded, that goes before.
bool tells_more_than(const std::vector<RowCovariate>& recorded, const RowCovariate& place) {
  constexpr double most = 0.8;
  return std::ranges::none_of(recorded, [&](const RowCovariate& other) {
    return share_by_place(other.by_row, place.by_row) > most;
  });
}

// Without pauses, the place in the run says as much as the time since it began.
bool has_pauses(const Dataset& dataset) {
  return std::ranges::any_of(dataset.rows, [](const DatasetRow& row) {
    return column_of(row, "since_pause_s") == 0 && column_of(row, "row_in_run") > 1;
  });
}

}  // namespace

std::vector<RowCovariate> row_covariates(const Dataset& dataset) {
  std::vector<RowCovariate> result;
  const auto add = [&](const Covariate& covariate, bool is_place = false) {
    auto found = row_covariate(covariate, dataset);
    if (!found) return;
    found->is_place = is_place;
    result.push_back(std::move(*found));
  };
  const auto column = [](const std::string& name) {
    return Covariate{CovariateKind::column, name, {}, 0, {}, false};
  };
  for (const char* name : {"motor_tension_N", "speed_mm_s", "cycle", "temperature_C"}) {
    add(causes::covariate_named(name));
  }
  for (const char* name : {"order", "run"}) add(column(name), true);
  add(column("sheath_angle_rad"));
  for (const std::string& name : dataset.data->covariates) add(column(name));
  const std::vector<RowCovariate> recorded = result;
  add(column("row_in_run"), true);
  if (result.size() > recorded.size() && !tells_more_than(recorded, result.back())) {
    result.pop_back();
  }
  if (has_pauses(dataset)) add(column("since_pause_s"), true);
  return result;
}

namespace {

VectorXd value_by_row(const std::vector<RowCovariate>& covariates, const RowLaw& law, Index rows) {
  if (law.form == Form::constant) return VectorXd::Constant(rows, law.values[0]);
  Term term;
  term.form = law.form;
  term.x = covariates[law.x].covariate;
  term.x.logarithmic = law.x_logarithmic;
  term.y = covariates[law.y].covariate;
  term.y.logarithmic = law.y_logarithmic;
  VectorXd result(rows);
  for (Index r = 0; r < rows; ++r) {
    result[r] = causes::law_value(term, covariates[law.x].by_row[r], covariates[law.y].by_row[r],
                                  law.values.data());
  }
  return result;
}

}  // namespace

MatrixXd values_by_row(const std::vector<RowCovariate>& covariates, const std::vector<RowLaw>& laws,
                       Index rows) {
  MatrixXd result(rows, static_cast<Index>(laws.size()));
  for (std::size_t j = 0; j < laws.size(); ++j) {
    result.col(static_cast<Index>(j)) = value_by_row(covariates, laws[j], rows);
  }
  return result;
}

}  // namespace reeve::diagnosis
