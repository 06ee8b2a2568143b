#include "tests/support/reference_tree_solve.hpp"

#include <algorithm>
#include <cstddef>

#include "tests/support/reference_problem.hpp"
#include "tests/support/reference_tree.hpp"
#include "tests/support/reference_tree_limit.hpp"

namespace reeve::testing::reference {

namespace {

using PerTendon = std::vector<std::vector<ReferenceContact>>;

void add_tree_contacts(const std::vector<Tendon>& tendons, const Tree& tree, bool moves,
                       PerTendon& contacts) {
  for (const Span& span : tree.spans) {
    const Tendon& tendon = tendons[span.tendon];
    for (Index k = 0; k < span.contacts; ++k) {
      const TreeContact& contact = tree.contacts[static_cast<std::size_t>(span.contact + k)];
      const auto left = static_cast<std::size_t>(contact.left - span.segment);
      const auto right = static_cast<std::size_t>(contact.right - span.segment);
      const Real slip = contact.slip * (1 / tree.c(contact.left) + 1 / tree.c(contact.right)) / 2;
      contacts[span.tendon].push_back({tendon.segments[left].name, tendon.segments[right].name,
                                       tendon.kinds[static_cast<std::size_t>(k)],
                                       static_cast<double>(contact.phi),
                                       moves ? static_cast<double>(slip) : 0.0});
    }
  }
}

void add_tree_closings(const Tree& tree, bool moves, std::map<int, double>& closing) {
  for (const int finger : tree.finger) {
    const auto found = tree.closing.find(finger);
    if (finger == 0) continue;
    closing[finger] =
        moves && found != tree.closing.end() ? static_cast<double>(found->second) : 0.0;
  }
}

void add_tree_tensions(const std::vector<Tendon>& tendons, const Tree& tree, const Vector& value,
                       Real motor, std::map<std::string, double>& tension) {
  for (const Span& span : tree.spans)
    for (Index i = 0; i < span.segments; ++i)
      tension[tendons[span.tendon].segments[static_cast<std::size_t>(i)].name] =
          static_cast<double>(value(span.segment + i) / motor);
}

}  // namespace

ReferenceResult solve_trees(const std::vector<Tendon>& tendons, const std::set<int>& held,
                            ReferenceDirection direction, const ReferenceHardware& hardware) {
  const std::vector<Tree> trees = pose_trees(tendons, held, direction, hardware);
  ReferenceResult result{};
  result.jams = std::any_of(trees.begin(), trees.end(), [](const Tree& tree) { return tree.jams; });
  std::vector<Vector> absolute;
  Real motor = 0;
  for (const Tree& tree : trees) {
    const bool carries = tree.jams == result.jams && !tree.elastic.isZero(0);
    absolute.push_back(carries ? tree_tensions(tree) : Vector::Zero(tree.length.size()));
    for (const Span& span : tree.spans)
      for (Index i = 0; i < span.segments; ++i) {
        const Segment& segment = tendons[span.tendon].segments[static_cast<std::size_t>(i)];
        if (segment.place != Place::motor_side) continue;
        motor += spool(segment, hardware) * absolute.back()(span.segment + i);
      }
  }
  PerTendon contacts(tendons.size());
  for (std::size_t t = 0; t < trees.size(); ++t) {
    add_tree_contacts(tendons, trees[t], !result.jams, contacts);
    add_tree_closings(trees[t], !result.jams, result.closing);
    add_tree_tensions(tendons, trees[t], absolute[t], motor, result.tension);
  }
  for (const auto& of_tendon : contacts)
    result.contacts.insert(result.contacts.end(), of_tendon.begin(), of_tendon.end());
  return result;
}

}  // namespace reeve::testing::reference
