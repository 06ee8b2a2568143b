// The bytes of a file that the user names: a regular one, a device, or a pipe.
//
// A pipe has nothing to read until another program opens and fills it, which may be never. Whoever
// would otherwise wait in silence is told after a second, by the function that was set for it. A
// signal alone does not end a wait: it may come between two looks at the pipe, or meet another
// thread. The flag that it sets does.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "numerics/floors.hpp"

namespace reeve::core {

// All that the file holds, but no more than one byte beyond `most`, which tells that it holds more.
// `kind` is what it should be, such as "a CSV file". Throws InputError, and WaitInterrupted.
std::string read_input(const std::filesystem::path& file, std::size_t most,
                       const std::string& kind);

enum class Awaited : std::uint8_t { writer, reader };

// Called, with the name as it was given, where a pipe has kept its reader or its writer waiting.
using WaitingNotice = void (*)(const char* file, Awaited awaited);
void set_waiting_notice(WaitingNotice notice);
void give_waiting_notice(const std::string& file, Awaited awaited);

inline constexpr int waiting_patience_ms = 1000;

class WaitInterrupted : public std::runtime_error {
 public:
  WaitInterrupted(const std::string& file, Awaited awaited);
};

// Ends every wait for a pipe end as soon as the flag is true, from this call on.
void end_waits_on(const std::atomic<bool>* stop);
bool waits_are_ended();

}  // namespace reeve::core
