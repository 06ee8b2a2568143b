#include "cli/printing.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/terminal.hpp"
#include "reports/document/document_latex.hpp"

namespace reeve::cli {
namespace {

TextStyle look() {
  const Terminal out = terminal(STDOUT_FILENO);
  return {out.width, out.colour};
}

}  // namespace

std::vector<std::string> with_tables(const std::vector<std::string>& others) {
  std::vector<std::string> formats{"table"};
  formats.insert(formats.end(), others.begin(), others.end());
  formats.insert(formats.end(), {"markdown", "latex"});
  return formats;
}

std::string printed(const Document& document, const FormatOption& format, double width) {
  if (format.is("markdown")) return markdown(document);
  if (format.is("latex")) return latex(document, width);
  TextStyle shown = look();
  if (width > 0) shown.width = static_cast<std::size_t>(width);
  return text(document, shown);
}

std::string announced(const std::string& files, const std::filesystem::path& folder,
                      const FormatOption& format) {
  if (!format.is("table")) return "";
  std::vector<DocumentLine> lines{{fmt::format("Written: {} in {}", files, folder.string())}};
  const std::string page = page_line(folder);
  if (!page.empty()) lines.push_back({page});
  return "\n" + text(Document{{{"", std::nullopt, lines}}}, look());
}

std::string page_line(const std::filesystem::path& folder) {
  const std::filesystem::path page = folder / "index.html";
  std::error_code ignored;
  return std::filesystem::exists(page, ignored) ? "Page: " + page.string() : "";
}

}  // namespace reeve::cli
