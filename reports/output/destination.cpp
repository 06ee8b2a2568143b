#include "reports/output/destination.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <string>

namespace reeve::reports {
namespace {

namespace fs = std::filesystem;

// As many as the kernel follows.
constexpr int most_links = 40;

std::error_code last_error() { return {errno, std::generic_category()}; }

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

// N, if the path is an entry of this process' own table of open files.
std::optional<int> own_descriptor(const fs::path& file) {
  std::error_code ignored;
  const fs::path folder = fs::canonical(folder_of(file), ignored);
  if (folder.empty() || folder != fs::canonical("/proc/self/fd", ignored)) return std::nullopt;
  const std::string name = file.filename().string();
  int descriptor = -1;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), descriptor);
  if (error != std::errc{} || end != name.data() + name.size()) return std::nullopt;
  return descriptor;
}

std::error_code why_not_in_folder(const fs::path& folder) {
  struct stat status = {};
  if (::stat(folder.c_str(), &status) != 0) return last_error();
  if (!S_ISDIR(status.st_mode)) return std::make_error_code(std::errc::not_a_directory);
  return ::access(folder.c_str(), W_OK | X_OK) == 0 ? std::error_code() : last_error();
}

// Describes a file that exists and is no link.
void describe(Destination& there, const struct stat& status) {
  if (S_ISDIR(status.st_mode)) {
    there.error = std::make_error_code(std::errc::is_a_directory);
    return;
  }
  there.written_through = !S_ISREG(status.st_mode);
  there.replaced = ReplacedFile{status.st_mode & 0777, status.st_uid, status.st_gid};
  if (::access(there.file.c_str(), W_OK) != 0) there.error = last_error();
  if (!there.error && !there.written_through)
    there.error = why_not_in_folder(folder_of(there.file));
}

}  // namespace

Destination destination(const fs::path& named) {
  Destination there{named};
  if (named.empty()) there.error = std::make_error_code(std::errc::no_such_file_or_directory);
  for (int links = 0; !there.error; ++links) {
    there.descriptor = own_descriptor(there.file);
    if (there.descriptor) return there;
    struct stat status = {};
    if (::lstat(there.file.c_str(), &status) != 0) {
      if (errno != ENOENT || !there.file.has_filename()) {
        there.error = last_error();
      } else {
        there.error = why_not_in_folder(folder_of(there.file));
      }
      return there;
    }
    if (!S_ISLNK(status.st_mode)) {
      describe(there, status);
      return there;
    }
    if (links == most_links) {
      there.error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
      return there;
    }
    std::error_code error;
    const fs::path target = fs::read_symlink(there.file, error);
    there.error = error;
    there.file = folder_of(there.file) / target;
  }
  return there;
}

}  // namespace reeve::reports
