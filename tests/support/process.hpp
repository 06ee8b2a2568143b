// Runs a program as a user does: what it printed, how it ended, and ways to disturb it.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reeve::testing {

// What is known of a process while it runs.
struct RunningProcess {
  pid_t id = 0;
  const std::string& out;
  const std::string& err;
};

// A signal, sent once as soon as `when` says so; 0: its terminals are closed. stderr's, if it is
// one, is then that of its session, which the kernel tells of it.
struct Disturbance {
  int signal = 0;
  std::function<bool(const RunningProcess&)> when;
};

struct ProcessOptions {
  std::filesystem::path directory = ".";
  std::map<std::string, std::string> environment = {};  // besides the caller's
  std::chrono::seconds timeout{240};                    // then it is killed
  std::filesystem::path stdout_to = {};                 // a file instead of the pipe
  bool stderr_is_terminal = false;
  // A terminal as wide as that, in columns, instead of the pipe; 0: it does not know its width.
  std::optional<unsigned short> stdout_terminal_width = {};
  std::optional<Disturbance> disturbance = {};
  // Bytes that a file may have: beyond them nothing can be written, as on a full disk. Or the
  // kernel kills the process there (SIGXFSZ), though it would ignore that.
  std::optional<rlim_t> file_size_limit = {};
  bool dies_at_file_size_limit = false;
};

struct ProcessResult {
  int exit_code = -1;  // -1 if a signal ended it
  int signal = 0;      // that signal
  bool timed_out = false;
  std::string out;
  std::string err;
};

// The executable reeve of the build that is tested.
std::string reeve_path();

// Words of a command: a list, or a line that is split at its spaces, where '' is an empty word.
struct Arguments : std::vector<std::string> {
  using vector::vector;
  Arguments(std::vector<std::string> words) : vector(std::move(words)) {}
  Arguments(const char* line);
};

// Throws std::runtime_error if it cannot be started.
ProcessResult run_process(const std::vector<std::string>& command,
                          const ProcessOptions& options = {});

// The executable of this build, with its own catalogue unless the environment names another.
ProcessResult reeve(const Arguments& arguments, const ProcessOptions& options = {});

// Whether the process handles the signal by now.
bool catches(pid_t process, int signal);

// True from this long after the process began to handle the signal.
std::function<bool(const RunningProcess&)> after_it_catches(int signal,
                                                            std::chrono::milliseconds pause);

}  // namespace reeve::testing
