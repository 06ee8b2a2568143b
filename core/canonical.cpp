#include "core/canonical.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/walk_image.hpp"

namespace reeve::core {
namespace {

// The canonical order of the tendons that blocks and bars tie together.
//
// A tree begins with a tendon that passes no block, the least in the order of canonical.hpp; then
// come, block by block in the order in which the words name them, the other tendons of that block.
// Blocks, and bars likewise, are numbered as they appear. Which of two tendons, or of two ways to
// walk one, is the lesser is decided by their shapes, then by what hangs on their blocks: tendons
// and blocks get ranks, which are refined by each other's until no more can be told apart
// (colour refinement). In a tree what still ties is alike.

using Rank = int;
// Ranks in the order of comparison.
using Signature = std::vector<Rank>;

Rank shape_code(const Token& token) {
  const auto kind = static_cast<Rank>(token.kind);
  const Rank part =
      (kind * 3 + static_cast<Rank>(token.tip)) * (max_carriages + 1) + token.carriage;
  return (part << 16) + token.arms.left;
}

template <typename Key>
std::map<Key, Rank> ranked(const std::vector<Key>& keys) {
  std::map<Key, Rank> rank;
  for (const Key& key : keys) rank[key] = 0;
  Rank next = 0;
  for (auto& [key, number] : rank) number = next++;
  return rank;
}

class Refinement {
 public:
  Refinement(const std::vector<Tendon>& tendons, FingerIdentity identity)
      : tendons_(tendons), identity_(identity), tendon_rank_(tendons.size(), 0) {
    block_rank_.fill(0);
    images_.resize(tendons.size());
    std::size_t classes = 0;
    while (true) {
      const std::size_t now = refine_tendons() + refine_blocks();
      if (now == classes) break;
      classes = now;
    }
  }

  Rank rank(std::size_t tendon) const { return tendon_rank_[tendon]; }
  Image image(std::size_t tendon) const { return images_[tendon].front(); }

 private:
  Signature signature(const Tendon& tendon, Image image) const {
    Signature all;
    const std::size_t n = tendon.walk.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Token token = image_token(tendon.walk, image, i);
      all.push_back(shape_code(token));
      all.push_back(token.arms.right);
      all.push_back(static_cast<Rank>(token.angle.millidegrees));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Token token = image_token(tendon.walk, image, i);
      all.push_back(is_of_block(token.kind) ? block_rank_[block_key(token)] : 0);
    }
    if (identity_ == FingerIdentity::identical) return all;
    for (std::size_t i = 0; i < n; ++i) {
      all.push_back(image_token(tendon.walk, image, i).finger);
    }
    return all;
  }

  // Returns the place of a token in the least image; the first place if several images are least.
  Rank first_place(std::size_t tendon, std::size_t index) const {
    const std::size_t n = tendons_[tendon].walk.size();
    std::size_t first = n;
    for (const Image image : images_[tendon]) {
      const std::size_t place = image.backward ? image.start + n - index : index + n - image.start;
      first = std::min(first, place % n);
    }
    return static_cast<Rank>(first);
  }

  // The number of classes.
  std::size_t refine_tendons() {
    std::vector<std::pair<Rank, Signature>> keys;
    for (std::size_t t = 0; t < tendons_.size(); ++t) {
      Signature least;
      images_[t].clear();
      for_each_image(tendons_[t], [&](Image image) {
        Signature other = signature(tendons_[t], image);
        if (images_[t].empty() || other < least) {
          least = std::move(other);
          images_[t] = {image};
        } else if (other == least) {
          images_[t].push_back(image);
        }
        return true;
      });
      Signature whole{-core::finger_count(tendons_[t]), tendons_[t].closed ? 1 : 0};
      whole.insert(whole.end(), least.begin(), least.end());
      keys.emplace_back(tendon_rank_[t], std::move(whole));
    }
    const auto rank = ranked(keys);
    for (std::size_t t = 0; t < keys.size(); ++t) tendon_rank_[t] = rank.at(keys[t]);
    return rank.size();
  }

