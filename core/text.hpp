// Small parts of what users write: items of a list, words without the blanks round them, and
// numbers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::core {

// Checks that bytes are text in UTF-8 (RFC 3629): no overlong forms, no surrogates, none beyond
// U+10FFFF. Text that is written as it was read, into tables and pages, must be.
// Returns the place of the first byte at which no character begins; nothing if all is well.
std::optional<std::size_t> first_not_utf8(std::string_view text);

// Between commas; an empty text is one empty item.
std::vector<std::string> comma_separated(std::string_view text);

// Without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

// Returns the text in small letters; bytes beyond ASCII stay.
std::string lower(std::string_view text);

// The number that the whole text is, as C writes it: "12.5", "-1e-3". Nothing where anything else
// stands beside it, a blank or a plus among them, and of what is not finite.
std::optional<double> number_in(std::string_view text);
std::optional<int> whole_number_in(std::string_view text);

// Returns a number with this many decimals; "-" if it is not finite.
std::string fixed(double value, int decimals = 3);

}  // namespace reeve::core
