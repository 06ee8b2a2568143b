#include "core/tension/jamming.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "core/tension/tree_kinematics.hpp"

namespace reeve::core {
namespace {

std::uint64_t bit(int finger) { return std::uint64_t{1} << (finger - 1); }

std::uint64_t fingers_of(const Network& network, std::size_t tree) {
  std::uint64_t fingers = 0;
  for (const TendonSpan& tendon : network.tendons) {
    if (tendon.tree != tree) continue;
    for (std::size_t i = 0; i < tendon.segments; ++i) {
      const Segment& segment = network.segments[tendon.first_segment + i];
      if (segment.kind == SegmentKind::strand) fingers |= bit(segment.finger);
    }
  }
  return fingers;
}

double sets_of(std::uint64_t fingers) { return std::ldexp(1.0, std::popcount(fingers)); }

// The next subset of `all` after `set` in the order of numbers; 0 after the last.
std::uint64_t next_subset(std::uint64_t set, std::uint64_t all) { return (set - all) & all; }

bool comes_first(std::uint64_t a, std::uint64_t b) {
  const int a_size = std::popcount(a);
  const int b_size = std::popcount(b);
  if (a_size != b_size) return a_size < b_size;
  // Among sets with equally many fingers the lower numbers come first.
  const std::uint64_t different = a ^ b;
  return (a & different & (~different + 1)) != 0;
}

// Keeps the sets that hold none of the others.
void keep_smallest(std::vector<std::uint64_t>& sets) {
  std::sort(sets.begin(), sets.end(), comes_first);
  std::vector<std::uint64_t> kept;
  for (const std::uint64_t set : sets) {
    const bool holds_one = std::any_of(kept.begin(), kept.end(), [&](std::uint64_t smaller) {
      return (set & smaller) == smaller;
    });
    if (!holds_one) kept.push_back(set);
  }
  sets = std::move(kept);
}

}  // namespace

JamFinder::TreeJams& JamFinder::next() {
  if (count_ == trees_.size()) trees_.emplace_back();
  TreeJams& jams = trees_[count_++];
  jams.tried = jams.too_many = false;
  jams.jamming.clear();
  return jams;
}

template <typename Moves>
void JamFinder::try_all(Moves moves, TreeJams& jams) {
  jams.tried = true;
  jams.moving = 0;
  jams.too_many = std::popcount(jams.fingers) > most_fingers_tried;
  if (jams.too_many) return;
  std::uint64_t held = 0;
  do {
    if (moves(Grasp{held})) {
      ++jams.moving;
    } else {
      jams.jamming.push_back(held);
    }
    held = next_subset(held, jams.fingers);
  } while (held != 0);
}

void JamFinder::find_tree(const Network& network, const Mechanics& mechanics, std::size_t tree,
                          TreeJams& jams) {
  jams.fingers = fingers_of(network, tree);
  if (is_tied(network, network.tendons[tree])) {
    if (!travel_ratios(network, mechanics, tree, ratios_)) {
      const auto moves = [&](Grasp grasp) {
        return solve_tree_kinematics(network, mechanics, grasp, tree, closing_, block_travel_)
            .moves();
      };
      try_all(moves, jams);
      return;
    }
  } else if (taut_share(network, network.tendons[tree], mechanics, Grasp{}) == 0) {
    jams.tried = true;
    jams.moving = sets_of(jams.fingers);
    return;
  } else {
    ratios_ = mechanics.closing;
  }
  jams.needed = 0;
  for (int finger = 1; finger <= network.fingers; ++finger) {
    const double ratio = ratios_[static_cast<std::size_t>(finger) - 1];
    if ((jams.fingers & bit(finger)) != 0 && ratio > 0) jams.needed |= bit(finger);
  }
  jams.moving = sets_of(jams.fingers) - sets_of(jams.fingers & ~jams.needed);
}

void JamFinder::find(const Network& network, const Mechanics& mechanics) {
  count_ = 0;
  closing_.assign(static_cast<std::size_t>(network.fingers), 0.0);
  block_travel_.assign(network.blocks.size(), 0.0);
  if (network.split || network.shared) {
    TreeJams& jams = next();
    jams.fingers = network.fingers == 0 ? 0 : ~std::uint64_t{0} >> (64 - network.fingers);
    const auto moves = [&](Grasp grasp) {
      kinematics_.solve(network, mechanics, grasp, Direction::pull, motion_);
      return std::find(motion_.jams.begin(), motion_.jams.end(), 1) == motion_.jams.end();
    };
    try_all(moves, jams);
    return;
  }
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    if (network.tendons[t].tree == t) find_tree(network, mechanics, t, next());
  }
}

double JamFinder::grasps(const Network& network, const Mechanics& mechanics) {
  find(network, mechanics);
  double moving = 1;
  std::uint64_t bound = 0;
  for (std::size_t t = 0; t < count_; ++t) {
    if (trees_[t].too_many) return std::numeric_limits<double>::infinity();
    moving *= trees_[t].moving;
    bound |= trees_[t].fingers;
  }
  moving *= std::ldexp(1.0, network.fingers - std::popcount(bound));
  return std::max(std::ldexp(1.0, network.fingers) - 1 - moving, 0.0);
}

std::vector<Grasp> JamFinder::smallest(const Network& network, const Mechanics& mechanics) {
  find(network, mechanics);
  const auto begin = trees_.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(count_);
  if (std::any_of(begin, end, [](const TreeJams& tree) { return tree.too_many; })) return {};
  std::vector<std::uint64_t> sets;
  for (auto tree = begin; tree != end; ++tree) {
    if (tree->tried) {
      keep_smallest(tree->jamming);
      sets.insert(sets.end(), tree->jamming.begin(), tree->jamming.end());
    } else {
      sets.push_back(tree->needed);
    }
  }
  keep_smallest(sets);
  std::vector<Grasp> grasps;
  for (const std::uint64_t held : sets) {
    if (std::popcount(held) < network.fingers) grasps.push_back(Grasp{held});
  }
  return grasps;
}

}  // namespace reeve::core
