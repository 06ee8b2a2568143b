// Report of an imported logger's time series, or of a guessed mapping of its columns: a summary for
// people and programs, a chart, and the readings as a file of measured data (docs/data.md).
#pragma once

#include <string>
#include <vector>

#include "readings/log/logged_series.hpp"
#include "readings/log/sample_use.hpp"
#include "reports/document/document.hpp"
#include "studies/guess_study.hpp"
#include "studies/import_study.hpp"

namespace reeve::reports {

Document import_sheet(const ImportReport& report);
std::string import_json(const ImportReport& report);

// One row for each reading. Comments of the log above its header go with it, and `command`, which
// makes it again.
std::string imported_csv(const ImportReport& report, const std::string& command);

// "the carriage stands"
const char* sample_use_words(SampleUse use);

// Returns the name of a tension's column, without its unit: "T1", "Ta".
std::string tension_words(const LoggedSignal& tension);

// Parallel to all_sample_uses.
std::vector<std::size_t> count_uses(const std::vector<SampleUse>& uses);

// The signals of a log over time, where readings were taken, and why the rest was left out.
std::string log_svg(const ImportReport& report);

// `command` imports the log by this mapping; it is given only where that can succeed.
Document guess_document(const GuessReport& report, const std::string& command);
std::string guess_json(const GuessReport& report, const std::string& command);

}  // namespace reeve::reports
