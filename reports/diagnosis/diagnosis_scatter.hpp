// Of a diagnosis: how readings scatter, by themselves and from mounting to mounting, and what the
// free coefficients came to.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnose.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {

std::vector<std::string> scatter_sentences(const DiagnosisResult& result);
// That readings of one row go together; empty if they do not.
std::string row_sentence(const DiagnosisResult& result);
// Readings scatter so much that hardly anything would show.
bool drowns_in_noise(const DiagnosisResult& result);
// That it takes such readings, or mountings that differ by more than can be believed; empty if not.
std::string beyond_belief_sentence(const DiagnosisResult& result);
Json row_scatter_json(const DiagnosisResult& result);
Json mountings_json(const DiagnosisResult& result);

// Why what looked likely is not named; none if nothing was dropped.
std::vector<std::string> not_named_sentences(const DiagnosisResult& result);

// "agrees with the hardware (0.180)"; of one whose interval leaves the hardware's value out, but
// which is no named cause, that.
std::string beside_hardware(const CalibratedCoefficient& coefficient);
// "tube_friction: mu = 0.176 (0.165 to 0.187), agrees with the hardware (0.180)"
std::vector<std::string> coefficient_sentences(const DiagnosisResult& result);
Json coefficients_json(const DiagnosisResult& result);

}  // namespace reeve::reports
