// A document for a terminal, a pipe or a file.
#pragma once

#include <string>

#include "reports/document/document.hpp"
#include "reports/document/text_table.hpp"

namespace reeve::reports {

std::string text(const Document& document, const TextStyle& look = {});

}  // namespace reeve::reports
