#include "readings/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/input_file.hpp"
#include "core/text.hpp"
#include "readings/csv_header.hpp"

namespace reeve::readings {
namespace {

[[noreturn]] void fail_too_large(const std::string& name) {
  throw InputError({.where = name,
                    .what = "is larger than 512 MiB",
                    .expected = "a CSV file with one row per reading"});
}

std::string read_file(const std::filesystem::path& path, const std::string& name) {
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error) &&
      std::filesystem::file_size(path, error) > max_csv_size && !error) {
    fail_too_large(name);
  }
  std::string text = read_input(path, max_csv_size, "a CSV file");
  if (text.size() > max_csv_size) fail_too_large(name);
  return text;
}

// "the byte FC ('ü' in Latin-1)". Below A0 the encodings differ.
std::string byte_words(char c) {
  const auto byte = static_cast<unsigned char>(c);
  std::string words = fmt::format("the byte {:02X}", byte);
  if (byte < 0xA0) return words;
  const std::array character{static_cast<char>(0xC0 | byte >> 6),
                             static_cast<char>(0x80 | (byte & 0x3F))};
  return words +
         fmt::format(" ('{}' in Latin-1)", std::string_view(character.data(), character.size()));
}

// Makes the blanks of spreadsheets and web pages plain ones, and takes out characters of no width:
// nobody sees them in a name or a cell.
void make_blanks(std::string& field) {
  if (std::ranges::none_of(field, [](char c) { return (c & '\x80') != 0; })) return;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> invisible{
      {{"\u00A0", " "},
       {"\u202F", " "},
       {"\u2007", " "},
       {"\u2009", " "},
       {"\u200B", ""},
       {"\uFEFF", ""}}};
  std::string result;
  for (std::string_view rest = field; !rest.empty();) {
    const auto found = std::ranges::find_if(
        invisible, [&](const auto& each) { return rest.starts_with(each.first); });
    const bool is_plain = found == invisible.end();
    result += is_plain ? rest.substr(0, 1) : found->second;
    rest.remove_prefix(is_plain ? 1 : found->first.size());
  }
  field = std::move(result);
}

// Folds line breaks, as spreadsheets have them in names, to one blank each.
void fold_lines(std::string& name) {
  if (name.find('\n') == std::string::npos) return;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  const auto is_blank_twice = [](char a, char b) { return a == ' ' && b == ' '; };
  name.erase(std::unique(name.begin(), name.end(), is_blank_twice), name.end());
}

std::size_t words_in(std::string_view row) {
  std::istringstream words{std::string(row)};
  return static_cast<std::size_t>(std::distance(std::istream_iterator<std::string>(words),
                                                std::istream_iterator<std::string>()));
}

bool is_blank(const std::string& field) { return trimmed(field).empty(); }

}  // namespace

bool says_simulated(std::string_view text) {
  return lower(text).find("simulated") != std::string::npos;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; }, '?');
  for (std::size_t at = 0; const auto bad = first_not_utf8(std::string_view(text).substr(at));) {
    at += *bad;
    text[at] = '?';
  }
  return text;
}

std::string for_message(std::string_view text) {
  constexpr std::size_t most = 40;
  std::size_t end = std::min(text.size(), most);
  // Moves the cut out of the middle of a UTF-8 character.
  while (end < text.size() && end > 0 && (text[end] & '\xC0') == '\x80') --end;
  const std::string shown = one_line(std::string(text.substr(0, end)));
  return end < text.size() ? shown + "…" : shown;
}

std::string in_column(std::string_view column) {
  return fmt::format("in column '{}'", for_message(column));
}

InputError cell_error(const InputError& error, const std::string& file, std::size_t line,
                      std::string_view column, std::string_view text) {
  return InputError(changed(error.fault(), one_line))
      .at(InputFault{.where = fmt::format("{}:{}", file, line),
                     .what = fmt::format("column '{}'", for_message(column)),
                     .value = for_message(text),
                     .form = InputForm::cell});
}

