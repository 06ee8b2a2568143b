#include "numerics/random.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>

namespace reeve {

double uniform(std::uint64_t seed, std::uint32_t stream, std::uint64_t index) {
  using Generator = r123::Philox4x32;
  constexpr auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const Generator::ctr_type counter{{low(index), low(index >> 32), stream, 0}};
  const Generator::key_type key{{low(seed), low(seed >> 32)}};
  const Generator::ctr_type random = Generator{}(counter, key);
  const std::uint64_t bits = (std::uint64_t{random[0]} << 32 | random[1]) >> 11;
  return static_cast<double>(bits) * 0x1p-53;
}

double normal(std::uint64_t seed, std::uint32_t stream, std::uint64_t index) {
  const double radius = std::sqrt(-2 * std::log1p(-uniform(seed, stream, 2 * index)));
  return radius * std::cos(2 * std::numbers::pi * uniform(seed, stream, 2 * index + 1));
}

}  // namespace reeve
