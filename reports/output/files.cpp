#include "reports/output/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <set>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/input_file.hpp"

namespace reeve::reports {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 255;  // limit of a file name, in bytes, nearly everywhere

[[noreturn]] void fail_to_write(const fs::path& file, const std::error_code& error) {
  throw InputError(fmt::format("file '{}' cannot be written: {}", file.string(), error.message()));
}

std::error_code last_failure() { return {errno, std::generic_category()}; }

// Two runs that write the same file at a time must not share the temporary one.
fs::path temporary_beside(const fs::path& file) {
  const std::string end = fmt::format(".{}.tmp", ::getpid());
  return file.parent_path() / (file.filename().string().substr(0, longest_name - end.size()) + end);
}

std::error_code write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written >= 0) {
      content.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return last_failure();
    }
  }
  return {};
}

// Some file systems say only here that there was no room.
std::error_code close_after(int descriptor, std::error_code error) {
  if (::close(descriptor) != 0 && !error) error = last_failure();
  return error;
}

// On the disk before it has its name, as far as the file system can.
std::error_code flush(int descriptor) {
  if (::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOSYS || errno == EROFS) return {};
  return last_failure();
}

// New names are on the disk when their folder is. The files are whole whether or not it can be.
void flush_folder(const fs::path& folder) {
  const int descriptor =
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

// Keeps the permissions, and the owner if the process may give files away.
std::error_code keep_permissions(int descriptor, const ReplacedFile& replaced) {
  if (::fchown(descriptor, replaced.owner, replaced.group) != 0) errno = 0;
  return ::fchmod(descriptor, replaced.mode) == 0 ? std::error_code() : last_failure();
}

std::error_code write_new(const fs::path& file, const std::string& content,
                          const std::optional<ReplacedFile>& replaced) {
  // A process that had the same number and was killed may have left the file.
  ::unlink(file.c_str());
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return last_failure();
  std::error_code error = write_all(descriptor, content);
  if (!error && replaced) error = keep_permissions(descriptor, *replaced);
  if (!error) error = flush(descriptor);
  error = close_after(descriptor, error);
  if (error) ::unlink(file.c_str());
  return error;
}

// A pipe opens when somebody reads it, which may be never: it is asked again and again.
int open_to_write_through(const fs::path& file) {
  constexpr int between_ms = 10;
  constexpr timespec between{0, between_ms * 1'000'000L};
  for (int waited_ms = 0;; waited_ms += between_ms) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
    if (descriptor >= 0) ::fcntl(descriptor, F_SETFL, 0);
    if (descriptor >= 0 || errno != ENXIO || !fs::is_fifo(file)) return descriptor;
    if (waited_ms == waiting_patience_ms) give_waiting_notice(file, Awaited::reader);
    if (waits_are_ended()) throw WaitInterrupted(file.string(), Awaited::reader);
    ::nanosleep(&between, nullptr);
  }
}

std::error_code write_through(const Destination& there, const std::string& content) {
  if (there.descriptor) {
    std::cout.flush();
    return write_all(*there.descriptor, content);
  }
  const int descriptor = open_to_write_through(there.file);
  if (descriptor < 0) return last_failure();
  return close_after(descriptor, write_all(descriptor, content));
}

}  // namespace

void prepare_directory(const fs::path& directory, const std::string& option) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (!error && !fs::is_directory(directory, error)) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (!error && ::access(directory.c_str(), W_OK | X_OK) != 0) error = last_failure();
  if (error) {
    throw InputError(
        {.what = option,
         .value = directory.string(),
         .expected = fmt::format("a folder that can be written to: {}", error.message())});
  }
}

FileBatch::~FileBatch() {
  for (const Entry& entry : entries_) {
    if (!entry.temporary.empty()) ::unlink(entry.temporary.c_str());
  }
}

void FileBatch::add(const fs::path& file, const std::string& content) {
  Entry entry{file, destination(file), {}, {}, false};
  if (entry.there.error) fail_to_write(file, entry.there.error);
  if (entry.there.descriptor || entry.there.written_through) {
    entry.content = content;
    entries_.push_back(std::move(entry));
    return;
  }
  require_alone(entry);
  entry.temporary = temporary_beside(entry.there.file);
  entries_.push_back(std::move(entry));
  const Entry& added = entries_.back();
  const std::error_code error = write_new(added.temporary, content, added.there.replaced);
  if (error) fail_to_write(file, error);
}

void FileBatch::remove(const fs::path& file) {
  std::error_code ignored;
  const fs::file_type type = fs::symlink_status(file, ignored).type();
  if (type != fs::file_type::regular && type != fs::file_type::symlink) return;
  entries_.push_back({file, Destination{.file = file}, {}, {}, true});
}

// The second of two would go by the temporary name of the first.
void FileBatch::require_alone(const Entry& entry) const {
  for (const Entry& other : entries_) {
    if (other.is_removed || other.there.file != entry.there.file) continue;
    throw InputError(fmt::format("files '{}' and '{}' are the same, by a link: expected two files",
                                 other.named.string(), entry.named.string()));
  }
}

void FileBatch::take_old_away() const {
  const bool is_alone = entries_.size() == 1;
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    if (!entry->is_regular() || (is_alone && !entry->is_removed)) continue;
    if (::unlink(entry->there.file.c_str()) == 0 || errno == ENOENT) continue;
    fail_to_write(entry->named, last_failure());
  }
}

std::error_code FileBatch::appear(Entry& entry) {
  if (entry.is_removed) return {};
  if (entry.temporary.empty()) return write_through(entry.there, entry.content);
  if (std::rename(entry.temporary.c_str(), entry.there.file.c_str()) != 0) return last_failure();
  entry.temporary.clear();
  return {};
}

void FileBatch::commit() {
  // All that needs memory comes before the old files go.
  std::set<fs::path> folders;
  for (const Entry& entry : entries_) {
    if (entry.is_regular()) folders.insert(entry.there.file.parent_path());
  }
  take_old_away();
  for (Entry& entry : entries_) {
    const std::error_code error = appear(entry);
    if (error) fail_to_write(entry.named, error);
  }
  entries_.clear();
  for (const fs::path& folder : folders) flush_folder(folder);
}

void write_file(const fs::path& file, const std::string& content) {
  FileBatch batch;
  batch.add(file, content);
  batch.commit();
}

}  // namespace reeve::reports
