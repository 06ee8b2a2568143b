#include "core/network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/error.hpp"

namespace reeve::core {
namespace {

class Expansion {
 public:
  explicit Expansion(Network& network) : net_(network) { index_.fill(no_block); }

  // Blocks by number, then the bars.
  void number_blocks(const Routing& routing) {
    std::array<bool, block_keys> named{};
    for (const Tendon& tendon : routing.tendons) {
      for (const Token& token : tendon.walk) {
        if (is_of_block(token.kind)) named[block_key(token)] = true;
      }
    }
    constexpr auto bars = static_cast<std::size_t>(max_blocks);
    for (std::size_t key = 0; key < block_keys; ++key) {
      if (!named[key]) continue;
      index_[key] = net_.blocks.size();
      const bool is_bar = key >= bars;
      net_.blocks.push_back({is_bar, static_cast<int>(is_bar ? key - bars : key) + 1, {}});
    }
  }

  void add(const Tendon& tendon) {
    TendonSpan span{net_.segments.size(), 0, net_.contacts.size(), 0, tendon.closed};
    const Walk& walk = tendon.walk;
    if (!tendon.closed) {
      span.left = end_of(walk.front());
      span.right = end_of(walk.back());
    }
    for (std::size_t i = 0; i < walk.size(); ++i) {
      const bool is_start = i == 0;
      if (!(is_start && tendon.closed)) add_contacts(tendon, i);
      if (i + 1 < walk.size() || tendon.closed) add_gap(tendon, i);
    }
    if (tendon.closed) add_contacts(tendon, 0);
    span.segments = net_.segments.size() - span.first_segment;
    span.contacts = net_.contacts.size() - span.first_contact;
    net_.tendons.push_back(span);
  }

 private:
  static int finger_of(const Token& token) { return is_of_finger(token.kind) ? token.finger : 0; }

  std::size_t block_index(const Token& token) const { return index_[block_key(token)]; }

  TendonEnd end_of(const Token& token) const {
    if (!is_of_block(token.kind)) return {};
    return {is_tail(token.kind) ? EndTie::tail : EndTie::becket, block_index(token)};
  }

  static const Token& behind(const Tendon& tendon, std::size_t i) {
    return tendon.walk[i + 1 == tendon.walk.size() ? 0 : i + 1];
  }

  void add_gap(const Tendon& tendon, std::size_t i) {
    const int left = finger_of(tendon.walk[i]);
    const int right = finger_of(behind(tendon, i));
    if (left != 0) {
      add_strand(tendon.walk[i], 2 * left);
    } else if (right != 0) {
      add_strand(behind(tendon, i), 2 * right - 1);
    } else {
      net_.segments.push_back({SegmentKind::hand, ++hand_, 0});
    }
  }

  // A walk passes a finger from its odd strand to its even one.
  void add_strand(const Token& token, int passed) {
    const bool extensor = token.tip == TipKind::back;
    int number = passed;
    if (token.kind == TokenKind::anchored_tip) {
      const bool second = extensor || std::exchange(has_flexor_[token.finger], true);
      number = 2 * token.finger - (second ? 0 : 1);
    }
    net_.segments.push_back({SegmentKind::strand, number, token.finger, 1, extensor});
  }

  void add_motor_side(const Token& token) {
    net_.segments.push_back({SegmentKind::motor_side, ++motor_side_, 0, token.carriage});
  }

  void add_sheath(int finger) {
    net_.contacts.push_back({ContactKind::sheath, ContactPlace::sheath, finger});
  }

  void add_contacts(const Tendon& tendon, std::size_t i) {
    const Token& token = tendon.walk[i];
    switch (token.kind) {
      case TokenKind::motor_end:
        if (i == 0) {
          add_motor_side(token);
          add_sheath(finger_of(behind(tendon, i)));
        } else {
          add_sheath(finger_of(tendon.walk[i - 1]));
          add_motor_side(token);
        }
        break;
      case TokenKind::fixed_end:
      case TokenKind::anchored_tip:
      case TokenKind::block_tail:
      case TokenKind::becket:
      case TokenKind::bar_pivot:
        break;
      case TokenKind::block_pass:
        net_.contacts.push_back(
            {ContactKind::block, ContactPlace::block, 0, block_index(token), token.angle});
        break;
      case TokenKind::bar_arms:
        net_.contacts.push_back({ContactKind::bar, ContactPlace::block, 0, block_index(token)});
        net_.blocks[block_index(token)].arms = token.arms;
        break;
      case TokenKind::finger:
        net_.contacts.push_back(
            {token.tip == TipKind::tube ? ContactKind::tube : ContactKind::bearing,
             ContactPlace::tip, token.finger, no_block, token.angle});
        break;
      case TokenKind::tube_join:
        net_.contacts.push_back(
            {ContactKind::tube, ContactPlace::hand_join, 0, no_block, token.angle});
        break;
      case TokenKind::bearing_join:
        net_.contacts.push_back(
            {ContactKind::bearing, ContactPlace::hand_join, 0, no_block, token.angle});
        break;
      case TokenKind::movable_pulley:
        add_sheath(finger_of(tendon.walk[i - 1]));
        add_motor_side(token);
        net_.contacts.push_back(
            {ContactKind::bearing, ContactPlace::carriage, 0, no_block, token.angle});
        add_motor_side(token);
        add_sheath(finger_of(behind(tendon, i)));
        break;
    }
  }

