// Long work: Ctrl-C and a progress line.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
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

// A bar, share done, rate and time left on stderr; silent where stderr is no terminal.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void operator()(const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  Terminal terminal_;
  bool printed_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

// A progress line for each stage of a study.
class StagedProgress {
 public:
  void operator()(const std::string& stage, const Progress& progress) {
    if (stage != stage_) {
      line_.emplace(stage);
      stage_ = stage;
    }
    (*line_)(progress);
  }

 private:
  std::string stage_;
  std::optional<ProgressLine> line_;
};

// Runs a study with a progress line for each of its stages; Ctrl-C asks it to stop.
template <typename Study>
auto supervised(Study study) {
  StagedProgress progress;
  return study({std::ref(progress), &stop_on_interrupt()});
}

// Shows the present stage on stderr, if its duration is not known; silent if stderr is no terminal.
class StageLine {
 public:
  StageLine();
  ~StageLine();
  StageLine(const StageLine&) = delete;
  StageLine& operator=(const StageLine&) = delete;

  void show(const std::string& stage);

 private:
  Terminal terminal_;
  std::string shown_;
};

}  // namespace reeve::cli
