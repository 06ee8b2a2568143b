#include "readings/beginning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/text.hpp"
#include "readings/column_units.hpp"

namespace reeve::readings {
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

// Of files that were put together as they stand.
class RepeatedHeaders {
 public:
  void add(std::size_t line) {
    if (count_++ == 0) first_ = line;
  }

  // One fault, however many there are.
  void tell(const CsvReader& csv, FaultList& faults) const {
    if (count_ == 0) return;
    std::string what = fmt::format("line {} repeats the header", first_);
    if (count_ > 1) what += fmt::format(", and so do {} more", count_ - 1);
    faults.add(first_, "where the header is repeated",
               {.where = fmt::format("{}:{}", csv.name(), first_),
                .what = what,
                .expected = "one header at the beginning: where files were put together, take out "
                            "that of each but the first, and see that runs of different files "
                            "have names of their own"});
  }

 private:
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

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
  RepeatedHeaders repeated;
  const auto take = [&](const CsvRow& row) {
    if (row.fields == csv.header().fields) {
      repeated.add(row.line);
    } else {
      read(row);
    }
  };
  CsvRow row;
  if (beginning.first) take(*beginning.first);
  try {
    while (csv.next(row)) take(row);
  } catch (const InputError& error) {
    faults.add(row.line + 1, "where the rest cannot be read", error.fault());
  }
  repeated.tell(csv, faults);
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

}  // namespace reeve::readings