CsvReader::CsvReader(std::string text, std::string name)
    : text_(std::move(text)), name_(std::move(name)) {
  if (text_.starts_with("\xEF\xBB\xBF")) at_ = line_begin_ = 3;
  require_text();
  read_header();
}

CsvReader CsvReader::open(const std::filesystem::path& path) {
  const std::string name = path.string();
  return {read_file(path, name), name};
}

void CsvReader::read_titles(std::size_t header) {
  while (at_row() && at_ < header) {
    const std::string_view title = csv_row_at(text_, at_);
    titles_.push_back({line_, one_line(std::string(trimmed(without_carriage_return(title))))});
    line_ += static_cast<std::size_t>(std::count(title.begin(), title.end(), '\n')) + 1;
    at_ = line_begin_ = std::min(at_ + title.size() + 1, text_.size());
  }
}

void CsvReader::read_header() {
  read_titles(header_begin(text_, at_));
  bool found = false;
  while (!found && at_row()) {
    separator_ = find_separator();
    found = read_row(header_);
  }
  if (!found) {
    throw InputError(
        {.where = name_, .what = "is empty", .expected = "a header and rows below it"});
  }
  std::ranges::for_each(header_.fields, fold_lines);
  columns_ = header_.fields.size();
  for (std::size_t i = 0; i < columns_; ++i) {
    if (!is_blank(header_.fields[i])) named_ = i + 1;
  }
}

bool CsvReader::next(CsvRow& row) {
  while (at_row()) {
    if (read_row(row)) return true;
  }
  return false;
}

InputFault CsvReader::fault(Place place, std::string what, std::string expected) const {
  return {.where = fmt::format("{}:{}:{}", name_, place.line, place.column),
          .what = std::move(what),
          .expected = std::move(expected)};
}

void CsvReader::fail(Place place, std::string what, std::string expected) const {
  throw InputError(fault(place, std::move(what), std::move(expected)));
}

// Before any row is read.
CsvReader::Place CsvReader::place_of(std::size_t at) const {
  const std::string_view before = std::string_view(text_).substr(line_begin_, at - line_begin_);
  const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t last = before.rfind('\n');
  return {lines + 1, last == std::string_view::npos ? at + 1 - line_begin_ : before.size() - last};
}

// Refuses what is no text, by the bytes that it begins with.
void CsvReader::require_no_archive() const {
  struct Format {
    std::string_view begin;
    const char* what;
    const char* expected;
  };
  constexpr const char* sheet = "its sheet saved as CSV";
  constexpr const char* unpacked = "the file unpacked";
  constexpr std::array formats{
      Format{"PK\x03\x04",
             "is a workbook of a spreadsheet (.xlsx, .ods or another zip archive), not text",
             sheet},
      Format{"\xD0\xCF\x11\xE0", "is a workbook of a spreadsheet (.xls), not text", sheet},
      Format{"\x1F\x8B", "is compressed (gzip)", unpacked},
      Format{"BZh9", "is compressed (bzip2)", unpacked},
  };
  for (const Format& format : formats) {
    if (!text_.starts_with(format.begin)) continue;
    throw InputError({.where = name_, .what = format.what, .expected = format.expected});
  }
}

void CsvReader::require_text() const {
  require_no_archive();
  const std::size_t nul = text_.find('\0');
  if (nul != std::string::npos) {
    fail(place_of(nul), "a NUL byte",
         "text in UTF-8. If the file is UTF-16, convert it by iconv -f UTF-16 -t UTF-8");
  }
  if (const auto bad = first_not_utf8(text_)) {
    fail(place_of(*bad), byte_words(text_[*bad]),
         "text in UTF-8. The file looks like Latin-1 or Windows-1252, as spreadsheets on Windows "
         "write: save it as 'CSV UTF-8', or convert it by iconv -f WINDOWS-1252 -t UTF-8");
  }
}

