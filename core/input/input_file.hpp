// The bytes of a file that the user names: a regular one, a device, or a pipe.
//
// A pipe has nothing to read until another program opens and fills it, which may be never. Whoever
// would otherwise wait in silence is told after a second, by the function that was set for it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "numerics/floors.hpp"

namespace reeve::core {

// All that the file holds, but no more than one byte beyond `most`, which tells that it holds more.
// `kind` is what it should be, such as "a CSV file". Throws InputError.
std::string read_input(const std::filesystem::path& file, std::size_t most,
                       const std::string& kind);

// Called, with the name as it was given, where a pipe has kept the reader waiting.
using WaitingNotice = void (*)(const char* file);
void set_waiting_notice(WaitingNotice notice);

}  // namespace reeve::core
