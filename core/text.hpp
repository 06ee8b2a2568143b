// Small parts of what users write: items of a list, and words without the blanks round them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::core {

// Between commas; an empty text is one empty item.
std::vector<std::string> comma_separated(std::string_view text);

// Without blanks and tabs at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace reeve::core
