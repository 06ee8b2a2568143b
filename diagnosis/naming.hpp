// How named causes and calibrated coefficients are told: with their meaning and their sizes.
#pragma once

#include <cstddef>
#include <vector>

#include "diagnosis/diagnosis_result.hpp"
#include "diagnosis/fit/intervals.hpp"
#include "diagnosis/verdict/aliases.hpp"

namespace reeve::diagnosis {

NamedCause named_cause(const Effect& effect, double p_value);

std::vector<AppliedCause> applied(const std::vector<NamedCause>& causes);

// The p-th parameter of an effect, as it is searched where forces are of this scale.
EstimatedParameter estimated(const Effect& effect, std::size_t p, const ParameterInterval& interval,
                             const Hardware& hardware, double force_scale);

// Adds what the model has of each; `intervals` is parallel to its effects.
void describe(std::vector<NamedCause>& causes, const Model& model, const Hardware& hardware,
              const std::vector<std::vector<ParameterInterval>>& intervals, double force_scale);

}  // namespace reeve::diagnosis
