#include "tests/support/reference_model.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tests/support/reference_numbers.hpp"
#include "tests/support/reference_shared.hpp"
#include "tests/support/reference_tree.hpp"
#include "tests/support/reference_tree_limit.hpp"
#include "tests/support/reference_walk.hpp"

namespace reeve::testing {
namespace reference {
namespace {

// Adds the part of one tendon to the answer, its tensions in units that all tendons share.
void add_tendon(const Tendon& tendon, const Tree& tree, const Span& span, const Vector& tension,
                ReferenceResult& result) {
  const auto if_moving = [&](Real way) { return result.jams ? 0 : static_cast<double>(way); };
  for (Index i = 0; i < span.segments; ++i)
    result.tension[tendon.segments[static_cast<std::size_t>(i)].name] =
        static_cast<double>(tension(span.segment + i));
  for (std::size_t k = 0; k < tendon.kinds.size(); ++k) {
    const TreeContact& contact = tree.contacts[static_cast<std::size_t>(span.contact) + k];
    const auto [left, right] = tendon.sides(k);
    const Real slip = contact.slip * (1 / tree.c(contact.left) + 1 / tree.c(contact.right)) / 2;
    result.contacts.push_back(
        {left, right, tendon.kinds[k], static_cast<double>(contact.phi), if_moving(slip)});
  }
  for (const int finger : tendon.fingers) {
    const auto found = tree.closing.find(finger);
    result.closing[finger] = found == tree.closing.end() ? 0 : if_moving(found->second);
  }
}

ReferenceResult solve_trees(const std::vector<Tendon>& tendons, const std::vector<Tree>& trees,
                            const ReferenceHardware& hardware) {
  ReferenceResult result{};
  result.jams = std::any_of(trees.begin(), trees.end(), [](const Tree& tree) { return tree.jams; });
  for (const Tree& tree : trees) {
    const bool carries = tree.jams == result.jams && !tree.elastic.isZero(0);
    const Vector tension = carries ? tree_tensions(tree) : Vector::Zero(tree.length.size());
    for (const Span& span : tree.spans)
      add_tendon(tendons[span.tendon], tree, span, tension, result);
  }
  double motor = 0;
  for (const Tendon& tendon : tendons)
    for (const Segment& segment : tendon.segments)
      if (segment.place == Place::motor_side)
        motor += spool(segment, hardware) * result.tension.at(segment.name);
  for (auto& [segment, tension] : result.tension) tension /= motor;
  return result;
}

}  // namespace
}  // namespace reference

ReferenceResult reference_tensions(const std::string& word, const std::set<int>& held,
                                   ReferenceDirection direction,
                                   const ReferenceHardware& hardware) {
  using namespace reference;
  const std::vector<Tendon> tendons = read_tendons(word);
  if (!share_fingers(tendons))
    return solve_trees(tendons, pose_trees(tendons, held, direction, hardware), hardware);
  const SharedMotion shared = shared_motion(tendons, held, hardware);
  if (!shared.possible) return {true, true, {}, {}, {}};
  return solve_trees(tendons, pose_shared(tendons, shared, direction, hardware), hardware);
}

}  // namespace reeve::testing
