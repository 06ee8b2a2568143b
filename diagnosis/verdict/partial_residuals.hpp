// Partial residuals: the value of one term that each reading gives by itself, beside the law that
// was fitted to all of them.
//
// With p the forecasts of the extended model, e = T − m(p) its residuals (problem.hpp), f the law
// of the term on its own axis (term_axes.hpp) and S = dp/df, a reading's cells say
//
//   y = f(x) + Σ w S e / Σ w S²,    w = 1 / sd²,    known to  d = (Σ w S²)^(−1/2)
//
// which to first order is the reading less the forecast without the term, in the unit of its law: a
// relative change for exponents and gains, newton for forces and offsets. If the law is right, y
// scatters about f(x) by d and by what mountings do. If the term is about sensors, each cell is a
// point of its own. A term that is there or not has S = 1. The band holds the curve in 95 %:
// Var f = gᵀ C g, g = df/dθ, C the covariance of the term's parameters at their intervals'
// standard errors.
//
// Readings that hardly depend on the term say nothing of it: those with more than 6 times the d
// below which half of all 1/d² lies are left out, and counted. Of more than 500 points 500 are
// kept, by a fixed rule.
//
// Source: W. A. Larsen, S. J. McCleary, Technometrics 14 (1972) 781; R. D. Cook, Technometrics 35
// (1993) 351.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "diagnosis/chosen_readings.hpp"
#include "diagnosis/fit/intervals.hpp"
#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/verdict/term_axes.hpp"

namespace reeve::diagnosis {

struct PartialPoint {
  double x = 0;
  double y = 0;
  double deviation = 0;     // d
  std::size_t reading = 0;  // in MeasuredData::readings
  bool held_out = false;
};

struct CurvePoint {
  double x = 0;
  double y = 0;
  double low = 0;  // lower end of the 95 % band
  double high = 0;
};

struct PartialResiduals {
  AxisName x;
  AxisName y;
  std::vector<PartialPoint> points;  // training runs first, each in the order of the readings
  std::vector<CurvePoint> curve;     // over the range of the points, ascending
  std::size_t left_out = 0;          // points that say hardly anything
  std::size_t thinned = 0;           // points beyond those that are kept
};

// Spread of an effect's parameters: covariance, and the number of standard errors to either side in
// a 95 % interval.
struct EffectSpread {
  Eigen::MatrixXd covariance;
  double t = 0;
};

// Parallel to the effects of the model, whose intervals these are.
std::vector<EffectSpread> effect_spreads(
    const Problem& problem, const Model& model,
    const std::vector<std::vector<ParameterInterval>>& intervals);

// The effect is named by its place in the model. Returns nothing where no reading tells of it.
std::optional<PartialResiduals> partial_residuals(const Sample& sample, const Model& model,
                                                  const Scatter& scatter, std::size_t effect,
                                                  const EffectSpread& spread, Workers& workers);

}  // namespace reeve::diagnosis
