// A guessed mapping of a log's columns, for people and programs.
#pragma once

#include <string>

#include "reports/document/document.hpp"
#include "studies/guess_study.hpp"

namespace reeve::reports {

// `command` imports the log by this mapping; it is given only where that can succeed.
Document guess_document(const GuessReport& report, const std::string& command);
std::string guess_json(const GuessReport& report, const std::string& command);

}  // namespace reeve::reports
