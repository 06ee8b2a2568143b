// A score: one number out of several objectives.
//
//   score = Σ w_i g_i / Σ w_i,   g_i: the objective's value, negative where lower is better
//
// The default is the mean of the five indicators by which the authors of the dual-tendon routings
// judge them (core/indicators.hpp).
#pragma once

#include <string>
#include <vector>

#include "search/evaluate/objectives.hpp"

namespace reeve::search {

struct ScoreTerm {
  Objective objective{};
  double weight = 1;  // above 0
};

struct Score {
  std::vector<ScoreTerm> terms;  // at least one, no objective twice, not the score itself
};

Score authors_score();

// Fills in the score of values whose other objectives are there.
void add_score(const Score& score, ObjectiveValues& values);

// "authors", or "uniformity=2,sheaths=0.1": objectives with weights, 1 if none is given. Throws
// InputError.
Score parse_score(const std::string& text);

// "adaptability=2,reliability=1": as it is read.
std::string to_text(const Score& score);

}  // namespace reeve::search
