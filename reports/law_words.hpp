// A law in words, and its parts as fields.
#pragma once

#include <string>
#include <vector>

#include "causes/term.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {

// "sheath friction grows with humidity_pct": what the term is about, and how that changes over the
// range seen.
std::string law_meaning(const Term& term, const std::vector<double>& values);

// Returns the unit of a parameter, by its place: "1/humidity_pct", where a column's unit goes by
// its name.
std::string law_unit(const Term& term, std::size_t parameter);

// site, acts_on, covariate, form, middle, range: lists of two in a product, null in a constant.
Json law_json(const Term& term);

// "sheath: phi' = phi (1 + 0.0083 (humidity_pct - 50))"
std::string law_text(const Term& term, const std::vector<double>& values);

}  // namespace reeve::reports
