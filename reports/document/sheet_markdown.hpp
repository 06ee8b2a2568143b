// A sheet as Markdown, tables with pipes as GitHub shows them.
#pragma once

#include <string>

#include "reports/document/sheet.hpp"

namespace reeve::reports {

std::string markdown(const Sheet& sheet);

}  // namespace reeve::reports
