#include "core/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>

#include "core/error.hpp"

namespace reeve::core {
namespace {

std::atomic<WaitingNotice> waiting_notice{nullptr};
std::atomic<const std::atomic<bool>*> waits_end{nullptr};

constexpr int between_looks_ms = 100;

[[noreturn]] void fail_to_read(const std::string& name, int reason) {
  throw InputError(
      {.where = name, .what = fmt::format("cannot be read: {}", std::strerror(reason))});
}

class OpenFile {
 public:
  // Not blocking: a pipe without a writer would never be open.
  explicit OpenFile(const std::string& name)
      : descriptor_(::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
    if (descriptor_ < 0) fail_to_read(name, errno);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { ::close(descriptor_); }

  mode_t mode() const {
    struct stat status = {};
    return ::fstat(descriptor_, &status) == 0 ? status.st_mode : 0;
  }

  bool is_ready(int timeout_ms) const {
    pollfd waited{descriptor_, POLLIN, 0};
    return ::poll(&waited, 1, timeout_ms) > 0;
  }

  void block() const { ::fcntl(descriptor_, F_SETFL, 0); }

  ssize_t read(char* to, std::size_t size) const {
    ssize_t count = -1;
    do {
      count = ::read(descriptor_, to, size);
    } while (count < 0 && errno == EINTR);
    return count;
  }

 private:
  int descriptor_;
};

// A regular file is always ready to be read, if only to its end.
void wait_for_text(const OpenFile& file, const std::string& name) {
  while (!file.is_ready(between_looks_ms)) {
    if (waits_are_ended()) throw WaitInterrupted(name, Awaited::writer);
  }
}

}  // namespace

void set_waiting_notice(WaitingNotice notice) { waiting_notice.store(notice); }

void give_waiting_notice(const std::string& file, Awaited awaited) {
  const WaitingNotice notice = waiting_notice.load();
  if (notice != nullptr) notice(file.c_str(), awaited);
}

WaitInterrupted::WaitInterrupted(const std::string& file, Awaited awaited)
    : std::runtime_error(fmt::format("interrupted: nobody {} '{}'",
                                     awaited == Awaited::reader ? "reads" : "writes to", file)) {}

void end_waits_on(const std::atomic<bool>* stop) { waits_end.store(stop); }

bool waits_are_ended() {
  const std::atomic<bool>* const stop = waits_end.load();
  return stop != nullptr && stop->load();
}

std::string read_input(const std::filesystem::path& file, std::size_t most,
                       const std::string& kind) {
  const std::string& name = file.native();
  const OpenFile in(name);
  const mode_t mode = in.mode();
  if (S_ISDIR(mode)) {
    throw InputError({.where = name, .what = "is a directory", .expected = kind});
  }
  if (S_ISFIFO(mode) && !in.is_ready(waiting_patience_ms)) {
    give_waiting_notice(name, Awaited::writer);
  }
  in.block();
  std::string text;
  // In pieces, since what is no regular file does not tell its size.
  for (std::size_t piece = std::size_t{1} << 16; text.size() <= most;
       piece = std::min(2 * piece, std::size_t{1} << 22)) {
    const std::size_t begin = text.size();
    const std::size_t wanted = std::min(piece, most + 1 - begin);
    text.resize(begin + wanted);
    wait_for_text(in, name);
    const ssize_t count = in.read(text.data() + begin, wanted);
    if (count < 0) fail_to_read(name, errno);
    text.resize(begin + static_cast<std::size_t>(count));
    if (count == 0) break;
  }
  return text;
}

}  // namespace reeve::core
