#include "readings/csv_header.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <vector>

#include "core/text.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t most_rows = 64;

struct PlacedRow {
  std::size_t begin = 0;
  std::string_view text;
};

struct RowShape {
  std::size_t fields = 0;
  std::size_t filled = 0;  // up to the last field that is not blank
  bool has_number = false;
};

// The first rows; comments and empty lines are passed over.
std::vector<PlacedRow> first_rows(std::string_view text, std::size_t begin) {
  std::vector<PlacedRow> rows;
  while (begin < text.size() && rows.size() < most_rows) {
    // A comment may have an odd number of quotes.
    const std::string_view row = text[begin] == '#'
                                     ? text.substr(begin, text.find('\n', begin) - begin)
                                     : csv_row_at(text, begin);
    const std::string_view written = without_carriage_return(row);
    if (!row.starts_with('#') && !trimmed(written).empty()) rows.push_back({begin, written});
    begin += row.size() + 1;
  }
  return rows;
}

bool reads_as_number(std::string_view field) {
  std::string written(trimmed(field));
  std::replace(written.begin(), written.end(), ',', '.');  // between commas, it is in quotes
  if (written.starts_with('+')) written.erase(0, 1);
  const bool has_digit = std::any_of(written.begin(), written.end(),
                                     [](unsigned char c) { return std::isdigit(c) != 0; });
  return has_digit && number_in(written).has_value();
}

void add_field(std::string_view field, RowShape& shape) {
  ++shape.fields;
  if (field.size() > 1 && field.front() == '"') field = field.substr(1, field.size() - 2);
  if (!trimmed(field).empty()) shape.filled = shape.fields;
  shape.has_number = shape.has_number || reads_as_number(field);
}

RowShape shape_of(std::string_view row, char separator) {
  RowShape shape;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == '"') quoted = !quoted;
    if (quoted || row[i] != separator) continue;
    add_field(row.substr(begin, i - begin), shape);
    begin = i + 1;
  }
  add_field(row.substr(begin), shape);
  return shape;
}

// True if the row at `place` has no number and fits most rows of numbers below it.
bool is_header(const std::vector<PlacedRow>& rows, std::size_t place) {
  const SeparatorCounts counts = separators_of(rows[place].text);
  if (counts.is_ambiguous()) return false;
  const RowShape header = shape_of(rows[place].text, counts.separator());
  if (header.has_number || header.filled == 0) return false;
  std::size_t numbers = 0;
  std::size_t fitting = 0;
  for (std::size_t i = place + 1; i < rows.size(); ++i) {
    const RowShape row = shape_of(rows[i].text, counts.separator());
    if (!row.has_number) continue;
    ++numbers;
    if (row.filled <= header.filled && header.filled <= row.fields) ++fitting;
  }
  return 2 * fitting > numbers;
}

std::optional<std::size_t> header_from(const std::vector<PlacedRow>& rows, std::size_t place) {
  while (place < rows.size() && !is_header(rows, place)) ++place;
  return place < rows.size() ? std::optional(place) : std::nullopt;
}

std::size_t rows_of_numbers(const std::vector<PlacedRow>& rows, std::size_t begin,
                            std::size_t end) {
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; ++i) {
    count += shape_of(rows[i].text, separators_of(rows[i].text).separator()).has_number ? 1 : 0;
  }
  return count;
}

}  // namespace

char SeparatorCounts::separator() const {
  if (semicolons > 0) return ';';
  return commas == 0 && tabs > 0 ? '\t' : ',';
}

std::string_view csv_row_at(std::string_view text, std::size_t begin) {
  bool quoted = false;
  std::size_t end = begin;
  for (; end < text.size() && (quoted || text[end] != '\n'); ++end) {
    if (text[end] == '"') quoted = !quoted;
  }
  return text.substr(begin, end - begin);
}

std::string_view without_carriage_return(std::string_view row) {
  return row.ends_with('\r') ? row.substr(0, row.size() - 1) : row;
}

SeparatorCounts separators_of(std::string_view row) {
  SeparatorCounts counts;
  bool quoted = false;
  for (const char c : row) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    counts.commas += c == ',' ? 1 : 0;
    counts.semicolons += c == ';' ? 1 : 0;
    counts.tabs += c == '\t' ? 1 : 0;
  }
  return counts;
}

std::size_t header_begin(std::string_view text, std::size_t begin) {
  const std::vector<PlacedRow> rows = first_rows(text, begin);
  const auto first = header_from(rows, 0);
  if (!first) return begin;
  std::size_t header = *first;
  for (auto next = header_from(rows, header + 1); next; next = header_from(rows, *next + 1)) {
    const std::size_t between = rows_of_numbers(rows, header, *next);
    const bool is_behind_titles =
        between > 0 && between < rows_of_numbers(rows, *next, rows.size());
    if (is_behind_titles && rows[*next].text != rows[header].text) header = *next;
  }
  return rows[header].begin;
}

}  // namespace reeve::readings
