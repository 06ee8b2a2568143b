#include "core/routing.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace reeve::core {
namespace {

constexpr std::size_t no_tendon = static_cast<std::size_t>(-1);

std::size_t first_of_tree(const std::vector<std::size_t>& parent, std::size_t tendon) {
  while (parent[tendon] != tendon) tendon = parent[tendon];
  return tendon;
}

// For each tendon, the first tendon of its tree.
std::vector<std::size_t> firsts_of_trees(const Routing& routing) {
  std::vector<std::size_t> parent(routing.tendons.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  std::array<std::size_t, block_keys> on_block{};
  on_block.fill(no_tendon);
  for (std::size_t t = 0; t < routing.tendons.size(); ++t) {
    for (const Token& token : routing.tendons[t].walk) {
      if (!is_of_block(token.kind)) continue;
      std::size_t& other = on_block[block_key(token)];
      if (other == no_tendon) other = t;
      const std::size_t a = first_of_tree(parent, other);
      const std::size_t b = first_of_tree(parent, t);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::size_t t = 0; t < parent.size(); ++t) parent[t] = first_of_tree(parent, t);
  return parent;
}

}  // namespace

int finger_count(const Tendon& tendon) {
  return static_cast<int>(
      std::count_if(tendon.walk.begin(), tendon.walk.end(),
                    [](const Token& token) { return is_of_finger(token.kind); }));
}

std::vector<std::uint8_t> second_tendons(const Routing& routing) {
  std::vector<std::uint8_t> fingers;
  std::array<bool, max_fingers + 1> seen{};
  for (const Tendon& tendon : routing.tendons) {
    for (const Token& token : tendon.walk) {
      if (!is_of_finger(token.kind) || token.finger == 0) continue;
      if (std::exchange(seen[token.finger], true)) fingers.push_back(token.finger);
    }
  }
  return fingers;
}

int finger_count(const Routing& routing) {
  int count = 0;
  for (const Tendon& tendon : routing.tendons) count += finger_count(tendon);
  return count - static_cast<int>(second_tendons(routing).size());
}

BlockCount block_count(const Routing& routing) {
  BlockCount count;
  std::uint64_t seen = 0;
  for (const Tendon& tendon : routing.tendons) {
    for (const Token& token : tendon.walk) {
      if (!is_of_block(token.kind)) continue;
      const std::uint64_t bit = std::uint64_t{1} << block_key(token);
      if ((seen & bit) == 0) ++(is_of_bar(token.kind) ? count.bars : count.blocks);
      seen |= bit;
    }
  }
  return count;
}

std::vector<std::size_t> trees(const Routing& routing) {
  std::vector<std::size_t> tree = firsts_of_trees(routing);
  std::size_t count = 0;
  for (std::size_t t = 0; t < tree.size(); ++t) {
    tree[t] = tree[t] == t ? count++ : tree[tree[t]];
  }
  return tree;
}

int carriage_count(const Routing& routing) {
  int count = 0;
  for (const Tendon& tendon : routing.tendons) {
    for (const Token& token : tendon.walk) {
      if (is_on_carriage(token.kind)) count = std::max<int>(count, token.carriage);
    }
  }
  return count;
}

bool is_actuated(const Tendon& tendon) {
  return std::any_of(tendon.walk.begin(), tendon.walk.end(),
                     [](const Token& token) { return is_on_carriage(token.kind); });
}

bool is_actuated(const Routing& routing) {
  const bool each = std::all_of(routing.tendons.begin(), routing.tendons.end(),
                                [](const Tendon& tendon) { return is_actuated(tendon); });
  const BlockCount count = block_count(routing);
  if (each || count.blocks + count.bars == 0) return each;
  const std::vector<std::size_t> tree = firsts_of_trees(routing);
  std::vector<bool> pulled(tree.size(), false);
  for (std::size_t t = 0; t < tree.size(); ++t) {
    if (is_actuated(routing.tendons[t])) pulled[tree[t]] = true;
  }
  return std::all_of(tree.begin(), tree.end(), [&](std::size_t first) { return pulled[first]; });
}

}  // namespace reeve::core
