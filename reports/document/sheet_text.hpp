// A sheet for a terminal, a pipe or a file.
#pragma once

#include <string>

#include "reports/document/sheet.hpp"
#include "reports/document/text_table.hpp"

namespace reeve::reports {

std::string text(const Sheet& sheet, const Look& look = {});

}  // namespace reeve::reports
