// Measured tensions beside the model's: summaries for people and programs, and every value.
#pragma once

#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "diagnosis/comparison.hpp"
#include "diagnosis/measured_data.hpp"
#include "reports/sheet.hpp"

namespace reeve {

struct CompareReport {
  MeasuredData data;
  std::vector<std::string> names;  // of data.routings; "" where there is none
  Hardware hardware;
  Comparison comparison;
};

Sheet compare_sheet(const CompareReport& report);
std::string compare_json(const CompareReport& report);
// One line for each reading and channel; a comment line at the top if the data are simulated.
std::string residuals_csv(const CompareReport& report);

}  // namespace reeve
