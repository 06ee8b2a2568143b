// Reads a CSV file (RFC 4180) row by row, and keeps line numbers, so that whoever reads the fields
// can name the place of what is wrong.
//
//   - The first row is the header, but for titles above it (csv_header.hpp); every other row has as
//   many fields as it. Separators behind the
//     last field are passed over: fields beyond the header must be blank, and a row may end before
//     columns that have no name.
//   - Fields may be quoted ("a ""quoted"" field"), over several lines too. A quote elsewhere in a
//     field is an error.
//   - Lines end with LF or CRLF. A UTF-8 byte order mark at the beginning is passed over.
//   - A line that begins with # is a comment (a first field that begins with # must be quoted);
//     lines that are empty or have nothing but separators are passed over.
//   - The separator is what the header has outside quotes: commas, semicolons, or else tabs. A
//     header with commas and semicolons is refused.
//   - A spreadsheet's own file is refused by name, and so is what is no UTF-8.
//
// Time is linear in the size. Errors are "file:line:column: …", columns counted in bytes from 1.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "numerics/floors.hpp"

namespace reeve::readings {

struct CsvRow {
  std::size_t line = 0;             // first line, from 1
  std::vector<std::string> fields;  // one for each column of the header
  // Set if the row has another number of them, and means nothing.
  std::optional<InputFault> ragged;
};

struct CsvComment {
  std::size_t line = 0;
  std::string text;  // text after the #, or of a title
};

// 512 MiB. A wrong path (a recording, a device) is refused, not swallowed.
inline constexpr std::size_t max_csv_size = std::size_t{1} << 29;
inline constexpr std::size_t max_csv_columns = 10000;

class CsvReader {
 public:
  // Both read the header, and throw InputError. `name` stands for the file in messages.
  CsvReader(std::string text, std::string name);
  static CsvReader open(const std::filesystem::path& path);

  const std::string& name() const { return name_; }
  char separator() const { return separator_; }
  const CsvRow& header() const { return header_; }
  // Returns the lines above the header that are no comments.
  const std::vector<CsvComment>& titles() const { return titles_; }
  // Returns the comments passed so far.
  const std::vector<CsvComment>& comments() const { return comments_; }

  // The next row below the header; false at the end. Keeps the memory of `row`. Throws InputError
  // where the rest of the file cannot be parted into fields.
  bool next(CsvRow& row);

 private:
  struct Place {
    std::size_t line = 1;
    std::size_t column = 1;
  };

  Place here() const { return {line_, at_ - line_begin_ + 1}; }
  InputFault fault(Place place, std::string what, std::string expected) const;
  [[noreturn]] void fail(Place place, std::string what, std::string expected) const;

  InputFault ragged(Place place, std::size_t fields) const;
  Place place_of(std::size_t at) const;
  void require_no_archive() const;
  void require_text() const;
  void require_no_aligned_columns(std::string_view header) const;
  char find_separator() const;
  bool at_row();
  void read_titles(std::size_t header);
  void read_header();
  bool read_row(CsvRow& row);
  void read_field(std::string& field);
  void read_quoted(std::string& field);
  bool at_line_end() const;
  void require_line_end() const;
  void end_line();
  bool take_separator();

  std::string text_;
  std::string name_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t line_begin_ = 0;
  char separator_ = ',';
  CsvRow header_;
  std::size_t columns_ = 0;  // 0 while the header is read
  std::size_t named_ = 0;    // up to the last column that has a name
  std::vector<CsvComment> titles_;
  std::vector<CsvComment> comments_;
};

// True if a comment marks the data as simulated: it has this word, in any case.
bool says_simulated(std::string_view text);

// Replaces control characters, which would break a line or change a terminal, and bytes that are
// not UTF-8.
std::string one_line(std::string text);
// The same, shortened to some forty bytes.
std::string for_message(std::string_view text);
// Key by which faults of one column are counted: "in column 'T1_N'".
std::string in_column(std::string_view column);
// Fault of a cell, with its place, its column and its text before it; on one line.
InputError cell_error(const InputError& error, const std::string& file, std::size_t line,
                      std::string_view column, std::string_view text);

// True for NaN, NA, n/a, - and other words for a missing number, and for an empty text.
bool is_missing(std::string_view text);

// True for those that a spreadsheet or a logger writes where something went wrong: #DIV/0!, inf,
// OVL.
bool marks_an_error(std::string_view text);

// True for both, in place of a number. As words they may mean something: a group "none".
bool is_no_number(std::string_view text);

// Numbers in the fields of a CSV file: decimal points, or decimal commas, which between commas
// stand in quotes. A file that has both is refused: 1,234 may then be a thousand or one and a bit.
class CsvNumberReader {
 public:
  explicit CsvNumberReader(char separator) : between_commas_(separator == ',') {}

  // A finite number from low to high. Throws InputError that says what was expected, and whether
  // the cell might be empty instead; the place is the caller's to name.
  double read(std::string_view text, std::size_t line, double low, double high,
              bool may_be_empty = true);

  // Throws InputError if each comma read in quotes may part thousands: "17,190".
  void require_no_doubt() const;
  // Throws InputError if the numbers read so far have the other mark than those of `other`.
  void require_mark_of(const CsvNumberReader& other) const;

 private:
  void require_one_mark(std::string_view text, bool is_number, std::size_t line);

  bool between_commas_;
  std::size_t comma_line_ = 0;  // first line with a decimal comma
  std::size_t point_line_ = 0;
  std::size_t doubtful_line_ = 0;  // with commas in quotes: the first with three digits behind
  std::size_t decimal_line_ = 0;   // … and the first with others
};

}  // namespace reeve::readings
