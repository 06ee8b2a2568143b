// Progress as one line of text.
#pragma once

#include <cstddef>
#include <string>

#include "search/explore.hpp"

namespace reeve::cli {

// "exploring [====>       ]  38 %, 81234 a second, 4 s left" in at most so many columns; where
// there is no room for a bar, without one.
std::string progress_bar(const std::string& what, const Progress& progress, double seconds,
                         std::size_t width);

}  // namespace reeve::cli
