// A result for people as a value: lines and tables, in order. It is made once and written as text,
// as Markdown or as LaTeX (document_latex.hpp).
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::reports {

struct TableColumn {
  std::string heading;
  std::string unit;          // "" if there is none, or if each cell bears its own
  bool is_text = false;      // to the left; numbers go to the right
  unsigned dispensable = 0;  // if room is short, the greatest is left out first; 0: never
  std::string key = "";      // the key by which it is chosen; "": its heading
};

TableColumn text_column(const std::string& heading);
TableColumn number_column(const std::string& heading, const std::string& unit = "",
                          unsigned dispensable = 0);

// "motor (N)".
std::string heading_text(const TableColumn& column);

// A unit where room is short: "" of shares and of ratios, which read as numbers.
std::string shown_unit(const std::string& unit);

// Beside a word that says the same; titles and headings are strong.
enum class Tint : std::uint8_t { none, good, notable, bad, strong };

struct TableRow {
  std::vector<std::string> cells;
  Tint tint = Tint::none;
};

struct Table {
  std::vector<TableColumn> columns;
  std::vector<TableRow> rows;
  bool chosen = false;  // somebody asked for just these columns

  void add(std::vector<std::string> cells, Tint tint = Tint::none);
};

// Returns the table of the columns at these places.
Table columns_at(const Table& table, const std::vector<std::size_t>& places);

struct DocumentLine {
  std::string text;
  bool caveat = false;  // whoever reads the tables must see it too
};

// A title, what it is the title of, and lines below. Each may be missing.
struct Section {
  std::string title;
  std::optional<Table> table;
  std::vector<DocumentLine> lines;
};

struct Document {
  std::vector<Section> sections;

  // Nothing, if it holds neither a table nor a line.
  void add(Section section);
  void add_all(std::vector<Section> more);
};

// Capabilities of the output. By default no window limits it and nothing can show colour: a file, a
// pipe.
struct TextStyle {
  std::size_t width = 0;  // in columns; 0: any
  bool colour = false;
};

std::string text(const Document& document, const TextStyle& look = {});

// In a narrow window dispensable columns of a table are left out, which a line below says; then
// texts are wrapped; and what still finds no room follows below, with the first column again.
std::string text(const Table& table, const TextStyle& look = {});

// The line with the codes for its tint around it, if the look has colour.
std::string inked(const std::string& line, Tint tint, const TextStyle& look);

// Tables have pipes, as GitHub shows them.
std::string markdown(const Document& document);

// Appends all items of another list.
template <typename Item>
void append(std::vector<Item>& list, std::vector<Item> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()),
              std::make_move_iterator(more.end()));
}

// Joins the texts that `text_of` makes of the items.
template <typename Items, typename TextOf>
std::string joined(const Items& items, const char* between, TextOf text_of) {
  std::vector<std::string> texts;
  for (const auto& item : items) texts.emplace_back(std::invoke(text_of, item));
  return fmt::format("{}", fmt::join(texts, between));
}

// "a, b and c", the first `most` of them: "a, b and 3 more".
std::string enumerated(const std::vector<std::string>& items, const char* before_last = " and ",
                       std::size_t most = static_cast<std::size_t>(-1));

// Appends the lines of a text as lines.
void add_lines(std::vector<DocumentLine>& lines, const std::string& text);

std::string percent(double share);  // "72.1 %"; "-" if it is none

// Returns a share of draws as percent() does, but some or most never read as none or all: "under
// 0.1 %".
std::string share_text(double share);

}  // namespace reeve::reports
