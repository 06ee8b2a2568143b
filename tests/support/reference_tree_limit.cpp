#include "tests/support/reference_tree_limit.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>

#include "tests/support/reference_groups.hpp"
#include "tests/support/reference_tree_check.hpp"
#include "tests/support/reference_tree_interior.hpp"

namespace reeve::testing::reference {

namespace {

// Given the sides, groups and blocks leave a linear system of the size of the blocks.
TreeState state_of(const Tree& tree, std::vector<Verdict> verdicts) {
  std::stable_sort(verdicts.begin(), verdicts.end(),
                   [](const Verdict& a, const Verdict& b) { return a.certainty > b.certainty; });
  TreeState state;
  std::vector<Known> known = known_by_kinematics(tree);
  state.side.assign(tree.contacts.size(), 0);
  for (const auto& [contact, side, certainty] : verdicts) {
    state.side[contact] = side;
    if (side != 0) known.push_back({contact, static_cast<Real>(side) * tree.contacts[contact].phi});
  }
  const Groups groups = gather(tree, known);
  const Matrix give = groups.stretch.cwiseInverse().asDiagonal() * groups.imposed;
  const Vector alone = groups.elastic.cwiseQuotient(groups.stretch);
  Matrix response = groups.pull.transpose() * give;
  for (Index b = 0; b < response.rows(); ++b)
    if (response.row(b).isZero(0)) response(b, b) = 1;
  state.z = -solved_for_blocks(response, groups.pull.transpose() * alone);
  const Vector level = alone + give * state.z;
  state.tension.resize(tree.length.size());
  for (Index i = 0; i < state.tension.size(); ++i)
    state.tension(i) = level(groups.of[static_cast<std::size_t>(i)]) * std::exp(groups.rho(i));
  return state;
}

// Moves what violates a condition to where it belongs: all of it at first, then only the worst,
// lest two repairs undo each other.
void repair(const std::vector<Fault>& faults, bool all, std::vector<Verdict>& verdicts) {
  const auto worst = std::max_element(
      faults.begin(), faults.end(), [](const Fault& a, const Fault& b) { return a.size < b.size; });
  for (Verdict& verdict : verdicts)
    for (const Fault& fault : faults)
      if (fault.contact == verdict.contact && (all || fault.contact == worst->contact))
        verdict.side = fault.belongs;
}

std::optional<TreeState> taut(const Tree& tree) {
  std::optional<std::vector<Verdict>> verdicts = open_contacts(tree);
  if (!verdicts) return std::nullopt;
  for (int attempt = 0; attempt < 60; ++attempt) {
    const TreeState state = state_of(tree, *verdicts);
    const TreeFaults faults = check(tree, state);
    if (faults.none()) return state;
    if (faults.contacts.empty()) return std::nullopt;
    repair(faults.contacts, attempt < 5, *verdicts);
  }
  return std::nullopt;
}

// The tree with some of its tendons left out.
struct Part {
  Tree tree;
  std::vector<Index> segments;  // in the whole
};

Part part_without(const Tree& whole, const std::vector<bool>& slack) {
  Part part;
  std::vector<std::size_t> contacts;
  for (std::size_t t = 0; t < whole.spans.size(); ++t) {
    if (slack[t]) continue;
    Span span = whole.spans[t];
    const Index shift = static_cast<Index>(part.segments.size()) - span.segment;
    for (Index i = 0; i < span.segments; ++i) part.segments.push_back(span.segment + i);
    for (Index k = span.contact; k < span.contact + span.contacts; ++k) {
      TreeContact contact = whole.contacts[static_cast<std::size_t>(k)];
      contact.left += shift;
      contact.right += shift;
      part.tree.contacts.push_back(contact);
    }
    span.segment += shift;
    span.contact = static_cast<Index>(part.tree.contacts.size()) - span.contacts;
    part.tree.spans.push_back(span);
  }
  part.tree.length = whole.length(part.segments);
  part.tree.motor = whole.motor(part.segments);
  part.tree.c = whole.c(part.segments);
  part.tree.elastic = whole.elastic(part.segments);
  part.tree.hangs = whole.hangs(part.segments, Eigen::all);
  return part;
}

// Every block is pulled from both sides, or from neither.
bool can_balance(const Matrix& hangs) {
  for (Index b = 0; b < hangs.cols(); ++b)
    if ((hangs.col(b).maxCoeff() > 0) != (hangs.col(b).minCoeff() < 0)) return false;
  return true;
}

std::optional<Vector> with_slack(const Tree& tree, const std::vector<bool>& slack) {
  const Part part = part_without(tree, slack);
  if (!can_balance(part.tree.hangs) || !(part.tree.elastic.sum() > 0)) return std::nullopt;
  const std::optional<TreeState> found = taut(part.tree);
  if (!found || !slack_fits(tree, slack, found->z)) return std::nullopt;
  Vector tension = Vector::Zero(tree.length.size());
  tension(part.segments) = found->tension;
  return tension;
}

}  // namespace

Vector tree_tensions(const Tree& tree) {
  if (!tree.slack.empty()) {
    const Part part = part_without(tree, tree.slack);
    Vector tension = Vector::Zero(tree.length.size());
    tension(part.segments) = tree_tensions(part.tree);
    return tension;
  }
  if (const auto found = taut(tree)) return found->tension;
  const std::size_t tendons = tree.spans.size();
  for (std::size_t count = 1; count < tendons; ++count) {
    std::vector<bool> slack(tendons, false);
    std::fill_n(slack.begin(), count, true);
    do {
      if (const auto found = with_slack(tree, slack)) return *found;
    } while (std::prev_permutation(slack.begin(), slack.end()));
  }
  throw std::logic_error("reference model: no state of the tree meets its conditions");
}

}  // namespace reeve::testing::reference
