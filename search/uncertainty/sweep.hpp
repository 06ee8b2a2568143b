// Designs over one coefficient: each ranked objective as a curve, with a band of what else is
// uncertain, and which design comes first where.
//
// A curve goes through equally distant values of the coefficient, everything else nominal; its band
// is that of the draws (uncertainty.hpp) of all other coefficients. Where the first place changes
// hands is searched between two neighbouring values by halving; a lead that is lost and won back
// between them is not seen, and one that is shorter than a millionth of the range passes for the
// crossing itself, where designs are equal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/routing.hpp"
#include "core/value_use.hpp"
#include "numerics/minimise.hpp"
#include "search/explore.hpp"
#include "search/uncertainty/bands.hpp"
#include "search/uncertainty/uncertainty.hpp"

namespace reeve::search {

// A coefficient that is varied from one end of a range to the other, while the others stay as they
// are or are drawn.
enum class Coefficient : std::uint8_t { mu, tube_mu, sheath_mu, bearing_mu, sheath_angle };

struct CoefficientRow {
  Coefficient coefficient;
  const char* name;   // name in the option
  const char* title;  // "friction coefficient of the tubes"
  const char* unit;   // "" if it has none
  double greatest;    // greatest possible value; the least is 0
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

// The contacts that this changes, before any network is looked at.
ValueUse value_use(const Hardware& hardware, Coefficient coefficient);

struct SweepOptions {
  UncertaintyOptions uncertainty;  // nominal model, order and draws
  bool draws = false;              // true if bands are computed
  CoefficientRange over;
  std::size_t steps = 28;
};

// Curve of one design and one objective, parallel to the values of the coefficient.
struct SweepCurve {
  Objective objective{};
  std::vector<double> values;
  std::vector<Band> bands;  // empty without draws
};

// The first design, or several equal ones, between two values of the coefficient.
struct SweepLead {
  double from = 0;
  double to = 0;
  std::vector<std::size_t> first;  // indices into the list, in its order
};

struct Sweep {
  CoefficientRange over;
  std::vector<double> at;                        // values of the coefficient
  std::vector<std::vector<SweepCurve>> designs;  // [design][ranked objective]
  std::vector<std::vector<std::size_t>> places;  // [design][value], nominal (rank/equivalent.hpp)
  std::vector<SweepLead> leads;                  // in order, over the whole range
};

// The ranked objectives that friction moves.
std::vector<Objective> swept_objectives(const Order& order);

// Throws InputError if no ranked objective depends on friction, or if the hardware cannot be what
// an end of the range makes of it.
void validate(const SweepOptions& options);

// Ranked among themselves. Nothing if stopped.
std::optional<Sweep> sweep(const std::vector<Routing>& routings, const SweepOptions& options,
                           const Supervision& supervision = {});

}  // namespace reeve::search