  // A block is told by the tendons on it, where on them it is, and how.
  std::size_t refine_blocks() {
    std::array<std::vector<Signature>, block_keys> places;
    for (std::size_t t = 0; t < tendons_.size(); ++t) {
      const Walk& walk = tendons_[t].walk;
      for (std::size_t i = 0; i < walk.size(); ++i) {
        if (!is_of_block(walk[i].kind)) continue;
        places[block_key(walk[i])].push_back({tendon_rank_[t], first_place(t, i)});
      }
    }
    std::vector<std::pair<Rank, std::vector<Signature>>> keys;
    for (std::size_t b = 0; b < block_keys; ++b) {
      std::sort(places[b].begin(), places[b].end());
      keys.emplace_back(block_rank_[b], std::move(places[b]));
    }
    const auto rank = ranked(keys);
    for (std::size_t b = 0; b < block_keys; ++b) block_rank_[b] = rank.at(keys[b]);
    return rank.size();
  }

  const std::vector<Tendon>& tendons_;
  FingerIdentity identity_;
  std::vector<Rank> tendon_rank_;
  std::array<Rank, block_keys> block_rank_{};
  std::vector<std::vector<Image>> images_;  // images with the least signature, by tendon
};

bool passes_a_block(const Tendon& tendon) {
  return std::any_of(tendon.walk.begin(), tendon.walk.end(), [](const Token& token) {
    return is_of_block(token.kind) && !is_tail(token.kind);
  });
}

bool is_on(const Tendon& tendon, std::size_t key) {
  return std::any_of(tendon.walk.begin(), tendon.walk.end(), [&](const Token& token) {
    return is_of_block(token.kind) && block_key(token) == key;
  });
}

// All tendons of one tree.
std::vector<Tendon> canonical_tree(const std::vector<Tendon>& tendons, FingerIdentity identity) {
  const Refinement refinement(tendons, identity);
  std::vector<Tendon> result;
  std::vector<std::size_t> to_visit;  // blocks, in the order of their names
  std::set<std::size_t> seen;
  std::vector<bool> listed(tendons.size(), false);
  const auto list_least = [&](auto wanted) {
    std::size_t least = tendons.size();
    for (std::size_t t = 0; t < tendons.size(); ++t) {
      if (listed[t] || !wanted(tendons[t])) continue;
      if (least == tendons.size() || refinement.rank(t) < refinement.rank(least)) least = t;
    }
    if (least == tendons.size()) return false;
    listed[least] = true;
    result.push_back(walked(tendons[least], refinement.image(least)));
    for (const Token& token : result.back().walk) {
      if (!is_of_block(token.kind)) continue;
      if (seen.insert(block_key(token)).second) to_visit.push_back(block_key(token));
    }
    return true;
  };
  list_least([](const Tendon& tendon) { return !passes_a_block(tendon); });
  for (std::size_t i = 0; i < to_visit.size(); ++i) {
    const std::size_t key = to_visit[i];
    while (list_least([key](const Tendon& tendon) { return is_on(tendon, key); })) {
    }
  }
  number_blocks_in_order(result);
  return result;
}

std::strong_ordering compare_shapes(const Walk& walk, Image a, Image b) {
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const auto order = compare_shapes(image_token(walk, a, i), image_token(walk, b, i));
    if (order != 0) return order;
  }
  return std::strong_ordering::equal;
}

std::strong_ordering compare(const Walk& walk, Image a, Image b) {
  if (const auto shape = compare_shapes(walk, a, b); shape != 0) return shape;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const auto order = image_token(walk, a, i).finger <=> image_token(walk, b, i).finger;
    if (order != 0) return order;
  }
  return std::strong_ordering::equal;
}

// Returns how many first tokens hold all that a comparison of shapes with this image looks at.
std::size_t compared_tokens(const Walk& walk, Image image) {
  std::size_t tokens = 0;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    tokens = std::max({tokens, i + 1, image_index(walk, image, i) + 1});
    if (compare_shapes(walk[i], image_token(walk, image, i)) != 0) break;
  }
  return tokens;
}

bool moves_a_finger(const Walk& walk, Image image) {
  for (std::size_t i = 0; i < walk.size(); ++i) {
    if (is_of_finger(walk[i].kind) && image_index(walk, image, i) != i) return true;
  }
  return false;
}

