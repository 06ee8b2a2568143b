#include "diagnosis/data/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/error.hpp"

namespace reeve::diagnosis {
namespace {

[[noreturn]] void fail_too_large(const std::string& name) {
  throw InputError({.where = name,
                    .what = "is larger than 512 MiB",
                    .expected = "a CSV file with one row per reading"});
}

// In pieces, since what is no regular file (a pipe) does not tell its size.
std::string read_stream(std::istream& in, const std::string& name) {
  std::string text;
  std::string piece(std::size_t{1} << 20, '\0');
  while (in) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece, 0, static_cast<std::size_t>(in.gcount()));
    if (text.size() > max_csv_size) fail_too_large(name);
  }
  if (in.bad()) throw InputError({.where = name, .what = "cannot be read to its end"});
  return text;
}

std::string read_file(const std::filesystem::path& path, const std::string& name) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw InputError({.where = name, .what = "is a directory", .expected = "a CSV file"});
  }
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw InputError(
        {.where = name, .what = fmt::format("cannot be read: {}", std::strerror(errno))});
  }
  if (std::filesystem::is_regular_file(path, error) &&
      std::filesystem::file_size(path, error) > max_csv_size && !error) {
    fail_too_large(name);
  }
  return read_stream(in, name);
}

}  // namespace

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; }, '?');
  return text;
}

std::string for_message(std::string_view text) {
  constexpr std::size_t most = 40;
  std::size_t end = std::min(text.size(), most);
  // Not in the middle of a UTF-8 character.
  while (end < text.size() && end > 0 && (text[end] & '\xC0') == '\x80') --end;
  const std::string shown = one_line(std::string(text.substr(0, end)));
  return end < text.size() ? shown + "…" : shown;
}

CsvReader::CsvReader(std::string text, std::string name)
    : text_(std::move(text)), name_(std::move(name)) {
  if (text_.starts_with("\xEF\xBB\xBF")) at_ = line_begin_ = 3;
  require_no_nul();
  if (!at_row()) {
    throw InputError(
        {.where = name_, .what = "is empty", .expected = "a header and rows below it"});
  }
  separator_ = find_separator();
  read_row(header_);
  columns_ = header_.fields.size();
}

CsvReader CsvReader::open(const std::filesystem::path& path) {
  const std::string name = path.string();
  return {read_file(path, name), name};
}

bool CsvReader::next(CsvRow& row) {
  if (!at_row()) return false;
  read_row(row);
  return true;
}

void CsvReader::fail(Place place, std::string what, std::string expected) const {
  throw InputError({.where = fmt::format("{}:{}:{}", name_, place.line, place.column),
                    .what = std::move(what),
                    .expected = std::move(expected)});
}

void CsvReader::require_no_nul() {
  const std::size_t nul = text_.find('\0');
  if (nul == std::string::npos) return;
  const std::string_view before = std::string_view(text_).substr(line_begin_, nul - line_begin_);
  const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t last = before.rfind('\n');
  const std::size_t column =
      last == std::string_view::npos ? nul + 1 - line_begin_ : before.size() - last;
  fail({lines + 1, column}, "a NUL byte", "text in UTF-8 (UTF-16 must be converted)");
}

char CsvReader::find_separator() const {
  std::size_t commas = 0, semicolons = 0, tabs = 0;
  bool quoted = false;
  for (std::size_t i = at_; i < text_.size(); ++i) {
    const char c = text_[i];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '\n') break;
    commas += c == ',' ? 1 : 0;
    semicolons += c == ';' ? 1 : 0;
    tabs += c == '\t' ? 1 : 0;
  }
  if (commas > 0 && semicolons > 0) {
    fail(here(),
         fmt::format("the header has {} commas and {} semicolons outside quotes", commas,
                     semicolons),
         "one of them, as separator");
  }
  if (commas == 0 && semicolons == 0 && tabs > 0) {
    fail(here(), "the header has tabs", "commas or semicolons as separator");
  }
  return semicolons > 0 ? ';' : ',';
}

std::string CsvReader::as_many_as_the_header() const {
  return fmt::format("{}, as many as the header in line {} has", columns_, header_.line);
}

// Passes comments and empty lines.
bool CsvReader::at_row() {
  while (at_ < text_.size()) {
    if (text_[at_] == '#') {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      comments_.push_back({line_, text_.substr(at_ + 1, end - at_ - 1)});
      at_ = end;
    } else if (!at_line_end()) {
      return true;
    }
    if (at_ < text_.size()) end_line();
  }
  return false;
}

void CsvReader::read_row(CsvRow& row) {
  row.line = line_;
  std::size_t count = 0;
  do {
    if (count == row.fields.size()) row.fields.emplace_back();
    read_field(row.fields[count++]);
  } while (take_separator(count));
  row.fields.resize(count);
  if (columns_ != 0 && count != columns_) {
    fail(here(), fmt::format("the row ends after {} {}", count, count == 1 ? "field" : "fields"),
         as_many_as_the_header());
  }
  if (at_ < text_.size()) end_line();
}

// Leaves the reader at a separator or a line end.
void CsvReader::read_field(std::string& field) {
  if (at_ < text_.size() && text_[at_] == '"') return read_quoted(field);
  const std::size_t begin = at_;
  while (at_ < text_.size() && text_[at_] != separator_ && text_[at_] != '\n' &&
         text_[at_] != '\r') {
    if (text_[at_] == '"') {
      fail(here(), "a quote inside a field", "the whole field in quotes, and the quote twice");
    }
    ++at_;
  }
  field.assign(text_, begin, at_ - begin);
}

void CsvReader::read_quoted(std::string& field) {
  const Place opening = here();
  field.clear();
  for (++at_;; ++at_) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '"') {
      if (text_[at_++] != '\n') continue;
      ++line_;
      line_begin_ = at_;
    }
    field.append(text_, begin, at_ - begin);
    if (at_ == text_.size()) fail(opening, "the quote is not closed", "another one");
    if (++at_ == text_.size() || text_[at_] != '"') break;
    field += '"';
  }
  if (at_ < text_.size() && text_[at_] != separator_ && !at_line_end()) {
    fail(here(), fmt::format("'{}' behind the closing quote", for_message(text_.substr(at_, 1))),
         fmt::format("'{}' or the end of the line", separator_));
  }
}

bool CsvReader::at_line_end() const {
  return text_[at_] == '\n' ||
         (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n');
}

void CsvReader::end_line() {
  at_ += text_[at_] == '\r' ? 2 : 1;
  ++line_;
  line_begin_ = at_;
}

// Stops early in a row that is too long, however long it is.
bool CsvReader::take_separator(std::size_t fields) {
  if (at_ == text_.size() || at_line_end()) return false;
  if (text_[at_] == '\r') fail(here(), "a carriage return alone", "LF or CRLF at line ends");
  ++at_;
  if (fields == max_csv_columns) {
    fail(here(), "a further field", fmt::format("at most {}", max_csv_columns));
  }
  if (fields == columns_) fail(here(), "a further field", as_many_as_the_header());
  return true;
}

}  // namespace reeve::diagnosis
