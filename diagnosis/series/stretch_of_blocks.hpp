// Successive blocks of a recording that may give readings.
#pragma once

#include <cstddef>
#include <optional>

#include "core/grasp.hpp"

namespace reeve::diagnosis {

struct BlockStretch {
  std::size_t begin = 0;  // blocks [begin, end)
  std::size_t end = 0;
  std::optional<Direction> direction;  // nothing if the log does not say
};

}  // namespace reeve::diagnosis
