// Planted data that cannot tell two causes apart, whatever the number of readings, and the same
// data with further runs that can.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/planting.hpp"

namespace reeve::testing {

enum class AliasKind : std::uint8_t {
  // One speed other than 10 mm/s and one temperature other than 20 degC: both multiply every
  // exponent by one constant.
  speed_or_temperature,
  // One cycle other than 0 and one temperature other than 20 degC: the same.
  temperature_or_wear,
  // Sheaths of finger 1 only: mu and theta act as a product.
  sheath_friction_or_angle,
  // A channel that is read in one grasp at one motor tension only.
  gain_or_offset,
  // One tube, pull only, read behind it: T2 = T1 e^{-phi} is a gain of T2.
  tube_friction_or_gain,
};
const char* alias_name(AliasKind kind);
const std::vector<AliasKind>& alias_kinds();

struct PlantedAlias {
  std::array<std::string, 2> names;  // the first one is the truth
  Planted aliased;
  Planted separated;
};

// Which of the two is true depends on the seed.
PlantedAlias plant_alias(AliasKind kind, const NoiseLevel& noise, std::uint64_t seed);

}  // namespace reeve::testing
