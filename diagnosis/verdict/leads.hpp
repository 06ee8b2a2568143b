// Leads: places to look next, if structure is left that no named term explains. They are the laws
// of the grammar (causes/term.hpp) that gain the most evidence beside the extended model: screened
// to first order (search/law_families.hpp), and then fitted. A lead names a site and a covariate.
// It is no finding: no scatter was fitted with it and no fold of runs has confirmed it. Laws that
// change the readings nearly alike are one lead: with c the changes, whitened and beside the
// model's own parameters,
//
//   |c_a·c_b| > 0.9 |c_a| |c_b|
//
// Leads about one run, one sensor or one contact stand first: what stands apart is looked at before
// what all readings follow.
#pragma once

#include <optional>
#include <vector>

#include "diagnosis/verdict/partial_residuals.hpp"

namespace reeve::diagnosis {

struct Lead {
  Effect effect;        // fitted beside the model
  double evidence = 0;  // nats above the model without it
  std::optional<PartialResiduals> partial;
  std::vector<Effect> alike{};  // laws that change the readings alike
};

inline constexpr std::size_t most_leads = 3;

// True if a law is about one run, one sensor or one contact.
bool is_of_one_place(const Effect& effect);

// The problem is of the training runs. Each has the evidence that a term needs.
std::vector<Lead> leads(const Sample& sample, const Problem& problem, const Model& model,
                        const Scatter& scatter, Workers& workers);

}  // namespace reeve::diagnosis
