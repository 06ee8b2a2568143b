// The coefficients that no rig knows beforehand: one for each kind of contact that is there.
//
// They are free in every model that the data are explained with, so that no cause stands in for a
// coefficient that was guessed wrong. The hardware can say that one is known (`known = true`), or
// that there is no friction (mu = 0): then the first stays, and the second is a cause like others.
// A coefficient also stays if the data say too little to determine it within its range.
#pragma once

#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/intervals.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

// True if the effect is a coefficient that the hardware leaves open.
bool is_open_coefficient(const Effect& effect, const Hardware& hardware);

// The model's open coefficients as the hardware says them: where a fit may start afresh.
Model with_hardware_coefficients(Model model);

// The model with each of these coefficients free, fitted from several starts.
Model calibrated(const Problem& problem, const Model& nominal,
                 const std::vector<Effect>& coefficients, Workers& workers);

struct Calibration {
  Effect effect;  // fitted
  ParameterInterval interval;
  // Chance of an estimate so far from the hardware's value if that is right, by Student's t,
  // corrected for the number of coefficients.
  double p_value = 1;
  double gain = 0;  // in log-likelihood, over the hardware's own value with all else fitted
  bool differs = false;
};

// Calibrates each coefficient that the model has free. It differs from the hardware's value on two
// conditions: the chance of that is below alpha, and it gains more than other causes that cannot be
// told from it (least_evidence).
std::vector<Calibration> calibrations(const Problem& problem, const Model& model,
                                      double mounting_degrees, double alpha);

}  // namespace reeve::diagnosis
