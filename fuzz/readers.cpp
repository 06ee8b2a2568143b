#include <cstdio>
#include <cstdlib>

#include "fuzz/fuzzed.hpp"

namespace reeve::fuzz {

const std::vector<NamedReader>& readers() {
  static const std::vector<NamedReader> all{
      {"word", word},       {"readings", readings}, {"series", series}, {"settings", settings},
      {"options", options}, {"shard", shard},       {"store", store}};
  return all;
}

void require(bool holds, const char* sentence) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", sentence);
  std::abort();
}

}  // namespace reeve::fuzz
