#include "cli/printing.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/terminal.hpp"
#include "reports/document/sheet_latex.hpp"
#include "reports/document/sheet_markdown.hpp"
#include "reports/document/sheet_text.hpp"

namespace reeve::cli {
namespace {

Look look() {
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

std::string printed(const Sheet& sheet, const FormatOption& format, double width) {
  if (format.is("markdown")) return markdown(sheet);
  if (format.is("latex")) return latex(sheet, width);
  Look shown = look();
  if (width > 0) shown.width = static_cast<std::size_t>(width);
  return text(sheet, shown);
}

std::string announced(const std::string& files, const std::filesystem::path& folder,
                      const FormatOption& format) {
  if (!format.is("table")) return "";
  std::vector<SheetLine> lines{{fmt::format("Written: {} in {}", files, folder.string())}};
  const std::string page = page_line(folder);
  if (!page.empty()) lines.push_back({page});
  return "\n" + text(Sheet{{{"", std::nullopt, lines}}}, look());
}

std::string page_line(const std::filesystem::path& folder) {
  const std::filesystem::path page = folder / "index.html";
  std::error_code ignored;
  return std::filesystem::exists(page, ignored) ? "Page: " + page.string() : "";
}

}  // namespace reeve::cli
