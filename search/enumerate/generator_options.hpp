// Options of generators say what is to be generated, and which part of it.
#pragma once

#include <cstdint>

#include "core/canonical.hpp"
#include "search/enumerate/parts.hpp"

namespace reeve::search {

struct GeneratorOptions {
  PartSet parts = full_parts();
  int fingers = 2;
  FingerIdentity identity = FingerIdentity::identical;
  bool one_tendon = false;  // only routings with a single tendon, or tree of tendons
};

// Places in the whole enumeration.
struct ShardRange {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

}  // namespace reeve::search
