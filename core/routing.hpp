// A routing: how the tendons of one or several motors are led through the fingers of a hand.
//
// A routing is a set of tendons, and a tendon is the walk of tokens that a person follows along it
// with a finger: ends (M, F, 1x, 1e), fingers (1, 2, …) and joins at the hand (T, B) or on the
// carriage (P). M2 and P2 are those of a second motor, and so on. Floating blocks (Y1, Y2, …) and
// bars (W1, …) hang on some tendons and are pulled by others: they tie tendons together. Values
// only; notation.hpp reads and writes them, network.hpp expands them to segments and contacts.
#pragma once

#include <boost/container/small_vector.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::core {

// The order of the enumerators is the canonical order of routings (canonical.hpp).
enum class TokenKind : std::uint8_t {
  motor_end,       // M: tied to the carriage, through a sheath
  fixed_end,       // F: fixed at the hand
  anchored_tip,    // 1x, 1e: tied at that fingertip, in front or on the back; one strand
  block_tail,      // Y1 as an end: pulls the block away from the strands that pass it
  becket,          // Y1k: tied to the block on the side of its sheaves
  bar_pivot,       // W1 as an end: pulls a rigid bar at its pivot
  finger,          // 1, 2, …: in along one strand, round the fingertip, out along the other
  block_pass,      // Y1 inside a walk: round a sheave of the floating block
  bar_arms,        // W1 inside a walk: both neighbours are tied to the arms of a rigid bar
  tube_join,       // T: two strands joined round a fixed tube
  bearing_join,    // B: … round a fixed pulley with a bearing
  movable_pulley,  // P: … round a pulley on the carriage, through a sheath on each side
};

// The back is that of an anchored tip whose tendon extends the finger (1e).
enum class TipKind : std::uint8_t { tube, bearing, back };

// The tensions of a bar's left and right neighbour stand in this ratio, in lowest terms.
struct ArmRatio {
  std::uint16_t left = 1;
  std::uint16_t right = 1;

  friend auto operator<=>(const ArmRatio&, const ArmRatio&) = default;
};

// The wrap angle that a word gives a contact, in thousandths of a degree; 0 if it gives none.
struct WrapAngle {
  std::uint32_t millidegrees = 0;

  constexpr bool is_given() const { return millidegrees != 0; }
  constexpr double degrees() const { return millidegrees / 1000.0; }
  constexpr double radians() const { return degrees() * std::numbers::pi / 180; }
  friend auto operator<=>(const WrapAngle&, const WrapAngle&) = default;
};

struct Token {
  TokenKind kind = TokenKind::fixed_end;
  TipKind tip = TipKind::tube;  // fingers and anchored tips only
  std::uint8_t finger = 0;      // fingers and anchored tips only, from 1
  std::uint8_t block = 0;       // blocks and bars only, from 1
  ArmRatio arms = {};           // bar_arms only
  std::uint8_t carriage = 1;    // motor's number, from 1; of tokens on a carriage only
  WrapAngle angle = {};         // has_angle only

  friend bool operator==(const Token&, const Token&) = default;
};

constexpr Token plain(TokenKind kind) { return {kind}; }
// motor_end or movable_pulley on the carriage of the motor with this number.
constexpr Token on_carriage(TokenKind kind, int number) {
  return {kind, TipKind::tube, 0, 0, {}, static_cast<std::uint8_t>(number)};
}
constexpr Token motor_end() { return plain(TokenKind::motor_end); }
constexpr Token fixed_end() { return plain(TokenKind::fixed_end); }
constexpr Token finger(int number, TipKind tip = TipKind::tube) {
  return {TokenKind::finger, tip, static_cast<std::uint8_t>(number)};
}
constexpr Token anchored_tip(int finger, TipKind tip = TipKind::tube) {
  return {TokenKind::anchored_tip, tip, static_cast<std::uint8_t>(finger)};
}
// block_pass, block_tail or becket of the block with this number.
constexpr Token block(TokenKind kind, int number) {
  return {kind, TipKind::tube, 0, static_cast<std::uint8_t>(number)};
}
constexpr Token bar(int number, ArmRatio arms = {}) {
  return {TokenKind::bar_arms, TipKind::tube, 0, static_cast<std::uint8_t>(number), arms};
}

