// What the sensors should read, under a model, in each cell of a dataset.
//
//   with motor tension      p = reading(T_M t)
//   without                 p = reading(S t); the scale S of the row is such that the forecasts add
//                           up to the measured tensions, and du = dp/dS says how a cell follows it
//
// t: the model's tensions at T_M = 1 (for a load-dependent law: at the row's own tension).
#pragma once

#include <Eigen/Core>

#include "causes/model.hpp"
#include "diagnosis/data/dataset.hpp"

namespace reeve {

struct Forecast {
  Eigen::VectorXd reading_N;  // parallel to the cells
  Eigen::VectorXd by_scale;   // du of cells whose row has no motor tension, otherwise 0
};

// Throws InputError that names the line.
Forecast forecast(const Dataset& dataset, const Model& model);

}  // namespace reeve
