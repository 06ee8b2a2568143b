// How fingers close that several tendons share: second flexors and extensors.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "tests/support/reference_numbers.hpp"

namespace reeve::testing::reference {

struct SharedMotion {
  bool possible = false;        // otherwise tendons oppose each other
  std::map<int, Real> closing;  // dl_f of the fingers that are not held
  std::vector<bool> slack;      // by tendon
};

// Whether some finger has an extensor, or strands of two tendons.
bool share_fingers(const std::vector<Tendon>& tendons);

// With q_t >= 0 the amount by which tendon t closes its fingers (opens those of which it has the
// extensor alone), dl_f = w_f sum_t (+-q_t). Of all sets of tendons that some carriage pulls, one
// is taut: q_t > 0 only there, its tendons lose what their motor sides take in, and no other tendon
// is asked for more than it has. Throws std::invalid_argument for tendons with blocks.
SharedMotion shared_motion(const std::vector<Tendon>& tendons, const std::set<int>& held,
                           const ReferenceHardware& hardware);

}  // namespace reeve::testing::reference
