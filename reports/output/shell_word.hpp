// Text as one word of a POSIX shell's command line: what pages print can be pasted.
#pragma once

#include <string>

#include "numerics/floors.hpp"

namespace reeve::reports {

std::string shell_word(const std::string& text);

}  // namespace reeve::reports
