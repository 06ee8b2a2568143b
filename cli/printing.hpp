// Results on stdout: as text that fits the terminal, or as Markdown or LaTeX.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/inputs.hpp"
#include "reports/document/document.hpp"

namespace reeve::cli {

// The formats of what prints a document: "table", these, "markdown" and "latex".
std::vector<std::string> with_tables(const std::vector<std::string>& others);

// In the format that was asked for, one of table, markdown and latex.
// `width`: of the text in characters, with latex in pt; 0: as wide as the terminal, or any.
std::string printed(const Document& document, const FormatOption& format, double width = 0);

// Lists the files in the folder, and the place of the page among them. Only beside a table, where
// nobody takes it for a part of the result; otherwise "".
std::string announced(const std::string& files, const std::filesystem::path& folder,
                      const FormatOption& format);

// "Page: out/explore/index.html"; "" if there is none in the folder.
std::string page_line(const std::filesystem::path& folder);

}  // namespace reeve::cli
