#include "numerics/random.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reeve::numerics {
namespace {

using Generator = r123::Philox4x32;

// Each distribution has counters of its own.
enum class Use : std::uint32_t { uniform = 0, normal = 1 };

[[gnu::always_inline]] inline Generator::ctr_type draw(std::uint64_t seed, std::uint32_t stream,
                                                       std::uint64_t index, Use use) {
  constexpr auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const Generator::ctr_type counter{
      {low(index), low(index >> 32), stream, static_cast<std::uint32_t>(use)}};
  const Generator::key_type key{{low(seed), low(seed >> 32)}};
  return Generator{}(counter, key);
}

// The first 53 bits of two words.
double bits(std::uint32_t first, std::uint32_t second) {
  return static_cast<double>((std::uint64_t{first} << 32 | second) >> 11);
}

}  // namespace

double uniform(std::uint64_t seed, std::uint32_t stream, std::uint64_t index) {
  const Generator::ctr_type random = draw(seed, stream, index, Use::uniform);
  return bits(random[0], random[1]) * 0x1p-53;
}

std::vector<std::uint64_t> uniform_below(double bound, std::uint64_t seed, std::uint32_t stream,
                                         std::uint64_t begin, std::uint64_t end) {
  std::vector<std::uint64_t> indices;
  // The first word decides almost always.
  const auto most = static_cast<std::uint32_t>(std::min(bound * 0x1p32, 0x1p32 - 1));
  for (std::uint64_t index = begin; index < end; ++index) {
    if (draw(seed, stream, index, Use::uniform)[0] > most) continue;
    if (uniform(seed, stream, index) < bound) indices.push_back(index);
  }
  return indices;
}

double normal(std::uint64_t seed, std::uint32_t stream, std::uint64_t index) {
  const Generator::ctr_type random = draw(seed, stream, index, Use::normal);
  const double above_zero = (bits(random[0], random[1]) + 0.5) * 0x1p-53;
  const double turn = bits(random[2], random[3]) * 0x1p-53;
  return std::sqrt(-2 * std::log(above_zero)) * std::cos(2 * std::numbers::pi * turn);
}

}  // namespace reeve::numerics
