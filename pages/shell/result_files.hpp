// Writes the files of --out: the folder holds one result, the earlier or this one, whichever
// commands they are of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pages/shell/figure_files.hpp"
#include "reports/output/stamp.hpp"

namespace reeve::pages {

struct ResultFile {
  std::string name;
  std::string text;
};

// In the order in which they appear.
struct ResultFiles {
  std::vector<ResultFile> tables;
  std::vector<FigureFile> figures;
  std::vector<ResultFile> texts;  // the last of them says that all are there
};

// All that commands leave in such a folder, beside figures: written or removed by each.
std::vector<std::string> result_names();

// Writes them as one batch (files.hpp), each with the stamp, and removes what an earlier result has
// besides. Throws InputError.
void write_result(const std::filesystem::path& folder, ResultFiles result, const Stamp& stamp);

// Writes index.html with its figures, the tables before it, and the JSON that has the stamp.
void write_result(const std::filesystem::path& folder, PageFiles page, const ResultFile& json,
                  std::vector<ResultFile> tables = {});

}  // namespace reeve::pages
