#include "cli/supervision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <iostream>

#include "search/explore.hpp"

namespace reeve::cli {
namespace {

// Progress as one line of text.

constexpr std::size_t least_bar = 10;
constexpr std::size_t most_bar = 40;

std::string bar(double share, std::size_t cells) {
  const auto full = static_cast<std::size_t>(std::floor(share * static_cast<double>(cells)));
  std::string text(std::min(full, cells), '=');
  if (text.size() < cells) text += '>';
  text.resize(cells, ' ');
  return "[" + text + "]";
}

// "exploring [====>       ]  38 %, 81234 a second, 4 s left" in at most so many columns; where
// there is no room for a bar, without one.
std::string progress_bar(const std::string& what, const Progress& progress, double seconds,
                         std::size_t width) {
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  const double rate = static_cast<double>(progress.done - progress.before) / seconds;
  const double left = static_cast<double>(progress.total - progress.done) / rate;
  const std::string figures =
      fmt::format("{:3.0f} %, {:.0f} a second, {:.0f} s left", 100 * share, rate, left);
  constexpr std::size_t around_bar = 4;  // brackets and spaces
  const std::size_t used = what.size() + around_bar + figures.size();
  if (used + least_bar > width) return (what + " " + figures).substr(0, width);
  return what + " " + bar(share, std::min(width - used, most_bar)) + " " + figures;
}

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

std::atomic<bool> terminated{false};

void request_stop(int signal) {
  if (signal == SIGTERM) terminated.store(true);
  stop_requested.store(true);
}

// Nanoseconds of a clock that a signal handler may read.
std::atomic<std::int64_t> first_end{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "set from a signal handler");

// One end may be told twice at once: a terminal that is closed hangs up by its shell and by the
// kernel, and timeout(1) terminates its child and then the group that it is in.
constexpr std::int64_t one_end = 1'000'000'000;

void request_stop_at_end(int signal) {
  timespec time = {};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  const std::int64_t now = time.tv_sec * 1'000'000'000 + time.tv_nsec;
  std::int64_t none = 0;
  const bool is_first = first_end.compare_exchange_strong(none, now);
  if (!is_first && now - first_end.load() > one_end) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  request_stop(signal);
}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(signal, &action, nullptr);
}

// True under nohup, for SIGHUP.
bool is_ignored(int signal) {
  struct sigaction action = {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

const std::atomic<bool>& stop_on_interrupt() {
  for (const int signal : {SIGINT, SIGUSR1}) {
    handle(signal, request_stop, static_cast<int>(SA_RESETHAND));
  }
  handle(SIGTERM, request_stop_at_end, 0);
  if (!is_ignored(SIGHUP)) handle(SIGHUP, request_stop_at_end, 0);
  return stop_requested;
}

const std::atomic<bool>& stop_was_requested() { return stop_requested; }

const std::atomic<bool>& was_terminated() { return terminated; }

void leave_interrupts_to_others() {
  for (const int signal : {SIGINT, SIGUSR1, SIGHUP}) std::signal(signal, SIG_IGN);
}

// In place of the line that stands there. One column stays free: a full line moves some terminals
// on to the next.
void StatusLine::show(const std::string& stage) {
  if (!terminal_.obeys_codes || stage == shown_) return;
  shown_ = stage;
  std::cerr << '\r' << stage.substr(0, terminal_.width - 1) << "\x1b[K" << std::flush;
}

void StatusLine::operator()(const std::string& stage, const Progress& progress) {
  constexpr auto pause = std::chrono::milliseconds(200);
  const Clock::time_point now = Clock::now();
  if (stage != stage_) {
    wipe();
    stage_ = stage;
    start_ = last_ = now;
  }
  if (!terminal_.obeys_codes || now - last_ < pause || progress.total == 0) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  show(progress_bar(stage, progress, seconds, terminal_.width - 1));
}

void StatusLine::wipe() {
  if (!shown_.empty()) std::cerr << "\r\x1b[K" << std::flush;
  shown_.clear();
}

}  // namespace reeve::cli
