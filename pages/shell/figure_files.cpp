#include "pages/shell/figure_files.hpp"

#include <fstream>
#include <set>

namespace reeve::pages {
namespace {

constexpr const char* list_name = ".reeve";

// A line that is no plain file name is none of ours: the list may have been tampered with.
std::set<std::string> listed(const std::filesystem::path& folder) {
  std::set<std::string> names;
  std::ifstream list(folder / list_name);
  list.exceptions(std::ios::badbit);  // where there is no memory
  for (std::string name; std::getline(list, name);) {
    const bool is_plain = std::filesystem::path(name).filename() == name;
    if (is_plain && (name.ends_with(".svg") || name.ends_with(".txt"))) names.insert(name);
  }
  return names;
}

}  // namespace

void add_figures(FileBatch& batch, const std::filesystem::path& directory,
                 const std::vector<FigureFile>& figures) {
  const std::filesystem::path folder = directory / "figures";
  prepare_directory(folder, "--out");
  std::set<std::string> stale = listed(folder);
  std::string names;
  const auto write = [&](const std::string& name, const std::string& content) {
    batch.add(folder / name, content);
    stale.erase(name);
    names += name + "\n";
  };
  for (const FigureFile& figure : figures) {
    write(figure.id + ".svg", figure.svg);
    if (!figure.caption.empty()) write(figure.id + ".txt", figure.caption);
  }
  for (const std::string& name : stale) batch.remove(folder / name);
  batch.add(folder / list_name, names);
}

void write_figures(const std::filesystem::path& directory, const std::vector<FigureFile>& figures) {
  FileBatch batch;
  add_figures(batch, directory, figures);
  batch.commit();
}

}  // namespace reeve::pages
