// Text in columns of a screen, for the UTF-8 that we print: every code point is one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::reports {

std::size_t text_width(const std::string& text);

// With spaces up to the width: behind a text, before a number.
std::string padded(const std::string& text, std::size_t width, bool is_text);

// The words between the spaces.
std::vector<std::string> words_of(const std::string& text);

// Lines of at most that width, broken at spaces. A word that is longer than a line is broken behind
// '-', '+' or '_', as routings and names can be read, or else anywhere. Width 0 breaks nothing.
std::vector<std::string> wrap_words(const std::string& text, std::size_t width);

}  // namespace reeve::reports
