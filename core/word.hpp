// The word of a routing as text, with its tokens and their places, so that faults can be told by
// word, column (from 1) and token.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/routing.hpp"

namespace reeve::core {

struct PlacedText {
  std::string_view text;
  std::size_t column;
};

struct PlacedToken {
  Token token;
  PlacedText at;
};
using PlacedWalk = std::vector<PlacedToken>;

// Returns a text as it can be shown: short, and printable.
std::string shown_text(std::string_view text);
std::string quoted_text(std::string_view text);

struct Word {
  std::string_view text;

  // Throw InputError.
  [[noreturn]] void fail(InputFault fault) const;
  [[noreturn]] void fail(const PlacedText& at, InputFault fault) const;
};

}  // namespace reeve::core
