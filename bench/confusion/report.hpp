// Tables and rates of diagnosed trials, as Markdown.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "bench/confusion/trial.hpp"

namespace reeve::bench {

// A share with its exact 95 % interval (C. J. Clopper and E. S. Pearson, 1934).
struct Rate {
  std::size_t hits = 0;
  std::size_t of = 0;

  void count(bool hit) {
    hits += hit ? 1 : 0;
    ++of;
  }
  double share() const;
  double low() const;
  double high() const;
};

// Table of the outcomes of one part, and the requirement. Effects whose oracle's log-likelihood
// ratio is not above `visible` are listed, but do not count.
std::string report(Part part, const std::vector<Outcome>& outcomes, double visible);

// One line for each outcome that is not what it should be: seed, hidden, found.
std::string misses(const std::vector<Outcome>& outcomes, double visible);

bool as_it_should_be(const Outcome& outcome);

}  // namespace reeve::bench
