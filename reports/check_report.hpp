#pragma once

#include <string>

#include "catalog/check.hpp"
#include "reports/document/document.hpp"

namespace reeve::reports {

Document check_sheet(const CheckReport& report);
std::string check_json(const CheckReport& report);

}  // namespace reeve::reports
