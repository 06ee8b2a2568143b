// Whether a text has a piece; a test that expects otherwise shows both.
#pragma once

#include <gtest/gtest.h>

#include <string_view>

namespace reeve::testing {

inline ::testing::AssertionResult has(std::string_view text, std::string_view piece) {
  constexpr std::size_t shown = 4000;
  const bool found = text.find(piece) != std::string_view::npos;
  return (found ? ::testing::AssertionSuccess() : ::testing::AssertionFailure())
         << "'" << piece << "' is " << (found ? "" : "not ") << "in: " << text.substr(0, shown);
}

}  // namespace reeve::testing