constexpr bool is_end(TokenKind kind) { return kind < TokenKind::finger; }
constexpr bool is_join(TokenKind kind) { return kind > TokenKind::finger; }
// Has strands of its own.
constexpr bool is_of_finger(TokenKind kind) {
  return kind == TokenKind::finger || kind == TokenKind::anchored_tip;
}
constexpr bool is_of_bar(TokenKind kind) {
  return kind == TokenKind::bar_pivot || kind == TokenKind::bar_arms;
}
// … or of a bar, which is in most things a block.
constexpr bool is_of_block(TokenKind kind) {
  return is_of_bar(kind) || kind == TokenKind::block_tail || kind == TokenKind::becket ||
         kind == TokenKind::block_pass;
}
constexpr bool is_tail(TokenKind kind) {
  return kind == TokenKind::block_tail || kind == TokenKind::bar_pivot;
}
// The word may give the wrap angle: of a P that of its pulley, whose sheaths keep the hardware's.
constexpr bool has_angle(TokenKind kind) { return !is_end(kind) && kind != TokenKind::bar_arms; }
// The motor pulls a tendon where it hangs on the carriage.
constexpr bool is_on_carriage(TokenKind kind) {
  return kind == TokenKind::motor_end || kind == TokenKind::movable_pulley;
}

// The same token met from the other end of the walk.
constexpr Token reversed(Token token) {
  token.arms = {token.arms.right, token.arms.left};
  return token;
}

// Up to ten fingers on one tendon need no memory from the heap.
using Walk = boost::container::small_vector<Token, 24>;

struct Tendon {
  Walk walk;
  bool closed = false;  // a loop: behind the last token comes the first again, always a finger

  friend bool operator==(const Tendon&, const Tendon&) = default;
};

// Fingers are numbered 1 … n without a gap, and each is passed once, or anchors one or two ends of
// tendons. Blocks have any numbers, and so have bars: Y1 and W1 are two things. Each has a tail and
// a pass, a becket or arms, and none hangs on itself: from a block to the blocks that its tails'
// tendons pass, and so on, there is no way back.
struct Routing {
  std::vector<Tendon> tendons;

  friend bool operator==(const Routing&, const Routing&) = default;
};

// A held set of fingers is a word of this many bits (grasp.hpp).
inline constexpr int max_fingers = 64;
// Blocks, and bars likewise: eight times those of the largest hands and tackles in print.
inline constexpr int max_blocks = 32;

// One number for each block and bar: the index from 0 in arrays of this size.
inline constexpr std::size_t block_keys = 2 * max_blocks;
constexpr std::size_t block_key(const Token& token) {
  return (is_of_bar(token.kind) ? max_blocks : 0) + token.block - std::size_t{1};
}

// Motors: the largest hands in print have a motor for each finger and one for the thumb's side.
inline constexpr int max_carriages = 6;

int finger_count(const Routing& routing);
int finger_count(const Tendon& tendon);
// Fingers that anchor a second end, in the order of those ends. A token without a number is of a
// finger of its own.
std::vector<std::uint8_t> second_tendons(const Routing& routing);
// Most of them: their numbers are tried in all orders (canonical.hpp).
inline constexpr int most_second_tendons = 5;
// Blocks and bars.
struct BlockCount {
  int blocks = 0;
  int bars = 0;

  // The number of the token's kind.
  int& of(const Token& token) { return is_of_bar(token.kind) ? bars : blocks; }
  int of(const Token& token) const { return is_of_bar(token.kind) ? bars : blocks; }
};
BlockCount block_count(const Routing& routing);

// Tendons that blocks tie together: for each tendon, the number of its tree, from 0 in the order of
// the first tendons.
std::vector<std::size_t> trees(const Routing& routing);

// Number of motors. Their carriages are numbered 1 … n without a gap.
int carriage_count(const Routing& routing);

bool is_actuated(const Tendon& tendon);
// Every tree hangs on a motor.
bool is_actuated(const Routing& routing);

}  // namespace reeve::core
