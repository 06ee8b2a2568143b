#include "search/evaluate/tree_spans.hpp"

#include <algorithm>
#include <optional>

namespace reeve::search {
namespace {

using BlockSet = std::uint64_t;  // a bit for each block_key
static_assert(block_keys <= 64);

class KeyWriter {
 public:
  void put(unsigned digit) {
    if (word_ < TreeKey::words) key_.bits[word_] |= static_cast<std::uint64_t>(digit) << shift_;
    shift_ += 4;
    if (shift_ == 64) {
      shift_ = 0;
      ++word_;
    }
  }
  bool fits() const { return word_ < TreeKey::words || (word_ == TreeKey::words && shift_ == 0); }
  const TreeKey& key() const { return key_; }

 private:
  TreeKey key_;
  std::size_t word_ = 0;
  unsigned shift_ = 0;
};

// No kind of token has these digits, and no digit is 0, which is what follows a key's end.
constexpr unsigned bearing_tip = 13;
constexpr unsigned open_end = 14;
constexpr unsigned closed_end = 15;
static_assert(static_cast<unsigned>(TokenKind::movable_pulley) + 1 < bearing_tip);

unsigned digit(const Token& token) {
  const bool bearing = token.kind == TokenKind::finger && token.tip == TipKind::bearing;
  return bearing ? bearing_tip : static_cast<unsigned>(token.kind) + 1;
}

BlockSet blocks_of(const Tendon& tendon) {
  BlockSet blocks = 0;
  for (const Token& token : tendon.walk) {
    if (is_of_block(token.kind)) blocks |= BlockSet{1} << block_key(token);
  }
  return blocks;
}

BlockCount least_numbers(const Routing& routing, const TreeSpan& span) {
  BlockCount least{max_blocks, max_blocks};
  for (std::size_t t = span.begin; t < span.end; ++t) {
    for (const Token& token : routing.tendons[t].walk) {
      if (is_of_block(token.kind)) least.of(token) = std::min<int>(least.of(token), token.block);
    }
  }
  return least;
}

// Up to the last tendon that shares a block with one before it.
std::size_t end_of_tree(const Routing& routing, std::size_t begin) {
  std::size_t end = begin + 1;
  BlockSet tied = blocks_of(routing.tendons[begin]);
  if (tied == 0) return end;
  for (std::size_t t = end; t < routing.tendons.size(); ++t) {
    const BlockSet blocks = blocks_of(routing.tendons[t]);
    if ((tied & blocks) == 0) continue;
    for (; end <= t; ++end) tied |= blocks_of(routing.tendons[end]);
  }
  return end;
}

// Puts a number from 1 on; false if it has no digit.
bool put_number(int number, KeyWriter& key) {
  if (number > 15) return false;
  key.put(static_cast<unsigned>(number));
  return true;
}

// Fills in fingers and key.
bool read_tree(const Routing& routing, TreeSpan& span) {
  KeyWriter key;
  std::optional<BlockCount> first;
  for (std::size_t t = span.begin; t < span.end; ++t) {
    for (const Token& token : routing.tendons[t].walk) {
      if (token.angle.is_given()) return false;
      key.put(digit(token));
      if (is_of_finger(token.kind)) {
        if (token.finger != span.fingers_before + ++span.fingers) return false;
      } else if (is_of_block(token.kind)) {
        if (!first) first = least_numbers(routing, span);
        if (!put_number(token.block - first->of(token) + 1, key)) return false;
        if (token.kind == TokenKind::bar_arms &&
            !(put_number(token.arms.left, key) && put_number(token.arms.right, key))) {
          return false;
        }
      }
    }
    key.put(routing.tendons[t].closed ? closed_end : open_end);
  }
  span.key = key.key();
  return key.fits();
}

}  // namespace

TreeSums& TreeSums::operator+=(const TreeSums& other) {
  jams |= other.jams;
  in_range &= other.in_range;
  motor += other.motor;
  strands.least = std::min(strands.least, other.strands.least);
  strands.most = std::max(strands.most, other.strands.most);
  strands.sum += other.strands.sum;
  strands.work += other.strands.work;
  return *this;
}

std::size_t TreeKey::Hash::operator()(const TreeKey& key) const {
  // Odd multipliers, and the high half onto the low one: D. Knuth, TAOCP 3, section 6.4.
  std::uint64_t sum = 0;
  for (const std::uint64_t word : key.bits) {
    sum = (sum ^ word) * 0x9E3779B97F4A7C15U;
    sum ^= sum >> 32;
  }
  return sum;
}

bool split_into_trees(const Routing& routing, std::vector<TreeSpan>& spans) {
  spans.clear();
  int fingers = 0;
  for (std::size_t begin = 0; begin < routing.tendons.size();) {
    TreeSpan& span = spans.emplace_back();
    span.begin = begin;
    span.end = end_of_tree(routing, begin);
    span.fingers_before = fingers;
    if (!read_tree(routing, span)) return false;
    fingers += span.fingers;
    begin = span.end;
  }
  return true;
}

void copy_tree(const Routing& routing, const TreeSpan& span, Routing& tree) {
  const auto at = [&](std::size_t t) {
    return routing.tendons.begin() + static_cast<std::ptrdiff_t>(t);
  };
  tree.tendons.assign(at(span.begin), at(span.end));
  const BlockCount first = least_numbers(routing, span);
  for (Tendon& tendon : tree.tendons) {
    for (Token& token : tendon.walk) {
      if (is_of_finger(token.kind)) {
        token.finger = static_cast<std::uint8_t>(token.finger - span.fingers_before);
      } else if (is_of_block(token.kind)) {
        token.block = static_cast<std::uint8_t>(token.block - first.of(token) + 1);
      }
    }
  }
}

}  // namespace reeve::search
