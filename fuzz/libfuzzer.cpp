// One program for each reader: REEVE_FUZZED is the function's name.
#include <cstddef>
#include <cstdint>

#include "fuzz/fuzzed.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reeve::fuzz::REEVE_FUZZED({reinterpret_cast<const char*>(data), size});
  return 0;
}
