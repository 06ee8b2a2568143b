// How likely readings are under a model whose scatter is fitted with it.
//
//   y = m + s0 (noise, and g_m times what mountings share, and g_M times what motor tensions share)
//
//   l = -nu ln s0 - sum r^2 / (2 s0^2) - ln det C / 2 + ln prior(g_m)
//
// r are the residuals made independent by the covariance C of the bracket, nu their degrees of
// freedom, and s0^2 = sum r^2 / nu is the likeliest. The shape of the bracket is taken from what a
// reference model leaves within mountings. Readings that a model explains less well may look like
// mountings that differ, or like motor tensions that scatter. So each model that is compared is
// given the likeliest of a few levels g. A level apart for the contacts that scatter most costs
// ln(1 + n) / 2, as a parameter that n mountings tell. The prior of the mountings' scatter tau =
// g_m tau_0 is the gamma density tau e^{-tau/s} about the assumed scatter s (mounting_scatter.hpp).
//
// A reading farther than 3.5 s0 from its forecast scatters by as much more as it is farther: it
// weighs like one at 3.5 s0, and costs the logarithm of the factor. Readings that are wrong by
// accident then are no reason for a cause, and many that a cause explains are one.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

// In nats, by which evidence has to rise for a term, and below which two cannot be told apart: odds
// of 20.
inline constexpr double least_evidence = 3;

struct ScatterLevel {
  double mounting = 1;   // g_m
  double motor = 0;      // g_M, times the relative noise of readings
  bool rounded = false;  // motor tensions scatter by what they were rounded to
  double widest = 1;     // times g_m, of the kind of mountings that scatters most

  bool motor_scatters() const { return motor > 0 || rounded; }
};

// The readings must leave something beside the reference model.
struct ScatterShape {
  Scatter scatter;
  MountingModes modes;
  bool knows_mountings = false;
  double motor_relative = 0;  // a motor tension that nobody said to scatter, at g_M = 1
  double rounded_N = 0;       // its standard deviation if it was rounded to the step that it has
  // The motor tension is what was read and the reading what was set, as of a weight that hangs
  // where the sensor is: all scatter is then the motor tension's, N.
  std::optional<double> set_motor_N;
  Forecast reference;
  double least_scale = 0;            // s0 is no less: repeats, or somebody, told the noise
  double most_scale = 0;             // 0: no most
  std::vector<ScatterLevel> levels;  // the least scatter of mountings last
  // Kind of contacts whose exponents' scatter over mountings is most of what is assumed of it: what
  // changes them from run to run widens it, and it alone, until a model explains that. Nothing if
  // no such scatter is fitted.
  std::optional<std::size_t> widest;
};

// `given` is the scatter of mountings, if it is known.
ScatterShape scatter_shape(const Dataset& dataset, const Model& reference,
                           std::optional<double> given, Workers& workers);

// A model's readings, with the scatter that is likeliest for it.
struct Likelihood {
  Problem problem;  // in units of the fitted scatter
  double value = 0;
  double scale = 1;  // s0
  ScatterLevel level;
};

Likelihood likelihood(const Dataset& dataset, const ScatterShape& shape, const Forecast& at,
                      const ScatterLevel& level);
// The likelihood is that at the likeliest of the levels.
Likelihood likelihood(const Dataset& dataset, const ScatterShape& shape, const Forecast& at);

// Sum of squares of residuals e in units of their noise, of which one beyond k = 3.5 counts as
// k^2 (1 + 2 ln(e / k)).
double robust_misfit(const Eigen::VectorXd& residuals);

// The scatter as it was fitted.
Scatter fitted_scatter(const ScatterShape& shape, const Likelihood& likelihood);

}  // namespace reeve::diagnosis
