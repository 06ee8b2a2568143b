#include "pages/shell/figure_files.hpp"

#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/input_file.hpp"

namespace reeve::pages {
namespace {

constexpr const char* list_name = ".reeve";
constexpr std::size_t longest_list = std::size_t{1} << 24;

// A line that is no plain file name is none of ours: the list may have been tampered with.
std::set<std::string> listed(const std::filesystem::path& folder) {
  std::set<std::string> names;
  const std::filesystem::path file = folder / list_name;
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (!std::filesystem::exists(status)) return names;
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError({.where = file.string(), .expected = "the list of reeve's figures, a file"});
  }
  std::istringstream list(read_input(file, longest_list, "the list of reeve's figures"));
  list.exceptions(std::ios::badbit);  // throws if memory runs out
  for (std::string name; std::getline(list, name);) {
    const bool is_plain = std::filesystem::path(name).filename() == name;
    if (is_plain && (name.ends_with(".svg") || name.ends_with(".txt"))) names.insert(name);
  }
  return names;
}

}  // namespace

void add_figures(FileBatch& batch, const std::filesystem::path& directory,
                 const std::vector<FigureFile>& figures, const Stamp& stamp) {
  const std::filesystem::path folder = directory / "figures";
  std::set<std::string> stale = listed(folder);
  if (figures.empty() && stale.empty()) return;
  prepare_directory(folder, "--out");
  std::vector<std::pair<std::string, std::string>> files;
  for (const FigureFile& figure : figures) {
    const std::string drawing = figure.id + ".svg";
    files.emplace_back(drawing, stamped(drawing, figure.svg, stamp));
    if (!figure.caption.empty()) files.emplace_back(figure.id + ".txt", figure.caption);
  }
  std::string names;
  for (const auto& [name, text] : files) {
    stale.erase(name);
    names += name + "\n";
  }
  batch.add(folder / list_name, names);
  for (const auto& [name, text] : files) batch.add(folder / name, text);
  for (const std::string& name : stale) batch.remove(folder / name);
}

}  // namespace reeve::pages
