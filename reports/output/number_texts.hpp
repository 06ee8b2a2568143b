// Numbers as text, for long lists in which the same ones come again and again: what was printed
// lately is not printed anew.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::reports {

inline constexpr std::size_t longest_number = 31;

// Returns how many characters it has written, at most that many.
using PrintNumber = std::size_t (*)(double value, char* to);

// As print() (json.hpp) writes a number; null where it is none.
std::size_t print_json_number(double value, char* to);
// csv_number (csv_field.hpp).
std::size_t print_csv_number(double value, char* to);

class NumberTexts {
 public:
  explicit NumberTexts(PrintNumber print);

  // Valid until the next call.
  std::string_view text(double value);

 private:
  struct Place {
    std::uint64_t bits = 0;
    std::uint8_t size = 0;  // 0: it is empty
    std::array<char, longest_number> text{};
  };

  PrintNumber print_;
  std::vector<Place> places_;  // by a hash of the bits
};

}  // namespace reeve::reports
