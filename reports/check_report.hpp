#pragma once

#include <string>

#include "catalog/check.hpp"
#include "reports/document/sheet.hpp"

namespace reeve::reports {

Sheet check_sheet(const CheckReport& report);
std::string check_json(const CheckReport& report);

}  // namespace reeve::reports
