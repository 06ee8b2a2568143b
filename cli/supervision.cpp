#include "cli/supervision.hpp"

#include <unistd.h>

#include <csignal>
#include <iostream>
#include <utility>

#include "cli/progress_bar.hpp"

namespace reeve::cli {
namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

std::atomic<bool> terminated{false};

void request_stop(int signal) {
  if (signal == SIGTERM) terminated.store(true);
  stop_requested.store(true);
}

// In place of the line that stands there. One column stays free: a full line moves some terminals
// on to the next.
void show_line(const std::string& text, std::size_t width) {
  std::cerr << '\r' << text.substr(0, width - 1) << "\x1b[K" << std::flush;
}

void wipe_line() { std::cerr << "\r\x1b[K" << std::flush; }

}  // namespace

const std::atomic<bool>& stop_on_interrupt() {
  struct sigaction action = {};
  action.sa_handler = request_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGUSR1, &action, nullptr);
  return stop_requested;
}

const std::atomic<bool>& stop_was_requested() { return stop_requested; }

const std::atomic<bool>& was_terminated() { return terminated; }

void leave_interrupts_to_others() {
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGUSR1, SIG_IGN);
}

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), terminal_(terminal(STDERR_FILENO)) {}

ProgressLine::~ProgressLine() {
  if (printed_) wipe_line();
}

void ProgressLine::operator()(const Progress& progress) {
  constexpr auto pause = std::chrono::milliseconds(200);
  const Clock::time_point now = Clock::now();
  if (!terminal_.obeys_codes || now - last_ < pause || progress.total == 0) return;
  last_ = now;
  printed_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  show_line(progress_bar(what_, progress, seconds, terminal_.width - 1), terminal_.width);
}

StageLine::StageLine() : terminal_(terminal(STDERR_FILENO)) {}

StageLine::~StageLine() {
  if (!shown_.empty()) wipe_line();
}

void StageLine::show(const std::string& stage) {
  if (!terminal_.obeys_codes || stage == shown_) return;
  shown_ = stage;
  show_line(stage, terminal_.width);
}

}  // namespace reeve::cli
