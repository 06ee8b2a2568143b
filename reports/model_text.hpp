// A model beside the results that depend on it.
#pragma once

#include <cstdint>
#include <string>

#include "causes/model.hpp"
#include "reports/json.hpp"

namespace reeve {

// `unconverged`: how many of the tension solves behind the results did not converge.
//
// null for the plain friction model, which the hardware says all about.
Json model_json(const Model& model, std::uint64_t unconverged);

// Lines for a person; "" for the plain friction model.
std::string model_text(const Model& model, std::uint64_t unconverged);

}  // namespace reeve
