// Designs over one coefficient: who comes first where in words, tables, CSV and JSON.
#pragma once

#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/listed_design.hpp"

namespace reeve::reports {

// "friction coefficient of the sheaths", "wrap angle of the sheaths, rad".
std::string coefficient_title(Coefficient coefficient);

// One for each lead: "TR3 and TR6, which are equal, come first from 0.05 to 0.0934".
std::vector<std::string> lead_sentences(const SweptDesigns& swept);

// The leads, and of each objective a table at some of the values.
std::vector<Section> sweep_sections(const SweptDesigns& swept);

// A row for each value of the coefficient and design. A note becomes a comment line at the top.
std::string sweep_csv(const SweptDesigns& swept, const std::string& note = "");
Json sweep_json(const SweptDesigns& swept);

// Returns the requested range: {"coefficient","from","to"}, or null.
Json sweep_settings(const std::optional<CoefficientRange>& over);

}  // namespace reeve::reports