// `header` has no separator. A name may have blanks; three words in the row below as well are
// columns.
void CsvReader::require_no_aligned_columns(std::string_view header) const {
  const std::size_t below = std::min(at_ + header.size() + 1, text_.size());
  const bool has_bars = header.find('|') != std::string_view::npos;
  const bool has_blanks = words_in(header) > 2 && words_in(csv_row_at(text_, below)) > 2;
  if (!has_bars && !has_blanks) return;
  fail(here(), fmt::format("columns are separated by {}", has_bars ? "bars (|)" : "blanks"),
       "commas, semicolons or tabs");
}

char CsvReader::find_separator() const {
  const std::string_view row = csv_row_at(text_, at_);
  const SeparatorCounts counts = separators_of(row);
  if (counts.commas + counts.semicolons + counts.tabs == 0) require_no_aligned_columns(row);
  if (counts.is_ambiguous()) {
    fail(here(),
         fmt::format("the header has {} commas and {} semicolons outside quotes", counts.commas,
                     counts.semicolons),
         "one of them, as separator");
  }
  return counts.separator();
}

InputFault CsvReader::ragged(Place place, std::size_t fields) const {
  return fault(place, fmt::format("{} {}", fields, fields == 1 ? "field" : "fields"),
               fmt::format("{}, as many as the header in line {} has", columns_, header_.line));
}

// Passes comments and empty lines.
bool CsvReader::at_row() {
  while (at_ < text_.size()) {
    if (text_[at_] == '#') {
      const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
      comments_.push_back({line_, text_.substr(at_ + 1, end - at_ - 1)});
      at_ = end;
      if (at_ < text_.size()) require_line_end();
    } else if (!at_line_end()) {
      return true;
    }
    if (at_ < text_.size()) end_line();
  }
  return false;
}

