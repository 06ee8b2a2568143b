// Counter-based random numbers (Philox4x32-10, J. K. Salmon et al., SC 2011): a number is a
// function of seed, stream and index, whichever thread asks for it and in whatever order.
#pragma once

#include <cstdint>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::numerics {

// Uniform in [0, 1), with 53 random bits.
double uniform(std::uint64_t seed, std::uint32_t stream, std::uint64_t index);

// The indices from `begin` on, before `end`, whose uniform number is below this bound.
std::vector<std::uint64_t> uniform_below(double bound, std::uint64_t seed, std::uint32_t stream,
                                         std::uint64_t begin, std::uint64_t end);

// Standard normal (Box and Muller), never beyond 8.7. Independent of the uniform number with the
// same arguments.
double normal(std::uint64_t seed, std::uint32_t stream, std::uint64_t index);

}  // namespace reeve::numerics
