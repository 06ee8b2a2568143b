// The signals of a log over time, where readings were taken, and why the rest was left out.
#pragma once

#include <string>

#include "studies/import_study.hpp"

namespace reeve::reports {

std::string log_svg(const ImportReport& report);

}  // namespace reeve::reports
