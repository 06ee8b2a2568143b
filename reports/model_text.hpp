// A model beside the results that depend on it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "core/hardware.hpp"
#include "core/uncertainty_ranges.hpp"
#include "core/value_use.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {

// `unconverged`: how many of the tension solves behind the results did not converge.
//
// null for the plain friction model, which the hardware says all about.
Json model_json(const Model& model, std::uint64_t unconverged);

// None for the plain friction model.
std::vector<DocumentLine> model_lines(const Model& model, std::uint64_t unconverged);

// A sentence for each angle that may be meant in degrees, and for each thing that is given and has
// no effect: the length of the sheaths; a finger of the hardware, and an effect on one, that
// routings of so many fingers do not have.
std::vector<std::string> model_notes(const Model& model, int fingers);
// The same of these networks, and one of values that act at no contact of them
// (core/idle_values.hpp).
std::vector<std::string> model_notes(const Model& model, const std::vector<Network>& networks);
std::vector<DocumentLine> note_lines(const std::vector<std::string>& notes);

// A sentence on the contacts whose own coefficients the draws leave alone; none without any.
std::vector<std::string> undrawn_notes(const Hardware& nominal, const LookAtNetworks& look);

// A sentence for each coefficient that its own range leaves out: ranges that nobody has given are
// those of Teflon on steel, whatever the hardware's own coefficients are.
std::vector<std::string> range_notes(const Hardware& nominal, const UncertaintyRanges& ranges);

}  // namespace reeve::reports
