// The known name that a mistyped word most likely means. The distance is that of optimal string
// alignment: inserted, deleted and replaced characters count one each, and so do two neighbours
// that are exchanged. Assumes names of some ten ASCII letters; upper and lower case are alike.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::core {

std::size_t edit_distance(std::string_view a, std::string_view b);

// Returns the known name with the least distance, the first of two; a name that begins with the
// word has distance 0 if the word has two letters or more. Returns nothing if more than a third
// of the word would have to change, or if more than two names are equally near: TR9 may be any of
// seven.
std::optional<std::string> nearest_name(std::string_view word,
                                        const std::vector<std::string>& known);

// "; did you mean NAME?", or nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace reeve::core