  Network& net_;
  std::array<std::size_t, block_keys> index_{};
  std::array<bool, max_fingers + 1> has_flexor_{};
  int motor_side_ = 0;
  int hand_ = 0;
};

int number_from_letters(std::string_view text) {
  int number = 0;
  for (const char c : text) {
    if (c < 'a' || c > 'z' || number > 10000) return 0;
    number = 26 * number + (c - 'a' + 1);
  }
  return number;
}

std::string letters_of(int number) {
  std::string text;
  for (; number > 0; number = (number - 1) / 26) {
    text.insert(text.begin(), static_cast<char>('a' + (number - 1) % 26));
  }
  return text;
}

}  // namespace

void number_trees(Network& network) {
  std::size_t next = 0;
  for (TendonSpan& tendon : network.tendons) tendon.tree = next++;
  if (network.blocks.empty()) return;
  std::array<std::size_t, block_keys> tree_of_block{};
  tree_of_block.fill(no_block);
  const auto join = [&](const TendonSpan& tendon, std::size_t block) {
    if (block == no_block) return;
    std::size_t& tree = tree_of_block[block];
    if (tree == no_block) tree = tendon.tree;
    const std::size_t low = std::min(tree, tendon.tree);
    const std::size_t high = std::max(tree, tendon.tree);
    for (TendonSpan& other : network.tendons) {
      if (other.tree == high) other.tree = low;
    }
    std::replace(tree_of_block.begin(), tree_of_block.end(), high, low);
  };
  for (const TendonSpan& tendon : network.tendons) {
    join(tendon, tendon.left.block);
    join(tendon, tendon.right.block);
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      join(tendon, network.contacts[tendon.first_contact + k].block);
    }
  }
}

namespace {

bool shares_fingers(const Network& network) {
  std::array<std::size_t, max_fingers + 1> tree_of{};
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t i = 0; i < tendon.segments; ++i) {
      const Segment& segment = network.segments[tendon.first_segment + i];
      if (segment.kind != SegmentKind::strand) continue;
      std::size_t& tree = tree_of[static_cast<std::size_t>(segment.finger)];
      if (segment.extensor || (tree != 0 && tree != tendon.tree + 1)) return true;
      tree = tendon.tree + 1;
    }
  }
  return false;
}

}  // namespace

void expand(const Routing& routing, Network& network) {
  network.segments.clear();
  network.contacts.clear();
  network.tendons.clear();
  network.blocks.clear();
  network.fingers = 0;
  network.split = false;
  Expansion expansion(network);
  expansion.number_blocks(routing);
  for (const Tendon& tendon : routing.tendons) expansion.add(tendon);
  number_trees(network);
  for (const Segment& segment : network.segments) {
    network.fingers = std::max(network.fingers, segment.finger);
  }
  network.shared = shares_fingers(network);
}

bool is_tied(const Network& network, const TendonSpan& tendon) {
  if (network.blocks.empty()) return false;
  if (tendon.left.tie != EndTie::none || tendon.right.tie != EndTie::none) return true;
  const auto first = network.contacts.begin() + static_cast<std::ptrdiff_t>(tendon.first_contact);
  return std::any_of(first, first + static_cast<std::ptrdiff_t>(tendon.contacts),
                     [](const Contact& contact) { return contact.block != no_block; });
}

Network expand(const Routing& routing) {
  Network network;
  expand(routing, network);
  return network;
}

std::string block_name(const Block& block) {
  return fmt::format("{}{}", block.is_bar ? 'W' : 'Y', block.number);
}

std::string segment_name(const Segment& segment) {
  switch (segment.kind) {
    case SegmentKind::strand:
      return "T" + std::to_string(segment.number);
    case SegmentKind::motor_side:
      return letters_of(segment.number);
    case SegmentKind::hand:
      return "h" + std::to_string(segment.number);
  }
  return {};
}

const char* contact_kind_name(ContactKind kind) {
  switch (kind) {
    case ContactKind::tube:
      return "tube";
    case ContactKind::bearing:
      return "bearing";
    case ContactKind::sheath:
      return "sheath";
    case ContactKind::block:
      return "block";
    case ContactKind::bar:
      return "bar";
  }
  return "";
}

std::optional<std::size_t> find_segment(const Network& network, const Segment& wanted) {
  const auto found = std::find(network.segments.begin(), network.segments.end(), wanted);
  if (found == network.segments.end()) return std::nullopt;
  return static_cast<std::size_t>(found - network.segments.begin());
}

std::optional<std::size_t> find_motor_end(const Network& network, const Segment& wanted) {
  const auto at = find_segment(network, wanted);
  if (!at || wanted.kind != SegmentKind::motor_side) return std::nullopt;
  const bool ends =
      std::any_of(network.tendons.begin(), network.tendons.end(), [&](const TendonSpan& tendon) {
        return !tendon.closed &&
               (*at == tendon.first_segment || *at + 1 == tendon.first_segment + tendon.segments);
      });
  return ends ? at : std::nullopt;
}

std::optional<Segment> segment_named(std::string_view text) {
  const bool numbered = text.size() > 1 && text.size() < 6 && (text[0] == 'T' || text[0] == 'h') &&
                        text.find_first_not_of("0123456789", 1) == std::string_view::npos &&
                        text[1] != '0';
  if (numbered) {
    const int number = std::stoi(std::string(text.substr(1)));
    if (text[0] == 'T') return Segment{SegmentKind::strand, number, (number + 1) / 2};
    return Segment{SegmentKind::hand, number, 0};
  }
  const int number = number_from_letters(text);
  if (number == 0) return std::nullopt;
  return Segment{SegmentKind::motor_side, number, 0};
}

Segment parse_segment(const std::string& text) {
  if (const auto segment = segment_named(text)) return *segment;
  throw InputError(
      {.where = "hardware: contact",
       .what = "segment",
       .value = text,
       .expected = "a strand (T1), a motor-side segment (a) or a stretch at the hand (h1)"});
}

}  // namespace reeve::core
