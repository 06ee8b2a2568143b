// Words of the trade, explained where they stand: a fold below a heading that opens with a click, a
// touch or a key.
#pragma once

#include <string>
#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::pages {

struct Term {
  std::string word;
  std::string meaning;
};

// What stands in every ranking besides its objectives.
std::vector<Term> ranking_terms();
// What stands in a ladder.
std::vector<Term> ladder_terms();
// Of a routing by itself.
std::vector<Term> routing_terms();
// The objectives by the names that pages give them, with their unit and which way is better.
std::vector<Term> objective_terms(const std::vector<Objective>& objectives);

// HTML; `about` says what the words are of: "Words in this table".
std::string glossary_html(const std::string& about, const std::vector<Term>& terms);

}  // namespace reeve::pages
