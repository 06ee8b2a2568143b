// How a table that is wider than a window is made to fit.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/document/document.hpp"

namespace reeve::reports {

inline constexpr std::size_t column_gap = 2;

// Of a text, where shares and ratios have no unit.
std::string text_heading(const TableColumn& column);

// Of each column, heading and cells.
std::vector<std::size_t> natural_widths(const Table& table);

struct FittedTable {
  std::vector<Table> parts;           // one below the other
  std::vector<std::string> left_out;  // headings
};

// Leaves columns out only if the others then stand side by side.
FittedTable fit(const Table& table, std::size_t width);

// The widths of a table's columns such that it is no wider than that: texts shrink first.
std::vector<std::size_t> shrunk_widths(const Table& table, std::size_t width);

}  // namespace reeve::reports
