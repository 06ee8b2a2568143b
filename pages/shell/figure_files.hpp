// The figures of a page as files, and a sentence beside each that can stand below it in a paper.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "numerics/floors.hpp"
#include "reports/output/files.hpp"
#include "reports/output/stamp.hpp"

namespace reeve::pages {

struct FigureFile {
  std::string id;  // unique, even if case does not count
  std::string svg;
  std::string caption{};  // "": none is written
};

struct PageFiles {
  std::string html;
  std::vector<FigureFile> figures;
};

// Adds figures/ID.svg and figures/ID.txt to the batch, and removes what an earlier run wrote there
// and this one did not: what lies in the folder then belongs to one result. Files of others stay;
// which are ours stands in figures/.reeve, before them and after them. Throws InputError.
void add_figures(FileBatch& batch, const std::filesystem::path& directory,
                 const std::vector<FigureFile>& figures, const Stamp& stamp);

}  // namespace reeve::pages
