// How faults of a word are told: the word, the column (from 1), the token, what was expected.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/routing.hpp"

namespace reeve::core {

struct PlacedToken {
  Token token;
  std::string_view text;
  std::size_t column;
};
using PlacedWalk = std::vector<PlacedToken>;

// As it can be shown: short, and printable.
std::string shown_text(std::string_view text);
std::string quoted_text(std::string_view text);

// Throw InputError.
[[noreturn]] void fail_word(std::string_view word, InputFault fault);
[[noreturn]] void fail_word(std::string_view word, std::size_t column, InputFault fault);

}  // namespace reeve::core
