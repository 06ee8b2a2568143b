#include "cli/outputs.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/error.hpp"
#include "pages/shell/result_files.hpp"
#include "reports/output/destination.hpp"

namespace reeve::cli {
namespace {

namespace fs = std::filesystem;

// The folder itself, or what there is of the way to it; empty if a file could lie there.
std::error_code why_not(fs::path folder) {
  struct stat status = {};
  while (::stat(folder.c_str(), &status) != 0) {
    const std::error_code error(errno, std::generic_category());
    const bool is_link = ::lstat(folder.c_str(), &status) == 0;
    if (error != std::errc::no_such_file_or_directory || is_link || !folder.has_relative_path())
      return error;
    folder = folder.has_filename() ? folder.parent_path() : folder.parent_path().parent_path();
    if (folder.empty()) folder = ".";
  }
  if (!S_ISDIR(status.st_mode)) return std::make_error_code(std::errc::not_a_directory);
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return {};
  return {errno, std::generic_category()};
}

// A device or a pipe loses nothing by what is written to it.
bool can_be_lost(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  return fs::is_regular_file(status) || !fs::exists(status);
}

fs::path where_links_lead(const fs::path& file) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(destination(file).file, ignored), ignored);
}

bool are_the_same(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored) || where_links_lead(a) == where_links_lead(b);
}

[[noreturn]] void refuse(const fs::path& file, const InputFile& input, const std::string& option) {
  throw InputError({.where = option,
                    .what = fmt::format("'{}' would be written over {}", file.string(), input.what),
                    .expected = "another place"});
}

}  // namespace

void TextOption::claim(const std::string& name, std::vector<InputFile>& taken) const {
  if (!is_given()) return;
  require_file_can_be_written(text, name);
  require_not_an_input(text, taken, name);
  list_in(taken, "the file of " + name);
}

void require_not_an_input(const fs::path& file, const std::vector<InputFile>& inputs,
                          const std::string& option) {
  for (const InputFile& input : inputs) {
    if (can_be_lost(input.file) && are_the_same(file, input.file)) refuse(file, input, option);
  }
}

void require_no_input_in(const fs::path& folder, const std::vector<InputFile>& inputs) {
  const std::string option = fmt::format("--out '{}'", folder.string());
  for (const std::string& file : result_names()) {
    require_not_an_input(folder / file, inputs, option);
  }
  // The names of the figures are known only when they are made.
  const fs::path figures = folder / "figures";
  require_not_an_input(figures, inputs, option);
  for (const InputFile& input : inputs) {
    const fs::path place = where_links_lead(input.file);
    if (!can_be_lost(input.file) || !are_the_same(figures, place.parent_path())) continue;
    refuse(figures / place.filename(), input, option);
  }
}

void require_folder_can_be_written(const fs::path& folder, const std::string& option) {
  const std::error_code error =
      folder.empty() ? std::make_error_code(std::errc::no_such_file_or_directory) : why_not(folder);
  if (!error) return;
  throw InputError(
      {.what = option,
       .value = folder.string(),
       .expected = fmt::format("a folder that can be written to: {}", error.message())});
}

void require_file_can_be_written(const fs::path& file, const std::string& option) {
  const std::error_code error = destination(file).error;
  if (!error) return;
  const bool names_a_folder = !file.has_filename() || error == std::errc::is_a_directory;
  throw InputError({.what = option,
                    .value = file.string(),
                    .expected = names_a_folder ? "the name of a file, not a folder"
                                               : fmt::format("a file that can be written: {}",
                                                             error.message())});
}

}  // namespace reeve::cli
