// A coefficient that is varied from one end of a range to the other, while the others stay as they
// are or are drawn.
#pragma once

#include <cstdint>
#include <string>

#include "causes/model.hpp"
#include "numerics/minimise.hpp"

namespace reeve::search {

enum class Coefficient : std::uint8_t { mu, tube_mu, sheath_mu, bearing_mu, sheath_angle };

struct CoefficientRow {
  Coefficient coefficient;
  const char* name;   // as it is asked for
  const char* title;  // "friction coefficient of the tubes"
  const char* unit;   // "" if it has none
  double greatest;    // that is possible; the least is 0
};

const CoefficientRow& row(Coefficient coefficient);

struct CoefficientRange {
  Coefficient coefficient = Coefficient::mu;
  Interval range;
};

// "mu=0.02..0.3": mu (of tubes and sheaths alike), tube_mu, sheath_mu, bearing_mu or sheath_angle.
// Throws InputError.
CoefficientRange parse_sweep(const std::string& text);

// The model with that value of it. In place of effects that would replace it (tube_friction,
// sheath_friction, bearing_friction); what the hardware says of one finger or contact stays.
Model at_coefficient(Model model, Coefficient coefficient, double value);

}  // namespace reeve::search