Tendon least_image(const Tendon& tendon) {
  Image least = as_it_stands;
  for_each_image(tendon, [&](Image image) {
    if (compare(tendon.walk, image, least) < 0) least = image;
    return true;
  });
  return walked(tendon, least);
}

using Tree = std::vector<Tendon>;

template <typename Number>
std::strong_ordering compare_numbers(const Tree& a, const Tree& b, Number number) {
  for (std::size_t t = 0; t < a.size(); ++t) {
    for (std::size_t i = 0; i < a[t].walk.size(); ++i) {
      const auto order = number(a[t].walk[i]) <=> number(b[t].walk[i]);
      if (order != 0) return order;
    }
  }
  return std::strong_ordering::equal;
}

int finger_count(const Tree& tree) {
  int count = 0;
  for (const Tendon& tendon : tree) count += core::finger_count(tendon);
  return count;
}

// Blocks are numbered within each tree.
bool precedes(const Tree& a, const Tree& b) {
  if (const auto fingers = finger_count(b) <=> finger_count(a); fingers != 0) return fingers < 0;
  const auto shapes = std::lexicographical_compare_three_way(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const Tendon& x, const Tendon& y) { return compare_shapes(x, y); });
  if (shapes != 0) return shapes < 0;
  const auto blocks = compare_numbers(a, b, [](const Token& token) { return token.block; });
  if (blocks != 0) return blocks < 0;
  return compare_numbers(a, b, [](const Token& token) { return token.finger; }) < 0;
}

// Number of all fingers that no two tendons share, behind those of the others.
constexpr std::uint8_t unshared = max_fingers;

void number_fingers_in_order(Routing& routing) {
  std::array<std::uint8_t, max_fingers + 1> numbers{};
  std::uint8_t next = 1;
  for (Tendon& tendon : routing.tendons) {
    for (Token& token : tendon.walk) {
      if (!is_of_finger(token.kind)) continue;
      std::uint8_t& number = numbers[token.finger];
      if (number == 0 || token.finger == 0 || token.finger == unshared) number = next++;
      token.finger = number;
    }
  }
}

std::vector<Tree> canonical_trees(const Routing& routing, FingerIdentity identity) {
  const std::vector<std::size_t> tree_of = trees(routing);
  std::vector<Tree> all(tree_of.empty() ? 0
                                        : 1 + *std::max_element(tree_of.begin(), tree_of.end()));
  for (std::size_t t = 0; t < tree_of.size(); ++t) {
    all[tree_of[t]].push_back(routing.tendons[t]);
  }
  for (Tree& tree : all) {
    const bool tied = std::any_of(tree[0].walk.begin(), tree[0].walk.end(),
                                  [](const Token& token) { return is_of_block(token.kind); });
    tree = tied ? canonical_tree(tree, identity) : Tree{least_image(tree[0])};
  }
  return all;
}

// Its blocks get the next numbers.
void append(Tree tree, Routing& routing) {
  const BlockCount before = block_count(routing);
  for (Tendon& tendon : tree) {
    for (Token& token : tendon.walk) {
      if (!is_of_block(token.kind)) continue;
      token.block = static_cast<std::uint8_t>(token.block + before.of(token));
    }
    routing.tendons.push_back(std::move(tendon));
  }
}

}  // namespace

bool is_canonical(const Tendon& tendon) { return uncanonical_tokens(tendon) == 0; }

std::size_t uncanonical_tokens(const Tendon& tendon) {
  std::size_t tokens = 0;
  for_each_image(tendon, [&](Image image) {
    if (compare(tendon.walk, image, as_it_stands) < 0) tokens = compared_tokens(tendon.walk, image);
    return tokens == 0;
  });
  return tokens;
}

int symmetries(const Tendon& tendon) {
  int same = 0;
  int still = 0;
  for_each_image(tendon, [&](Image image) {
    if (compare_shapes(tendon.walk, image, as_it_stands) != 0) return true;
    ++same;
    if (!moves_a_finger(tendon.walk, image)) ++still;
    return true;
  });
  return same / still;
}

