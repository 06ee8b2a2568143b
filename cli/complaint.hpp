// The last words of a process that fails: one line on stderr, and its exit code.
#pragma once

#include <string>
#include <string_view>

#include "core/error.hpp"

namespace reeve::cli {

// "reeve: …" on one line, whatever characters the user gave, shortened where it is longer than
// anybody reads.
int complain(const std::string& message, int exit_code);
// Each part of a fault has a line of its own.
int complain(const InputError& error, int exit_code);

// From here on `complain` waits for some seconds: most often another process says the same, and all
// are ended. A complaint after that begins with `speaker`.
void leave_first_word_to_others(const std::string& speaker);
// Complains of an error that no other process can report.
int complain_alone(const std::string& message, int exit_code);

// Each line's beginning and end, and how many bytes were left out.
std::string shortened(std::string_view message);

// These need no memory.
int complain_of_memory();
int complain_of_threads();
// From here on an exception may be impossible to catch: in a destructor, or without memory for it.
// It then ends the process with a message and exit code 3, and not by a signal.
void catch_termination();
// From here on a file beyond `ulimit -f` is one that cannot be written, as on a full disk, and not
// the end by a signal, which would leave temporary files.
void outlive_full_files();

}  // namespace reeve::cli
