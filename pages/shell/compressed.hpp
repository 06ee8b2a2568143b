// Text that a page carries compressed, for its script to unpack (DecompressionStream "deflate").
#pragma once

#include <string>

#include "numerics/floors.hpp"

namespace reeve::pages {

// RFC 1950, in base 64. The same text gives the same bytes. Throws std::bad_alloc.
std::string compressed(const std::string& text);

}  // namespace reeve::pages
