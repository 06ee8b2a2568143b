// A document as Markdown, tables with pipes as GitHub shows them.
#pragma once

#include <string>

#include "reports/document/document.hpp"

namespace reeve::reports {

std::string markdown(const Document& document);

}  // namespace reeve::reports
