#include "reports/output/number_texts.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>

namespace reeve::reports {
namespace {

constexpr int place_bits = 11;

// Knuth's multiplicative hash (TAOCP 3, section 6.4).
std::size_t place_of(std::uint64_t bits) { return bits * 0x9E3779B97F4A7C15U >> (64 - place_bits); }

}  // namespace

std::size_t print_json_number(double value, char* to) {
  if (!std::isfinite(value)) return static_cast<std::size_t>(fmt::format_to(to, "null") - to);
  // What the library's own printing calls: its digits are not always the fewest, as fmt's are.
  return static_cast<std::size_t>(nlohmann::detail::to_chars(to, to + longest_number, value) - to);
}

std::size_t print_csv_number(double value, char* to) {
  if (!std::isfinite(value)) return 0;
  return static_cast<std::size_t>(fmt::format_to(to, "{}", value) - to);
}

NumberTexts::NumberTexts(PrintNumber print)
    : print_(print), places_(std::size_t{1} << place_bits) {}

std::string_view NumberTexts::text(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  Place& place = places_[place_of(bits)];
  if (place.size == 0 || place.bits != bits) {
    place.bits = bits;
    place.size = static_cast<std::uint8_t>(print_(value, place.text.data()));
  }
  return {place.text.data(), place.size};
}

}  // namespace reeve::reports
