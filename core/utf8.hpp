// Whether bytes are text in UTF-8 (RFC 3629): no overlong forms, no surrogates, none beyond
// U+10FFFF. Whatever is written as it was read, into tables and pages, must be.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "numerics/floors.hpp"

namespace reeve::core {

// The place of the first byte at which no character begins; nothing if all is well.
std::optional<std::size_t> first_not_utf8(std::string_view text);

}  // namespace reeve::core
