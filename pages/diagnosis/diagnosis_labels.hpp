// Short texts of a diagnosis' page that its charts and its tables share.
#pragma once

#include <string>
#include <vector>

#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/output/json.hpp"

namespace reeve::pages {

// "Simulated data. " before captions where they are; otherwise "".
std::string simulated_label(const DiagnosisReport& report);

// The verdict as a heading, and the shape that goes with it: a template's flag.
struct VerdictLabel {
  std::string words;
  std::string shape;
};
VerdictLabel verdict_label(const DiagnosisReport& report);

std::string compared_alt(const DiagnosisReport& report);

// How a weighed model stands to the answer: "named", "cannot be told from it", "not confirmed" or
// "weighed".
std::string standing(const DiagnosisResult& result, const std::vector<std::string>& model);

// The best first.
std::vector<WeighedCauses> by_training_gain(std::vector<WeighedCauses> weighed);

}  // namespace reeve::pages
