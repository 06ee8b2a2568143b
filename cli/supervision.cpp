#include "cli/supervision.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <utility>

namespace reeve::cli {
namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

void request_stop(int) { stop_requested.store(true); }

}  // namespace

const std::atomic<bool>& stop_on_interrupt() {
  struct sigaction action = {};
  action.sa_handler = request_stop;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return stop_requested;
}

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), visible_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (printed_) std::cerr << "\r\x1b[K" << std::flush;
}

void ProgressLine::operator()(const Progress& progress) {
  constexpr auto pause = std::chrono::milliseconds(200);
  const Clock::time_point now = Clock::now();
  if (!visible_ || now - last_ < pause || progress.total == 0) return;
  last_ = now;
  printed_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(progress.done) / seconds;
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  const double left = static_cast<double>(progress.total - progress.done) / rate;
  std::cerr << fmt::format("\r{}: {:.0f} %, {:.0f} a second, {:.0f} s left\x1b[K", what_,
                           100 * share, rate, left)
            << std::flush;
}

StageLine::StageLine() : visible_(::isatty(STDERR_FILENO) == 1) {}

StageLine::~StageLine() {
  if (!shown_.empty()) std::cerr << "\r\x1b[K" << std::flush;
}

void StageLine::show(const std::string& stage) {
  if (!visible_ || stage == shown_) return;
  shown_ = stage;
  std::cerr << fmt::format("\r{}\x1b[K", stage) << std::flush;
}

}  // namespace reeve::cli
