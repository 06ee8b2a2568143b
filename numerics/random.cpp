#include "numerics/random.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>

namespace reeve::numerics {
namespace {

using Generator = r123::Philox4x32;

// Each distribution has counters of its own.
enum class Use : std::uint32_t { uniform = 0, normal = 1 };

Generator::ctr_type draw(std::uint64_t seed, std::uint32_t stream, std::uint64_t index, Use use) {
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

double normal(std::uint64_t seed, std::uint32_t stream, std::uint64_t index) {
  const Generator::ctr_type random = draw(seed, stream, index, Use::normal);
  const double above_zero = (bits(random[0], random[1]) + 0.5) * 0x1p-53;
  const double turn = bits(random[2], random[3]) * 0x1p-53;
  return std::sqrt(-2 * std::log(above_zero)) * std::cos(2 * std::numbers::pi * turn);
}

}  // namespace reeve::numerics
