// Words of the trade, explained where they stand: a fold below a heading that opens with a click, a
// touch or a key.
#pragma once

#include <string>
#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::pages {

struct GlossaryTerm {
  std::string word;
  std::string meaning;
};

// Terms of every ranking besides its objectives.
std::vector<GlossaryTerm> ranking_terms();
// Terms of a trade-off.
std::vector<GlossaryTerm> tradeoff_terms();
// Terms of a routing by itself.
std::vector<GlossaryTerm> routing_terms();
// The objectives by the names that pages give them, with their unit and which way is better.
std::vector<GlossaryTerm> objective_terms(const std::vector<Objective>& objectives);

// HTML; `about` says what the words are of: "Words in this table".
std::string glossary_html(const std::string& about, const std::vector<GlossaryTerm>& terms);

}  // namespace reeve::pages
