// Terms that may join a model: the most promising by screening, each fitted in full, and the best
// law among them in its other forms (law_forms.hpp).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "diagnosis/search/cause_screening.hpp"
#include "diagnosis/search/law_families.hpp"
#include "diagnosis/search/searched_model.hpp"

namespace reeve::diagnosis {

// Columns of all terms that were screened, about the model after a number of accepted terms. Parts
// of the readings are searched with the same columns.
struct Screened {
  CauseScreening causes;
  LawTable laws;
};

// How many terms get a fit in a step.
struct Effort {
  std::size_t causes = 7;
  std::size_t faults = 3;  // causes without a size
  std::size_t laws = 6;
  // A search on more readings has been made: readings are seen at the level of what it found, and
  // without weighing alternatives.
  std::optional<ScatterLevel> level{};
  // True if causes without a size are tried beside the hardware's coefficients, too.
  bool beside_hardware = true;
};

// Terms that may join a model beside the coefficients.
struct Vocabulary {
  const std::vector<Effect>& causes;  // candidates
  const std::vector<Effect>& terms;   // laws of the user's, at the price of a name of the library
  Effort effort{};
  // The columns about the model after so many accepted terms.
  std::function<const Screened&(const Model&, std::size_t)> screened{};
};

void most_evident_first(std::vector<Scored>& ways);

// True if a way on from a model of the evidence `from` could be the likeliest at another level of
// scatter, or hardly less likely.
bool is_near(double evidence, double best, double from);

// How the current model's readings are seen: as is likeliest, and with mountings that hardly differ
// and with a motor that does not scatter, so that a term can explain what they would.
std::vector<Likelihood> views(const SearchedModel& search, const Effort& effort);

// Returns the model with each of the terms that promise most in one of the views, the most evident
// first. `accepted` terms are in the model.
std::vector<Scored> ways_on(const SearchedModel& search, const Vocabulary& words,
                            const Scored& from, const std::vector<Likelihood>& views,
                            std::size_t accepted);

}  // namespace reeve::diagnosis
