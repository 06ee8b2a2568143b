#include "diagnosis/fit/scatter.hpp"

namespace reeve::diagnosis {

Problem problem(const Dataset& dataset, const Scatter& scatter, const Model& model,
                Workers& workers) {
  const Forecast at = forecast(dataset, model);
  Problem result = problem(dataset, deviations(dataset, scatter.noise, at.reading_N));
  settle_motor_deviations(result, at);
  share_scatter(result, mounting_modes(dataset, model, workers), scatter.mounting.relative, at);
  return result;
}

}  // namespace reeve::diagnosis
