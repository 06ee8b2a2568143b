// Diagnosis report: scatter of readings, by themselves and from mounting to mounting, and the
// estimates of the free coefficients.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnose.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {

std::vector<std::string> scatter_sentences(const DiagnosisResult& result);
// Says that residuals of a row are correlated; empty if they are not.
std::string row_sentence(const DiagnosisResult& result);
// Readings scatter so much that hardly anything would show.
bool drowns_in_noise(const DiagnosisResult& result);
// Warns that the noise, or the mounting-to-mounting scatter, is implausibly great; empty if neither
// is.
std::string beyond_belief_sentence(const DiagnosisResult& result);
Json row_scatter_json(const DiagnosisResult& result);
Json mountings_json(const DiagnosisResult& result);

// Why what looked likely is not named; none if nothing was dropped.
std::vector<std::string> not_named_sentences(const DiagnosisResult& result);

// "agrees with the nominal value (0.180)"; of one whose interval leaves the hardware's value out,
// but which is no named cause, that.
std::string beside_hardware(const CalibratedCoefficient& coefficient);
// "tube_friction: mu = 0.176 (0.165 to 0.187), agrees with the nominal value (0.180)"
std::vector<std::string> coefficient_sentences(const DiagnosisResult& result);
Json coefficients_json(const DiagnosisResult& result);

}  // namespace reeve::reports
