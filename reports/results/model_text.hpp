// A model beside the results that depend on it.
#pragma once

#include <cstdint>
#include <vector>

#include "causes/model.hpp"
#include "reports/json.hpp"
#include "reports/sheet/sheet.hpp"

namespace reeve::reports {

// `unconverged`: how many of the tension solves behind the results did not converge.
//
// null for the plain friction model, which the hardware says all about.
Json model_json(const Model& model, std::uint64_t unconverged);

// None for the plain friction model.
std::vector<SheetLine> model_lines(const Model& model, std::uint64_t unconverged);

}  // namespace reeve::reports
