#include "cli/flags/table_flags.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <iostream>
#include <optional>
#include <string_view>

#include "cli/printing.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/document/document_latex.hpp"

namespace reeve::cli {
namespace {

struct LengthUnit {
  std::string_view name;
  double pt;
};
constexpr std::array length_units{LengthUnit{"mm", pt_in_mm}, LengthUnit{"cm", 10 * pt_in_mm},
                                  LengthUnit{"in", 72.27}, LengthUnit{"pt", 1}};

std::optional<double> positive_number(std::string_view text) {
  const auto number = number_in(text);
  return number && *number > 0 ? number : std::nullopt;
}

std::optional<double> length_pt(std::string_view text) {
  for (const LengthUnit& unit : length_units) {
    if (!text.ends_with(unit.name)) continue;
    const auto number = positive_number(text.substr(0, text.size() - unit.name.size()));
    if (number) return *number * unit.pt;
  }
  return std::nullopt;
}

bool is_table(const FormatOption& format) {
  return format.is("table") || format.is("markdown") || format.is("latex");
}

}  // namespace

void TableFlags::add_to(CLI::App& command, const std::string& list) {
  columns.add(
      command, "--columns",
      "Columns of " + list + ", in this order, such as name,routing; prints no other table");
  text_width.add(
      command, "--text-width",
      "Greatest width of tables in characters; with --format latex a length such as 88mm");
}

ListColumns TableFlags::read_columns(const FormatOption& format,
                                     const std::vector<std::string>& known,
                                     const std::vector<MissingColumns>& missing) const {
  ListColumns wanted{{}, format.is("latex")};
  if (!columns.is_given()) return wanted;
  if (!is_table(format)) {
    throw InputError({.where = "--columns '" + columns.text + "'",
                      .what = "--format " + format.format + " has every column",
                      .expected = "--format table, markdown or latex with it",
                      .form = InputForm::unknown});
  }
  if (columns.text.find_first_not_of(", \t") == std::string::npos) {
    throw InputError(
        {.what = "--columns",
         .value = columns.text,
         .expected = fmt::format("names of columns with commas between them, any of {}",
                                 fmt::join(known, ", "))});
  }
  wanted.chosen = for_name("--", [&] { return parse_columns(columns.text, known, missing); });
  return wanted;
}

double TableFlags::read_width(const FormatOption& format) const {
  if (!text_width.is_given()) return 0;
  constexpr double least_pt = 20 * pt_in_mm;
  constexpr double most_pt = 2000 * pt_in_mm;
  const auto fail = [&](const std::string& expected) -> double {
    throw InputError({.what = "--text-width", .value = text_width.text, .expected = expected});
  };
  if (format.is("latex")) {
    const auto length = length_pt(text_width.text);
    return length && *length >= least_pt && *length <= most_pt
               ? *length
               : fail("a length from 20mm to 2000mm with its unit, mm, cm, in or pt, such as 88mm");
  }
  if (!format.is("table")) return fail("--format table or latex with it");
  const auto characters = positive_number(text_width.text);
  const bool whole = characters && *characters == static_cast<int>(*characters);
  return whole && *characters >= 20 && *characters <= 1000
             ? *characters
             : fail(
                   "a whole number of characters from 20 to 1000; a length goes with --format "
                   "latex");
}

void TableFlags::require_room(const FormatOption& format,
                              const std::function<Document()>& shortest) const {
  const double width = read_width(format);
  if (format.is("latex") && width > 0) require_fits(shortest(), width);
}

std::string TableFlags::printed(const Document& document, const FormatOption& format) const {
  const double width = read_width(format);
  if (format.is("latex") && width > 0 && least_width_pt(document) > width) {
    std::cerr << fmt::format(
        "reeve: a table is wider than --text-width '{}': it takes {:.0f}mm; fewer --columns take "
        "less\n",
        text_width.text, std::ceil(least_width_pt(document) / pt_in_mm));
  }
  return cli::printed(document, format, width);
}

}  // namespace reeve::cli
