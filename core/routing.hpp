// A routing: how one motor's tendons are led through the fingers of a hand.
//
// A routing is a set of tendons, and a tendon is the walk of tokens that a person follows along it
// with a finger: ends (M, F), fingers (1, 2, …) and joins at the hand (T, B) or on the carriage
// (P). Values only; notation.hpp reads and writes them, network.hpp expands them to segments and
// contacts.
#pragma once

#include <boost/container/small_vector.hpp>

#include <cstdint>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::core {

// The order of the enumerators is the canonical order of routings (canonical.hpp).
enum class TokenKind : std::uint8_t {
  motor_end,       // M: tied to the carriage, through a sheath
  fixed_end,       // F: fixed at the hand
  finger,          // 1, 2, …: in along one strand, round the fingertip, out along the other
  tube_join,       // T: two strands joined round a fixed tube
  bearing_join,    // B: … round a fixed pulley with a bearing
  movable_pulley,  // P: … round a pulley on the carriage, through a sheath on each side
};

enum class TipKind : std::uint8_t { tube, bearing };

struct Token {
  TokenKind kind = TokenKind::fixed_end;
  TipKind tip = TipKind::tube;  // fingers only
  std::uint8_t finger = 0;      // fingers only, from 1

  friend bool operator==(const Token&, const Token&) = default;
};

constexpr Token motor_end() { return {TokenKind::motor_end, TipKind::tube, 0}; }
constexpr Token fixed_end() { return {TokenKind::fixed_end, TipKind::tube, 0}; }
constexpr Token plain(TokenKind kind) { return {kind, TipKind::tube, 0}; }
constexpr Token finger(int number, TipKind tip = TipKind::tube) {
  return {TokenKind::finger, tip, static_cast<std::uint8_t>(number)};
}

constexpr bool is_end(TokenKind kind) {
  return kind == TokenKind::motor_end || kind == TokenKind::fixed_end;
}
constexpr bool is_join(TokenKind kind) { return !is_end(kind) && kind != TokenKind::finger; }
// The motor pulls a tendon only where it hangs on the carriage.
constexpr bool is_on_carriage(TokenKind kind) {
  return kind == TokenKind::motor_end || kind == TokenKind::movable_pulley;
}

// Up to ten fingers on one tendon need no memory from the heap.
using Walk = boost::container::small_vector<Token, 24>;

struct Tendon {
  Walk walk;
  bool closed = false;  // a loop: behind the last token comes the first again, always a finger

  friend bool operator==(const Tendon&, const Tendon&) = default;
};

// Fingers are numbered 1 … n without a gap, and each is passed once.
struct Routing {
  std::vector<Tendon> tendons;

  friend bool operator==(const Routing&, const Routing&) = default;
};

// A held set of fingers is a word of this many bits (grasp.hpp).
inline constexpr int max_fingers = 64;

int finger_count(const Routing& routing);
int finger_count(const Tendon& tendon);
bool is_actuated(const Tendon& tendon);
bool is_actuated(const Routing& routing);

}  // namespace reeve::core
