#pragma once

#include <string>

#include "catalog/check.hpp"

namespace reeve {

std::string check_table(const CheckReport& report);
std::string check_json(const CheckReport& report);

}  // namespace reeve
