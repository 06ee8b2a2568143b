// The network of a routing: segments of tendon, joined by contacts.
//
// Walking along a tendon, every token gives contacts and every gap between two tokens gives one
// segment at the hand:
//   finger  tip contact (tube or bearing) between its strands T(2f-1), by which the walk enters,
//           and T(2f), by which it leaves
//   T, B    tube or bearing contact between the neighbouring segments
//   M       a motor-side segment, behind a sheath contact; M2 on another motor's carriage
//   P       sheath – motor-side segment – bearing contact – motor-side segment – sheath
//   F, 1x   nothing: the neighbouring segment just ends; a second 1x and 1e have the strand T(2f)
//   Y1      inside a walk: a contact on the block, between the neighbouring segments
//   W1      inside a walk: likewise the bar between its arms, a contact of a given tension ratio
//   Y1, Y1k, W1 as an end: the neighbouring segment is tied to the block
// Motor-side segments are named a, b, c, …, and segments at the hand that are no strand h1, h2, …,
// both in walk order over the whole routing.
//
// Flat arrays in walk order: along a tendon, contact k lies between segments k and k + 1, and a
// loop's last contact leads back to its first segment. graph.hpp gives the same network as a
// Boost.Graph.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/routing.hpp"

namespace reeve::core {

enum class SegmentKind : std::uint8_t { strand, motor_side, hand };

struct Segment {
  SegmentKind kind = SegmentKind::strand;
  int number = 0;    // strands: 2f-1 or 2f; otherwise counted from 1 within the kind
  int finger = 0;    // strands only
  int carriage = 1;  // motor sides only: the motor's number
  bool extensor = false;

  // Length that the strand gives up per dl of its finger.
  double way() const { return extensor ? -1 : 1; }

  // The rest follows from these.
  friend bool operator==(const Segment& a, const Segment& b) {
    return a.kind == b.kind && a.number == b.number;
  }
  friend auto operator<=>(const Segment& a, const Segment& b) {
    return a.kind == b.kind ? a.number <=> b.number : a.kind <=> b.kind;
  }
};

// A block's sheave turns on a bearing of its own law; a bar has no friction.
enum class ContactKind : std::uint8_t { tube, bearing, sheath, block, bar };
inline constexpr std::size_t contact_kinds = 5;

enum class ContactPlace : std::uint8_t { tip, hand_join, carriage, sheath, block };

inline constexpr std::size_t no_block = static_cast<std::size_t>(-1);

struct Contact {
  ContactKind kind = ContactKind::tube;
  ContactPlace place = ContactPlace::tip;
  int finger = 0;                // finger of a tip, or of the strand at a sheath; otherwise 0
  std::size_t block = no_block;  // in Network::blocks, at place `block`
  WrapAngle angle = {};          // angle in the word
};

// A floating block or a bar.
struct Block {
  bool is_bar = false;
  int number = 0;
  ArmRatio arms;  // bars only: tension on the left over tension on the right
};

// Tie of an end of an open tendon.
enum class EndTie : std::uint8_t {
  none,    // no block
  tail,    // pulls the block one way
  becket,  // … the other way, as the passes do
};

struct TendonEnd {
  EndTie tie = EndTie::none;
  std::size_t block = no_block;
};

// The part of the arrays that belongs to one tendon.
struct TendonSpan {
  std::size_t first_segment = 0;
  std::size_t segments = 0;
  std::size_t first_contact = 0;
  std::size_t contacts = 0;
  bool closed = false;
  TendonEnd left{};      // at its first segment
  TendonEnd right{};     // at its last one
  std::size_t tree = 0;  // tendons that blocks tie together share one: that of the first of them
};

struct ContactEnds {
  std::size_t left = 0;
  std::size_t right = 0;
};

struct Network {
  std::vector<Segment> segments;
  std::vector<Contact> contacts;
  std::vector<TendonSpan> tendons;
  std::vector<Block> blocks;  // sorted by number, then the bars
  int fingers = 0;
  bool split = false;  // a finger's strands may lie on two tendons (seizure.hpp)
  // A finger has an extensor, or strands of two trees (shared_kinematics.hpp).
  bool shared = false;
};

// Rebuilds `network` for another routing; keeps its memory.
void expand(const Routing& routing, Network& network);
Network expand(const Routing& routing);

// Numbers the trees from the tendons' ends and contacts.
void number_trees(Network& network);

// True if blocks tie the tendon to others, or to itself.
bool is_tied(const Network& network, const TendonSpan& tendon);

// The segments on both sides of a tendon's k-th contact.
inline ContactEnds ends_of(const TendonSpan& tendon, std::size_t k) {
  const std::size_t next = k + 1 == tendon.segments ? 0 : k + 1;
  return {tendon.first_segment + k, tendon.first_segment + next};
}

// The place of a segment among the network's, if it has it.
std::optional<std::size_t> find_segment(const Network& network, const Segment& wanted);
// The same of a motor-side segment that ends at a motor's carriage, not at a pulley on it.
std::optional<std::size_t> find_motor_end(const Network& network, const Segment& wanted);

// Y1, W1.
std::string block_name(const Block& block);
// T1, a, h1.
std::string segment_name(const Segment& segment);
// The reverse; nothing of what is no such name.
std::optional<Segment> segment_named(std::string_view name);
// Returns the segment that a contact of the hardware names. Throws InputError on any other name.
Segment parse_segment(const std::string& name);
const char* contact_kind_name(ContactKind kind);

}  // namespace reeve::core
