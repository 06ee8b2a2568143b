// Writes the files of --out: the folder holds one result, the earlier or this one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pages/shell/figure_files.hpp"
#include "reports/output/stamp.hpp"

namespace reeve::pages {

struct ResultFile {
  std::string name;
  std::optional<std::string> text;  // none: that of an earlier run is removed
};

// In the order in which they appear.
struct ResultFiles {
  std::vector<ResultFile> tables;
  std::optional<std::vector<FigureFile>> figures;  // none: the command draws none
  std::vector<ResultFile> texts;                   // the last of them says that all are there
};

// Writes them as one batch (files.hpp), each with the stamp. Throws InputError.
void write_result(const std::filesystem::path& folder, ResultFiles result, const Stamp& stamp);

// Writes index.html with its figures, the tables before it, and the JSON that has the stamp.
void write_result(const std::filesystem::path& folder, PageFiles page, const ResultFile& json,
                  std::vector<ResultFile> tables = {});

}  // namespace reeve::pages