void number_blocks_in_order(std::span<Tendon> tendons) {
  std::array<std::uint8_t, block_keys> number{};
  std::uint8_t blocks = 0;
  std::uint8_t bars = 0;
  for (Tendon& tendon : tendons) {
    for (Token& token : tendon.walk) {
      if (!is_of_block(token.kind)) continue;
      std::uint8_t& named = number[block_key(token)];
      if (named == 0) named = is_of_bar(token.kind) ? ++bars : ++blocks;
      token.block = named;
    }
  }
}

bool same_shape(const Tendon& a, const Tendon& b) { return compare_shapes(a, b) == 0; }

namespace {

Routing in_order(const Routing& routing, FingerIdentity identity) {
  std::vector<Tree> trees = canonical_trees(routing, identity);
  std::sort(trees.begin(), trees.end(), precedes);
  Routing result;
  for (Tree& tree : trees) append(std::move(tree), result);
  return result;
}

// The shapes of the tendons on a finger, whatever its number.
std::vector<Signature> shapes_on(const Routing& routing, std::uint8_t finger) {
  std::vector<Signature> shapes;
  for (const Tendon& tendon : routing.tendons) {
    const auto is_on_it = [&](const Token& token) { return token.finger == finger; };
    if (std::none_of(tendon.walk.begin(), tendon.walk.end(), is_on_it)) continue;
    Signature& shape = shapes.emplace_back();
    for (const Token& token : least_image(tendon).walk) shape.push_back(shape_code(token));
  }
  std::sort(shapes.begin(), shapes.end());
  return shapes;
}

// Numbers the k fingers that tendons share by 1 … k, in the way that gives the least word. Fingers
// on like tendons have neighbouring numbers.
Routing least_numbering(const Routing& routing) {
  const std::vector<std::uint8_t> shared = second_tendons(routing);
  std::vector<std::pair<std::vector<Signature>, std::uint8_t>> fingers;
  for (const std::uint8_t finger : shared) fingers.emplace_back(shapes_on(routing, finger), finger);
  std::sort(fingers.begin(), fingers.end());
  std::vector<std::size_t> order(shared.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::optional<Routing> least;
  do {
    std::array<std::uint8_t, max_fingers + 1> numbers{};
    std::fill(numbers.begin() + 1, numbers.end(), unshared);
    bool sorted = true;
    for (std::size_t i = 0; i < order.size(); ++i) {
      numbers[fingers[order[i]].second] = static_cast<std::uint8_t>(i + 1);
      sorted &= fingers[order[i]].first == fingers[i].first;
    }
    if (!sorted) continue;
    Routing numbered = routing;
    for (Tendon& tendon : numbered.tendons) {
      for (Token& token : tendon.walk) token.finger = numbers[token.finger];
    }
    numbered = in_order(numbered, FingerIdentity::distinct);
    if (!least || precedes(numbered.tendons, least->tendons)) least = std::move(numbered);
  } while (std::next_permutation(order.begin(), order.end()));
  return *least;
}

// The canonical form in which every motor keeps its number.
Routing canonical_as_numbered(const Routing& routing, FingerIdentity identity) {
  if (identity == FingerIdentity::distinct) return in_order(routing, identity);
  Routing result =
      second_tendons(routing).empty() ? in_order(routing, identity) : least_numbering(routing);
  number_fingers_in_order(result);
  return result;
}

Routing with_carriages(Routing routing, const std::vector<std::uint8_t>& number) {
  for (Tendon& tendon : routing.tendons) {
    for (Token& token : tendon.walk) {
      if (is_on_carriage(token.kind)) token.carriage = number[token.carriage - std::size_t{1}];
    }
  }
  return routing;
}

}  // namespace

// There are at most 6! ways to number the motors.
Routing canonical(const Routing& routing, FingerIdentity identity) {
  Routing least = canonical_as_numbered(routing, identity);
  if (identity == FingerIdentity::distinct) return least;
  std::vector<std::uint8_t> number(static_cast<std::size_t>(carriage_count(routing)));
  std::iota(number.begin(), number.end(), std::uint8_t{1});
  while (std::next_permutation(number.begin(), number.end())) {
    Routing other = canonical_as_numbered(with_carriages(routing, number), identity);
    if (precedes(other.tendons, least.tendons)) least = std::move(other);
  }
  return least;
}

}  // namespace reeve::core