// False if no field has anything in it. However long a row is, no more fields than the header has
// are kept.
bool CsvReader::read_row(CsvRow& row) {
  row.line = line_;
  row.ragged.reset();
  std::size_t count = 0;
  std::size_t filled = 0;  // up to the last field that is not blank
  std::optional<Place> beyond_begin;
  std::string beyond;
  do {
    const Place begin = here();
    const bool kept = columns_ == 0 || count < columns_;
    if (kept && count == row.fields.size()) row.fields.emplace_back();
    std::string& field = kept ? row.fields[count] : beyond;
    read_field(field);
    make_blanks(field);
    ++count;
    if (!is_blank(field)) {
      filled = count;
      if (!kept && !beyond_begin) beyond_begin = begin;
    }
    if (columns_ == 0 && count > max_csv_columns) {
      fail(begin, "a further field", fmt::format("at most {}", max_csv_columns));
    }
  } while (take_separator());
  if (beyond_begin) row.ragged = ragged(*beyond_begin, filled);
  if (columns_ != 0 && count < named_) row.ragged = ragged(here(), count);
  row.fields.resize(columns_ == 0 ? count : columns_);
  for (std::size_t i = count; i < row.fields.size(); ++i) row.fields[i].clear();
  if (at_ < text_.size()) end_line();
  return filled > 0;
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

bool CsvReader::take_separator() {
  if (at_ == text_.size() || at_line_end()) return false;
  if (text_[at_] == '\r') require_line_end();
  ++at_;
  return true;
}

void CsvReader::require_line_end() const {
  if (!at_line_end()) fail(here(), "a carriage return alone", "LF or CRLF at line ends");
}

namespace {

// Most cells are numbers, and a log has millions of them; 1.#INF is none.
bool begins_as_a_number(std::string_view text) {
  constexpr std::string_view digits = "0123456789";
  return text.find_first_of(digits) == 0 && text.find('#') == std::string_view::npos;
}

}  // namespace

bool is_missing(std::string_view text) {
  if (begins_as_a_number(text)) return false;
  constexpr std::array words{"", "-", "--", "nan", "na", "n/a", "n.a.", "#n/a", "null"};
  return std::ranges::find(words, lower(text)) != words.end();
}

bool is_no_number(std::string_view text) { return is_missing(text) || marks_an_error(text); }

bool marks_an_error(std::string_view text) {
  if (begins_as_a_number(text)) return false;
  constexpr std::array words{"#div/0!", "#wert!",    "#ref!",  "#value!",  "#name?",  "#num!",
                             "inf",     "-inf",      "+inf",   "infinity", "ovl",     "err",
                             "error",   "none",      "nat",    "n.v.",     "?",       "---",
                             "-nan",    "-nan(ind)", "1.#inf", "-1.#inf",  "1.#qnan", "-1.#ind"};
  return std::ranges::find(words, lower(text)) != words.end();
}

namespace {

// Dates and words are not.
bool is_of_digits(std::string_view text) {
  return text.find_first_not_of("0123456789+-eE.,") == std::string_view::npos;
}

// True of 17.190,000, 17'190, 17 190 and 1.234.567. One group alone, 17,190, may be a decimal mark.
bool has_thousands_mark(std::string_view text, bool one_group_is_enough) {
  // Matching recurses for each character.
  constexpr std::size_t longest = 40;
  if (text.size() > longest) return false;
  static const std::regex form(R"([+-]?[1-9]\d?\d?([.,' ])\d{3}(\1\d{3})*([.,]\d*)?)");
  std::cmatch found;
  if (!std::regex_match(text.begin(), text.end(), found, form)) return false;
  const bool is_no_decimal_mark = found[1] == "'" || found[1] == " ";
  return one_group_is_enough || is_no_decimal_mark || found[2].matched || found[3].matched;
}

}  // namespace

double CsvNumberReader::read(std::string_view text, std::size_t line, double low, double high,
                             bool may_be_empty) {
  std::string written(text);
  std::replace(written.begin(), written.end(), ',', '.');
  if (written.starts_with('+') && !written.starts_with("+-")) written.erase(0, 1);
  const std::optional<double> number = number_in(written);
  const bool is_quoted = between_commas_ && text.find(',') != std::string_view::npos;
  if ((!number || is_quoted) && has_thousands_mark(text, false)) {
    throw InputError({.expected = "a number without a thousands separator"});
  }
  if (is_quoted) {
    std::size_t& first = has_thousands_mark(text, true) ? doubtful_line_ : decimal_line_;
    if (first == 0) first = line;
  }
  require_one_mark(text, number.has_value(), line);
  if (number && *number >= low && *number <= high) return *number;
  if (std::isinf(high) && std::isinf(low)) {
    throw InputError({.expected = "a finite number such as 12.5, or an empty cell"});
  }
  throw InputError({.expected = fmt::format("a number from {} to {}{}", low, high,
                                            may_be_empty ? ", or an empty cell" : "")});
}

void CsvNumberReader::require_no_doubt() const {
  if (doubtful_line_ == 0 || decimal_line_ != 0) return;
  throw InputError(
      {.what = fmt::format("each comma in a number has three digits behind it (line {})",
                           doubtful_line_),
       .expected = "a number without a thousands separator, or decimal points"});
}

// A number such as 1.234,5 has both marks.
void CsvNumberReader::require_one_mark(std::string_view text, bool is_number, std::size_t line) {
  const bool comma = text.find(',') != std::string_view::npos;
  const bool point = text.find('.') != std::string_view::npos;
  if (!is_of_digits(text) || !(is_number ? comma || point : comma && point)) return;
  if (comma && comma_line_ == 0) comma_line_ = line;
  if (point && point_line_ == 0) point_line_ = line;
  require_mark_of(*this);
}

void CsvNumberReader::require_mark_of(const CsvNumberReader& other) const {
  const std::size_t comma_line = comma_line_ != 0 ? comma_line_ : other.comma_line_;
  const std::size_t point_line = point_line_ != 0 ? point_line_ : other.point_line_;
  if (comma_line == 0 || point_line == 0) return;
  throw InputError(
      {.what = fmt::format("the file has decimal commas (line {}) and decimal points (line {})",
                           comma_line, point_line),
       .expected = "one of them throughout"});
}

}  // namespace reeve::readings
