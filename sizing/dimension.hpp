// The numbers of a hardware that a designer is free to choose, each by a name:
//
//   sheath_angle[1]         sum of the bends of each sheath that leads to finger 1, rad
//   tip_angle[1]            wrap at its fingertip, rad
//   strand_mm[1]            length of each of its strands, mm
//   closing[1]              its share of the tendon when fingers close, relative to the others
//   arm_mm[1]               moment arm at its first joint; those of its others keep their ratio, mm
//   contact_angle[T2-T3]    wrap at the contact between two segments, rad
//   motor_side_mm, hand_mm  lengths of the other segments, mm
//
// Friction coefficients are none of them: they come with the material, and are what is uncertain.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/network.hpp"
#include "numerics/minimise.hpp"

namespace reeve::sizing {

enum class SizedQuantity : std::uint8_t {
  sheath_angle,
  tip_angle,
  strand_mm,
  closing,
  arm_mm,
  contact_angle,
  motor_side_mm,
  hand_mm,
};

enum class QuantityOf : std::uint8_t { finger, contact, hand };

struct QuantityRow {
  SizedQuantity quantity;
  const char* name;
  const char* plural;  // "sheaths", to speak of all of them; "" if nobody does
  const char* unit;
  QuantityOf of;
  Interval possible;  // that a hardware can have
};

std::span<const QuantityRow> quantity_table();
const QuantityRow& row(SizedQuantity quantity);

struct SizedDimension {
  SizedQuantity quantity{};
  int finger = 0;        // of a finger's
  Segment from{}, to{};  // of a contact's, in either order

  friend bool operator==(const SizedDimension& a, const SizedDimension& b);
};

// Whether it is that of the contact between these two, in either order.
bool is_between(const SizedDimension& dimension, const Segment& left, const Segment& right);

// "sheath_angle[1]", "contact_angle[T2-T3]", "hand_mm"
std::string to_text(const SizedDimension& dimension);

// Some dimensions of one quantity, or without any named all of it that a routing has.
struct DimensionName {
  SizedQuantity quantity{};
  std::vector<SizedDimension> named;

  bool has(const SizedDimension& dimension) const;
};

std::string to_text(const DimensionName& name);

// "sheath_angle", "sheath_angle[1]", "sheath_angle[2,3,4]", "contact_angle[T2-T3]". Throws
// InputError.
DimensionName parse_dimensions(const std::string& text);

// Which dimensions may be chosen, in what bounds, and which of them must stay equal, as the user
// says it.
struct VariedRange {
  DimensionName name;
  Interval bounds;
  std::string text;  // as it was given, for messages: "vary 'hand_mm=50..90'", "h.toml:3:1"
};

// "sheath_angle[1]=3..9". Throws InputError.
VariedRange parse_varied(const std::string& text);
// Of a name and bounds that stand apart; `text` as above.
VariedRange varied_range(const std::string& name, const Interval& bounds, const std::string& text);

// Dimensions that are to be equal, so that the fingers' parts are alike.
struct SameGroup {
  DimensionName name;
  std::string text;
};

// "tips", "sheaths,tips", "sheath_angle[2,3,4]": what each item names is equal. Throws InputError.
std::vector<SameGroup> parse_same(const std::string& text);

}  // namespace reeve::sizing
