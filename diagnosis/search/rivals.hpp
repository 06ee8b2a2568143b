// What else could stand in the place of a cause that was accepted.
//
// The other accepted causes are kept and fitted again with each rival. A rival that explains the
// data nearly as well cannot be told from the accepted cause. A law with a shape that can bend to
// what a plainer one says is no rival for that: each parameter is counted with half the logarithm
// of the number of readings (G. Schwarz, Ann. Stat. 6, 1978).
#pragma once

#include <string>
#include <vector>

#include "diagnosis/fit/fit.hpp"
#include "diagnosis/search/candidates.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

// Two causes whose best fits differ by less than this cannot be told apart: were the worse one
// true, noise would favour the better one by as much in at most 1 of 400 data sets, however far
// apart their forecasts are (Φ(−√(2·4)) = 0.0023).
inline constexpr double alias_margin = 4;

struct Rival {
  std::string name;
  Fit fit;
  double deficit = 0;  // in log-likelihood less parameters, to the accepted cause; may be < 0
};

// A rival that is farther off by some of the readings is not looked at by all of them.
inline constexpr double outlier_margin = 3 * alias_margin;

// The most likely first; several of one name (wrong_grasp) may be among them.
std::vector<Rival> rivals(const Problem& problem, const Model& model, std::size_t effect,
                          const std::vector<Candidate>& candidates, Workers& workers);

// The accepted cause first, then what cannot be told from it.
struct Indistinguishable {
  std::vector<std::string> names;
  std::vector<Model> models;  // with each in its place
};

// One name if there is no such rival.
Indistinguishable indistinguishable(const std::string& name, const Model& model,
                                    const std::vector<Rival>& rivals);

}  // namespace reeve::diagnosis
