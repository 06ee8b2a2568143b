// Text as one word of a POSIX shell's command line: what pages print can be pasted.
#pragma once

#include <string>

namespace reeve {

std::string shell_word(const std::string& text);

}  // namespace reeve
