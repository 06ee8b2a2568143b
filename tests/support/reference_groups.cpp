#include "tests/support/reference_groups.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace reeve::testing::reference {

namespace {

void join(const TreeContact& contact, Real difference, Groups& groups) {
  const auto l = static_cast<std::size_t>(contact.left),
             r = static_cast<std::size_t>(contact.right);
  const Index kept = groups.of[l], gone = groups.of[r];
  if (kept == gone) return;
  const Real shift = groups.rho(contact.left) - difference - groups.rho(contact.right);
  for (std::size_t i = 0; i < groups.of.size(); ++i) {
    if (groups.of[i] != gone) continue;
    groups.of[i] = kept;
    groups.rho(static_cast<Index>(i)) += shift;
  }
}

// Numbers the groups from 0 and counts rho from the tightest segment of each.
Index renumber(Groups& groups) {
  std::map<Index, Index> number;
  std::map<Index, Real> greatest;
  for (std::size_t i = 0; i < groups.of.size(); ++i) {
    const Index g = groups.of[i];
    const Real rho = groups.rho(static_cast<Index>(i));
    number.emplace(g, static_cast<Index>(number.size()));
    greatest[g] = greatest.contains(g) ? std::max(greatest[g], rho) : rho;
  }
  for (std::size_t i = 0; i < groups.of.size(); ++i) {
    groups.rho(static_cast<Index>(i)) -= greatest[groups.of[i]];
    groups.of[i] = number[groups.of[i]];
  }
  return static_cast<Index>(number.size());
}

}  // namespace

std::vector<Known> known_by_kinematics(const Tree& tree) {
  std::vector<Known> known;
  for (std::size_t k = 0; k < tree.contacts.size(); ++k) {
    const TreeContact& contact = tree.contacts[k];
    if (contact.bar)
      known.push_back({k, contact.arms});
    else if (tied(contact.phi))
      known.push_back({k, 0});
    else if (contact.slip != 0)
      known.push_back({k, contact.slip > 0 ? -contact.phi : contact.phi});
  }
  return known;
}

Groups gather(const Tree& tree, const std::vector<Known>& known) {
  Groups groups;
  const Index segments = tree.length.size();
  groups.rho = Vector::Zero(segments);
  for (Index i = 0; i < segments; ++i) groups.of.push_back(i);
  for (const auto& [contact, difference] : known) join(tree.contacts[contact], difference, groups);
  const Index count = renumber(groups);
  groups.stretch = groups.elastic = Vector::Zero(count);
  groups.imposed = groups.pull = Matrix::Zero(count, tree.hangs.cols());
  for (Index i = 0; i < segments; ++i) {
    const Index g = groups.of[static_cast<std::size_t>(i)];
    const Real relative = std::exp(groups.rho(i));
    groups.stretch(g) += tree.c(i) * tree.length(i) * relative;
    groups.elastic(g) += tree.c(i) * tree.elastic(i);
    groups.imposed.row(g) += tree.c(i) * tree.hangs.row(i);
    groups.pull.row(g) += relative * tree.hangs.row(i);
  }
  return groups;
}

}  // namespace reeve::testing::reference
