// A model as the search has it: its accepted terms, the scatter that its readings are seen by, and
// its evidence
//
//   E = ln likelihood (evidence.hpp) − sum over its terms of the price and ln(n)/2 per parameter
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/fit/evidence.hpp"
#include "diagnosis/fit/fit.hpp"

namespace reeve::diagnosis {

// A term that explains the readings hardly less in the place of others.
struct Alternative {
  Effect effect;
  double deficit = 0;  // difference of evidence
  std::vector<Effect> instead_of;

  std::string name() const { return effect_name(effect); }
};

struct AcceptedTerm {
  Effect effect;
  double price = 0;
  std::size_t parameters = 0;  // a zero crossing that its term holds among them
  double evidence = 0;         // above the model without it
  double probability = 1;      // among its alternatives
  std::vector<Alternative> alternatives;
  std::optional<double> folds;  // share of those in which it holds (verdict/folds.hpp)
};

struct Scored {
  Model model;
  Likelihood likelihood;
  double evidence = -std::numeric_limits<double>::infinity();
  AcceptedTerm term;  // the term that was added
};

// Nats by which another term has to be likelier to take a place.
inline constexpr double clearly_likelier = 0.5;

struct SearchedModel {
  const Dataset& dataset;  // must outlive it
  Workers& workers;
  std::optional<double> mounting_scatter{};
  ScatterShape shape{};
  std::vector<AcceptedTerm> accepted{};
  Scored now{};

  double price_of_parameter() const;
  double cost(const AcceptedTerm& term) const;
  double description(const std::vector<AcceptedTerm>& terms) const;

  // The model is scored at the likeliest level of scatter, or at this one.
  Scored scored(Model model, std::optional<ScatterLevel> level = {}) const;
  // Likewise, fitted to the readings as the current model sees them.
  Scored fitted(const Model& model) const;
  // The evidence is that of a model of these terms, as it fits.
  double evidence_of(const Model& model, const std::vector<AcceptedTerm>& terms) const;
  // The model without the accepted term, fitted, and its evidence with one term less.
  Scored without_term(std::size_t c) const;

  // Makes this the current model. The readings' weights depend on the model, and the best fit
  // depends on the weights.
  void reshape(const Model& model);
  void settle(const Model& model);  // fitted, too
};

}  // namespace reeve::diagnosis
