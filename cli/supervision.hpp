// Long work: Ctrl-C and a progress line.
#pragma once

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>

#include "cli/terminal.hpp"
#include "search/explore.hpp"

namespace reeve::cli {

// Thrown where stopping leaves nothing worth printing.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

// From here on the first Ctrl-C (or SIGTERM) only sets the flag; a second one ends the process.
const std::atomic<bool>& stop_on_interrupt();

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

// What is being done, on stderr, where how long it takes is not known; silent where stderr is no
// terminal.
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
