// The figures of a page as files, and a sentence beside each that can stand below it in a paper.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "numerics/floors.hpp"
#include "reports/files.hpp"

namespace reeve::pages {

struct FigureFile {
  std::string id;  // of no two the same, also where case does not count
  std::string svg;
  std::string caption{};  // "": none is written
};

// As write_figures, together with other files.
void add_figures(FileBatch& batch, const std::filesystem::path& directory,
                 const std::vector<FigureFile>& figures);

// Writes figures/ID.svg and figures/ID.txt, and removes what an earlier run wrote there and this
// one did not: what lies in the folder then belongs to one result. Files of others stay; which are
// ours stands in figures/.reeve. Throws InputError.
void write_figures(const std::filesystem::path& directory, const std::vector<FigureFile>& figures);

}  // namespace reeve::pages
