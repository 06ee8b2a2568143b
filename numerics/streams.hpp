// Every stream of random numbers that reeve draws from (random.hpp), so that no two uses of one
// seed share their numbers by accident.
#pragma once

#include <cstddef>
#include <cstdint>

#include "numerics/floors.hpp"

namespace reeve::numerics::streams {

// Replicates of the noise draw from the streams 0, 1, …, one for each of them; what else one seed
// serves beside a diagnosis lies far above. Designs are sampled with a seed of their own.
inline constexpr std::uint32_t design_sample = 0;
inline constexpr std::uint32_t shown_readings = 0x3a9;
inline constexpr std::uint32_t hold_out = 0x401d;
inline constexpr std::uint32_t resampling = 0x6a1;
// These streams lie apart because a user may diagnose simulated readings with the seed that made
// them.
inline constexpr std::uint32_t relative_noise = 0x51a00000;
inline constexpr std::uint32_t absolute_noise = 0x51a00001;
inline constexpr std::uint32_t motor_noise = 0x51a00002;
// Streams of a planned experiment, two for each factor: the order, and the places within parts of a
// range.
inline constexpr std::uint32_t grasps = 0x51a00010;
inline constexpr std::uint32_t motor_tensions = 0x51a00012;
inline constexpr std::uint32_t speeds = 0x51a00014;
inline constexpr std::uint32_t temperatures = 0x51a00016;
inline constexpr std::uint32_t sheath_angles = 0x51a00018;
inline constexpr std::uint32_t columns = 0x51a00020;  // and so on
// Starts of searches for dimensions: one stream for each variable.
inline constexpr std::uint32_t sizing_starts = 0x51ce0000;
// Starts of searches for the worst of several tolerances: one stream for each variable.
inline constexpr std::uint32_t tolerance_corners = 0x51cf0000;

// The streams of drawn hardware are one for each contact of a network.
inline constexpr std::uint32_t contact_scatter = 0x51d00000;

// Seeds for the replicates of each step of a search, and for those of what it leaves. Prime steps:
// seeds that users try, 1, 2, 3, …, meet none of another's.
inline std::uint64_t seed_of_step(std::uint64_t seed, std::size_t step) {
  return seed + 7919 * step;
}
inline std::uint64_t seed_of_motor_tensions(std::uint64_t seed) { return seed + 1299709; }
inline std::uint64_t seed_of_residual_structure(std::uint64_t seed) { return seed + 104729; }

}  // namespace reeve::numerics::streams
