#include "diagnosis/data/intake/beginning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "diagnosis/data/intake/column_units.hpp"

namespace reeve::diagnosis {
namespace {

std::ptrdiff_t names_known_in(const CsvRow& row, const ReadingOptions& options) {
  return std::count_if(row.fields.begin(), row.fields.end(), [&](std::string_view field) {
    return try_column_named(meaning_of(std::string(trimmed(field)), options)).has_value();
  });
}

// The line below may be the header, and this one a logger's names of its channels.
void require_header_first(const CsvReader& csv, const CsvRow& row, const ReadingOptions& options) {
  const CsvRow& header = csv.header();
  if (names_known_in(header, options) > 0 || names_known_in(row, options) < 2) return;
  throw InputError(
      {.where = fmt::format("{}:{}", csv.name(), header.line),
       .what = fmt::format("no name in this line is one of a column, and line {} has such names",
                           row.line),
       .expected = "the header first: take this line out, or begin it with #"});
}

}  // namespace

Beginning read_beginning(CsvReader& csv, const ReadingOptions& options, FaultList& faults) {
  Beginning result;
  try {
    CsvRow row;
    if (!csv.next(row)) return result;
    (is_units_row(csv.header(), row, options) ? result.units : result.first) = std::move(row);
  } catch (const InputError& error) {
    result.is_broken = true;
    faults.add(csv.header().line + 1, "where the rest cannot be read", error.fault());
  }
  if (result.first) require_header_first(csv, *result.first, options);
  return result;
}

void each_row(CsvReader& csv, const Beginning& beginning, FaultList& faults,
              const std::function<void(const CsvRow&)>& read) {
  if (beginning.is_broken) return;
  CsvRow row;
  if (beginning.first) read(*beginning.first);
  try {
    while (csv.next(row)) read(row);
  } catch (const InputError& error) {
    faults.add(row.line + 1, "where the rest cannot be read", error.fault());
  }
}

void require_rows(const CsvReader& csv, std::size_t rows, const std::vector<DataNote>& notes) {
  if (rows > 0) return;
  const bool zeros = std::any_of(notes.begin(), notes.end(),
                                 [](const DataNote& note) { return note.kind == NoteKind::tare; });
  throw InputError({.where = fmt::format("{}:{}", csv.name(), csv.header().line),
                    .expected = zeros ? "readings below the header, and there are rows of zeros "
                                        "(tare) alone"
                                      : "rows below the header, and there are none"});
}

}  // namespace reeve::diagnosis
