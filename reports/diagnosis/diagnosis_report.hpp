// A diagnosis: the answer and its evidence for people, the same for programs, and every value.
#pragma once

#include <string>

#include "core/uncertainty_ranges.hpp"
#include "reports/document/document.hpp"
#include "studies/diagnosis_study.hpp"

namespace reeve::reports {

// Answers what is wrong, which cause, and how much better, in at most six lines.
std::string diagnosis_answer(const DiagnosisReport& report);
// Returns the lines of the answer beyond those; often there are none.
std::string further_answer(const DiagnosisReport& report);
// The answer, then what it rests on.
Document diagnosis_document(const DiagnosisReport& report);
std::string diagnosis_json(const DiagnosisReport& report);
// One line for each reading and channel; a comment line at the top if the data are simulated.
std::string diagnosis_residuals_csv(const DiagnosisReport& report);
// A model file that says where it is from.
std::string extended_model_toml(const DiagnosisReport& report,
                                const UncertaintyRanges& uncertainty);

}  // namespace reeve::reports
