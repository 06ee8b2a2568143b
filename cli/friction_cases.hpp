// What --mu of `rank` asks for.
#pragma once

#include <string>
#include <vector>

#include "studies/tension_distributions.hpp"

namespace reeve::cli {

// "0.18,0.09,model": coefficients of tubes and sheaths alike, and the model as it is. Throws
// InputError.
std::vector<FrictionCase> read_friction_cases(const std::string& text, const Model& model);

}  // namespace reeve::cli
