// The network of a routing: segments of tendon, joined by contacts.
//
// Walking along a tendon, every token gives contacts and every gap between two tokens gives one
// segment at the hand:
//   finger  tip contact (tube or bearing) between its strands T(2f-1), by which the walk enters,
//           and T(2f), by which it leaves
//   T, B    tube or bearing contact between the neighbouring segments
//   M       a motor-side segment, behind a sheath contact
//   P       sheath – motor-side segment – bearing contact – motor-side segment – sheath
//   F       nothing: the neighbouring segment just ends
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
  int number = 0;  // strands: 2f-1 or 2f; otherwise counted from 1 within the kind
  int finger = 0;  // strands only

  // The finger follows from these.
  friend bool operator==(const Segment& a, const Segment& b) {
    return a.kind == b.kind && a.number == b.number;
  }
};

enum class ContactKind : std::uint8_t { tube, bearing, sheath };

enum class ContactPlace : std::uint8_t { tip, hand_join, carriage, sheath };

struct Contact {
  ContactKind kind = ContactKind::tube;
  ContactPlace place = ContactPlace::tip;
  int finger = 0;  // of a tip, or of the strand that a sheath leads to; otherwise 0
};

// The part of the arrays that belongs to one tendon.
struct TendonSpan {
  std::size_t first_segment = 0;
  std::size_t segments = 0;
  std::size_t first_contact = 0;
  std::size_t contacts = 0;
  bool closed = false;
};

struct ContactEnds {
  std::size_t left = 0;
  std::size_t right = 0;
};

struct Network {
  std::vector<Segment> segments;
  std::vector<Contact> contacts;
  std::vector<TendonSpan> tendons;
  int fingers = 0;
  bool split = false;  // a finger's strands may lie on two tendons (seizure.hpp)
};

// Rebuilds `network` for another routing; keeps its memory.
void expand(const Routing& routing, Network& network);
Network expand(const Routing& routing);

// The segments on both sides of a tendon's k-th contact.
inline ContactEnds ends_of(const TendonSpan& tendon, std::size_t k) {
  const std::size_t next = k + 1 == tendon.segments ? 0 : k + 1;
  return {tendon.first_segment + k, tendon.first_segment + next};
}

// The place of a segment among the network's, if it has it.
std::optional<std::size_t> find_segment(const Network& network, const Segment& wanted);

// T1, a, h1.
std::string segment_name(const Segment& segment);
// The reverse; nothing of what is no such name.
std::optional<Segment> segment_named(std::string_view name);
// Of a contact of the hardware. Throws InputError on what is no such name.
Segment parse_segment(const std::string& name);
const char* contact_kind_name(ContactKind kind);

}  // namespace reeve::core
