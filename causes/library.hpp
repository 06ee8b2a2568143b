// All causes that reeve knows.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "causes/cause.hpp"

namespace reeve::causes {

// In the order in which their laws act on an exponent.
std::span<const Cause* const> cause_library();

// nullptr if there is none.
const Cause* find_cause(const std::string& name);

std::vector<std::string> cause_list();
// "tube_friction, sheath_friction, …", for messages.
std::string cause_names();

}  // namespace reeve::causes
