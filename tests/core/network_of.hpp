// The network of a routing word.
#pragma once

#include <string>

#include "core/notation.hpp"

namespace reeve::testing {

inline Network network_of(const std::string& word) { return expand(parse_routing(word)); }

}  // namespace reeve::testing
