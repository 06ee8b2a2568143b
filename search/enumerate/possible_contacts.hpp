// Which contacts that the hardware names there can be in routings of these parts.
#pragma once

#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "search/enumerate/tendon_generator.hpp"

namespace reeve::search {

// As the user wrote them: those that none of the routings has. Of a large enumeration the first are
// looked at; what they lack counts as possible, unless its segments cannot touch in any routing.
std::vector<std::string> impossible_contacts(const Hardware& hardware,
                                             const GeneratorOptions& options);

}  // namespace reeve::search
