#include "store/writer_lock.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "core/error.hpp"

namespace reeve::store {
namespace {

// Beyond all that SQLite locks, and beyond the end of any file.
constexpr off_t locked_byte = off_t{1} << 62;

}  // namespace

WriterLock::WriterLock(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) return;
  struct flock lock = {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = locked_byte;
  lock.l_len = 1;
  if (::fcntl(descriptor_, F_OFD_SETLK, &lock) == 0) return;
  if (errno != EAGAIN && errno != EACCES) return;
  ::close(descriptor_);
  throw InputError({.where = file.string(), .what = "another process is writing it"});
}

WriterLock::~WriterLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

bool WriterLock::is_on(const std::filesystem::path& file) const {
  struct stat locked = {};
  if (descriptor_ < 0 || ::fstat(descriptor_, &locked) != 0) return true;
  struct stat named = {};
  return ::stat(file.c_str(), &named) == 0 && named.st_dev == locked.st_dev &&
         named.st_ino == locked.st_ino;
}

}  // namespace reeve::store
