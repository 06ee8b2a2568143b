#pragma once

#include <string>

#include "numerics/floors.hpp"

namespace reeve::core {

struct Version {
  std::string number;  // project version, such as "0.1.0"
  std::string commit;  // commit of the sources it was built from, or "unknown"
};

Version version();

}  // namespace reeve::core
