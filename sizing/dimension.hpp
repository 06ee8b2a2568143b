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

#include "core/contact_name.hpp"
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
  const char* plural;  // "sheaths" as a name for all of them; "" if there is none
  const char* unit;
  QuantityOf of;
  Interval possible;  // values that a hardware can have
};

std::span<const QuantityRow> quantity_table();
const QuantityRow& row(SizedQuantity quantity);

struct SizedDimension {
  SizedQuantity quantity{};
  int finger = 0;        // number of the finger, for a finger's dimension
  Segment from{}, to{};  // ends of the contact, as in its name

  ContactName contact() const { return {from, to}; }

  friend bool operator==(const SizedDimension& a, const SizedDimension& b);
};

// True if the two are one dimension in every routing that has it.
bool mean_the_same(const SizedDimension& a, const SizedDimension& b);

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

// Dimensions that may vary, and their bounds, as the user gives them.
struct VariedRange {
  DimensionName name;
  Interval bounds;
  std::string text;  // text as given, for messages: "vary 'hand_mm=50..90'", "h.toml:3:1"
};

// "sheath_angle[1]=3..9". Throws InputError.
VariedRange parse_varied(const std::string& text);
// Makes a range from a separate name and bounds; `text` as above.
VariedRange varied_range(const std::string& name, const Interval& bounds, const std::string& text);

// Dimensions that are to be equal, so that the fingers' parts are alike.
struct EqualGroup {
  DimensionName name;
  std::string text;
};

// "tips", "sheaths,tips", "sheath_angle[2,3,4]": what each item names is equal. Throws InputError.
std::vector<EqualGroup> parse_equal(const std::string& text);

}  // namespace reeve::sizing
