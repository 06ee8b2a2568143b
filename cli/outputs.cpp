#include "cli/outputs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/error.hpp"

namespace reeve::cli {
namespace {

namespace fs = std::filesystem;

// Empty if files can be written into the folder.
std::error_code why_not(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return std::make_error_code(std::errc::no_such_file_or_directory);
  if (!fs::is_directory(status)) return std::make_error_code(std::errc::not_a_directory);
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return {};
  return std::error_code(errno, std::generic_category());
}

}  // namespace

void require_not_the_data(const fs::path& file, const fs::path& data, const std::string& option) {
  std::error_code ignored;
  if (!fs::equivalent(file, data, ignored)) return;
  throw InputError({.where = option,
                    .what = fmt::format("'{}' would be written over the data", file.string()),
                    .expected = "another place"});
}

void require_folder_can_be_written(const fs::path& folder, const std::string& option) {
  std::error_code ignored;
  fs::path there = folder.empty() ? fs::path() : fs::absolute(folder);
  while (there.has_relative_path() && !fs::exists(there, ignored)) there = there.parent_path();
  const std::error_code error = why_not(there);
  if (!error) return;
  throw InputError(
      {.what = option,
       .value = folder.string(),
       .expected = fmt::format("a folder that can be written to: {}", error.message())});
}

void require_file_can_be_written(const fs::path& file, const std::string& option) {
  const std::error_code error =
      why_not(file.has_parent_path() ? file.parent_path() : fs::path("."));
  if (error) {
    throw InputError({.what = option,
                      .value = file.string(),
                      .expected = fmt::format("a file in a folder that can be written to: {}",
                                              error.message())});
  }
  std::error_code ignored;
  if (file.has_filename() && !fs::is_directory(file, ignored)) return;
  throw InputError(
      {.what = option, .value = file.string(), .expected = "the name of a file, not a folder"});
}

}  // namespace reeve::cli
