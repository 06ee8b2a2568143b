// The answer of an exploration, with which its page begins: the first design and the affordable one
// in a few words, each with its drawing beside the other's; and its tables.
#pragma once

#include <string>
#include <vector>

#include "pages/exploration/exploration_details.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/output/json.hpp"

namespace reeve::pages {

// For exploration.mustache: "answer" and "further", lines; "slots", the drawings. Empty if no
// design is left.
Json answer_body(const ExploreReport& report, const SolveDesign& solve);

// Marks of the trade-off for the script: words of "first", "affordable" and "knee", or null;
// "heading", the kind of the affordable design: "Fewest sheaths within 2 %"; "advised", the designs
// that plots mark; "named", the words of the named designs.
Json tradeoff_marks(const ExploreReport& report);

struct AdvisedDesign {
  std::string word;
  std::string label;  // "within 2 %", "knee", or both
};
std::vector<AdvisedDesign> advised_designs(const ExploreReport& report);

// Returns the designs that the answer and the trade-off name, the first one first, each once.
std::vector<const ListedDesign*> named_designs(const ExploreReport& report);

// For exploration.mustache: the front and the first designs, and the best by each objective alone.
Json static_tables(const ExploreReport& report);

}  // namespace reeve::pages
