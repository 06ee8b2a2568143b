// The conditions that the tensions of a tree have to meet.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/support/reference_tree.hpp"

namespace reeve::testing::reference {

struct TreeState {
  Vector tension;         // of each segment
  Vector z;               // of each block, at order eps
  std::vector<int> side;  // of each contact: +1 at d = phi, -1 at d = -phi, 0 inside or known
};

// A contact that is not where it belongs.
struct Fault {
  std::size_t contact;
  int belongs;
  Real size;  // relative
};

struct TreeFaults {
  std::vector<Fault> contacts;
  std::string other;  // what no contact can mend: a length, a balance, a tension below 0
  bool none() const { return contacts.empty() && other.empty(); }
};

TreeFaults check(const Tree& tree, const TreeState& state);

// Whether no slack tendon is shorter than what it has to span: sum_i c_i (E_i + C_i z) <= 0, with
// the z of blocks that slack tendons alone hold wherever that allows it.
bool slack_fits(const Tree& tree, const std::vector<bool>& slack, const Vector& z);

}  // namespace reeve::testing::reference
