// Measured tensions beside the model's: summaries for people and programs, and every value.
#pragma once

#include <string>

#include "reports/document/document.hpp"
#include "studies/comparison_study.hpp"

namespace reeve::reports {

Document compare_sheet(const CompareReport& report);
std::string compare_json(const CompareReport& report);
// One line for each reading and channel; a comment line at the top if the data are simulated.
std::string residuals_csv(const CompareReport& report);

}  // namespace reeve::reports
