// Report of an imported logger's time series: a summary for people and programs, and the readings
// as a file of measured data (docs/data.md).
#pragma once

#include <string>

#include "reports/document/document.hpp"
#include "studies/import_study.hpp"

namespace reeve::reports {

Document import_sheet(const ImportReport& report);
std::string import_json(const ImportReport& report);

// One row for each reading. Comments of the log above its header go with it, and `command`, which
// makes it again.
std::string imported_csv(const ImportReport& report, const std::string& command);

}  // namespace reeve::reports
