// Loaded before a program (LD_PRELOAD), disturbs its work on regular files as the environment says:
// with FULL_AT=n the n-th write or rename finds the disk full, with KILL_AT=n the process is killed
// before the n-th rename or removal.
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>

namespace {

long place(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? 0 : std::atol(value);
}

bool finds_disk_full() {
  static std::atomic<long> calls{0};
  if (++calls != place("FULL_AT")) return false;
  errno = ENOSPC;
  return true;
}

void may_be_killed() {
  static std::atomic<long> calls{0};
  if (++calls != place("KILL_AT")) return;
  ::kill(::getpid(), SIGKILL);
}

bool is_regular(int descriptor) {
  struct stat status = {};
  return ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

extern "C" {

ssize_t write(int descriptor, const void* bytes, std::size_t count) {
  if (is_regular(descriptor) && finds_disk_full()) return -1;
  return ::syscall(SYS_write, descriptor, bytes, count);
}

int rename(const char* from, const char* to) noexcept {
  may_be_killed();
  if (finds_disk_full()) return -1;
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int unlink(const char* file) noexcept {
  may_be_killed();
  return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, file, 0));
}

}  // extern "C"
