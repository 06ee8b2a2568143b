#include "reports/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/error.hpp"

namespace reeve::reports {
namespace {

// Two runs that write the same file at a time must not share the temporary one.
std::filesystem::path temporary_beside(const std::filesystem::path& file) {
  return file.string() + fmt::format(".{}.tmp", ::getpid());
}

}  // namespace

void prepare_directory(const std::filesystem::path& directory, const std::string& option) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (!error && !std::filesystem::is_directory(directory, error)) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (!error && ::access(directory.c_str(), W_OK | X_OK) != 0) {
    error = std::error_code(errno, std::generic_category());
  }
  if (error) {
    throw InputError(
        {.what = option,
         .value = directory.string(),
         .expected = fmt::format("a folder that can be written to: {}", error.message())});
  }
}

void write_file(const std::filesystem::path& file, const std::string& content) {
  const std::filesystem::path temporary = temporary_beside(file);
  std::ofstream out(temporary, std::ios::binary);
  out << content;
  out.close();
  std::error_code error;
  if (out.good()) std::filesystem::rename(temporary, file, error);
  if (!out.good() || error) {
    const std::string reason = error ? error.message() : std::strerror(errno);
    std::filesystem::remove(temporary, error);
    throw InputError(fmt::format("file '{}' cannot be written: {}", file.string(), reason));
  }
}

}  // namespace reeve::reports
