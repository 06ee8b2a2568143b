#include "catalog/catalogue_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "core/error.hpp"

namespace reeve::catalog {
namespace {

constexpr std::string_view toml_ending = ".toml";

std::vector<std::string> embedded_in(const std::string& folder) {
  const std::string start = folder.empty() ? "" : folder + "/";
  std::vector<std::string> paths;
  for (const auto& [path, text] : embedded_catalogue()) {
    if (!path.starts_with(start) || !path.ends_with(toml_ending)) continue;
    if (path.find('/', start.size()) == std::string_view::npos) paths.emplace_back(path);
  }
  return paths;
}

std::vector<std::string> folders_embedded_in(const std::string& folder) {
  const std::string start = folder + "/";
  std::vector<std::string> names;
  for (const auto& [path, text] : embedded_catalogue()) {
    if (!path.starts_with(start)) continue;
    const std::size_t end = path.find('/', start.size());
    if (end == std::string_view::npos) continue;
    std::string name(path.substr(start.size(), end - start.size()));
    if (names.empty() || names.back() != name) names.push_back(std::move(name));
  }
  return names;
}

[[noreturn]] void fail_unreadable(const std::filesystem::path& folder,
                                  const std::error_code& error) {
  require_memory(error);
  throw InputError({.where = fmt::format("catalogue {}", folder.string()),
                    .what = fmt::format("cannot be read: {}", error.message())});
}

std::vector<std::string> folders_lying_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  std::filesystem::directory_iterator at(folder, error);
  if (error == std::errc::no_such_file_or_directory) return names;
  const std::filesystem::directory_iterator end;
  for (; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->is_directory(ignored)) names.push_back(at->path().filename().string());
  }
  if (error) fail_unreadable(folder, error);
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> lying_in(const std::filesystem::path& catalogue,
                                  const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  std::filesystem::directory_iterator at(catalogue / folder, error);
  if (error == std::errc::no_such_file_or_directory && !folder.empty()) return paths;
  const std::filesystem::directory_iterator end;
  for (; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->path().extension() == toml_ending && !at->is_directory(ignored)) {
      paths.push_back((folder / at->path().filename()).string());
    }
  }
  if (error) fail_unreadable(catalogue, error);
  if (paths.empty() && folder.empty()) {
    throw InputError({.where = fmt::format("catalogue {}", catalogue.string()),
                      .what = "has no file *.toml",
                      .expected = "one for each routing"});
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace

CatalogueFiles CatalogueFiles::built_in() { return {}; }

CatalogueFiles CatalogueFiles::in(const std::filesystem::path& folder) {
  CatalogueFiles files;
  files.folder_ = folder;
  return files;
}

CatalogueFiles CatalogueFiles::shipped() {
  const char* chosen = std::getenv("REEVE_CATALOG");
  return chosen != nullptr && *chosen != '\0' ? in(chosen) : built_in();
}

std::vector<TomlNode> CatalogueFiles::toml(const std::string& folder) const {
  std::vector<TomlNode> files;
  for (const std::string& path :
       folder_.empty() ? embedded_in(folder) : lying_in(folder_, folder)) {
    const CatalogueFile file = find(path);
    files.push_back(file.text ? parse_toml(*file.text, file.name) : read_toml(file.name));
  }
  return files;
}

std::vector<std::string> CatalogueFiles::folders(const std::string& folder) const {
  return folder_.empty() ? folders_embedded_in(folder) : folders_lying_in(folder_ / folder);
}

CatalogueFile CatalogueFiles::find(const std::string& path) const {
  if (!folder_.empty()) return {(folder_ / path).string(), std::nullopt};
  const auto found = embedded_catalogue().find(path);
  if (found == embedded_catalogue().end()) {
    throw InputError({.where = path, .what = "is not in the built-in catalogue"});
  }
  return {"catalog/" + path, std::string(found->second)};
}

}  // namespace reeve::catalog
