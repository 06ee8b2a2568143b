// Long work: Ctrl-C and a progress line.
#pragma once

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>

#include "cli/terminal.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::cli {

// Thrown where stopping leaves nothing worth printing.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
  explicit Interrupted(const std::string& what) : std::runtime_error("interrupted: " + what) {}
};

// From here on the first Ctrl-C (or SIGTERM, SIGHUP, or SIGUSR1, which mpirun passes on) only sets
// the flag; the same one again ends the process. A SIGHUP that is ignored, as by nohup, stays
// ignored.
const std::atomic<bool>& stop_on_interrupt();
const std::atomic<bool>& stop_was_requested();
// True if SIGTERM was among them.
const std::atomic<bool>& was_terminated();
// Ctrl-C, SIGHUP and SIGUSR1 are for somebody else.
void leave_interrupts_to_others();

// A line on stderr about what is being done; silent where stderr is no terminal.
class StatusLine {
 public:
  StatusLine() = default;
  ~StatusLine() { wipe(); }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  // The present stage, if its duration is not known.
  void show(const std::string& stage);
  // A bar, share done, rate and time left.
  void operator()(const std::string& stage, const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;

  void wipe();

  Terminal terminal_ = terminal(STDERR_FILENO);
  std::string shown_;
  std::string stage_;
  Clock::time_point start_;
  Clock::time_point last_;
};

// Runs a study with a progress line for each of its stages; Ctrl-C asks it to stop.
template <typename Study>
auto supervised(Study study) {
  StatusLine progress;
  return study({std::ref(progress), &stop_on_interrupt()});
}

}  // namespace reeve::cli
