#include "tests/support/planting_dirt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "tests/support/random_routing.hpp"

namespace reeve::testing {
namespace {

using Fields = std::vector<std::string>;

Fields split(const std::string& line) {
  Fields fields;
  std::string field;
  for (const char c : line) {
    if (c == ',') {
      fields.push_back(field);
      field.clear();
    } else {
      field += c;
    }
  }
  fields.push_back(field);
  return fields;
}

struct Table {
  std::string comments;
  Fields header;
  std::vector<Fields> rows;
};

Table table_of(const std::string& csv) {
  Table table;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) {
      table.comments += line + "\n";
    } else if (table.header.empty()) {
      table.header = split(line);
    } else {
      table.rows.push_back(split(line));
    }
  }
  return table;
}

std::string csv_of(const Table& table) {
  std::string text = table.comments + fmt::format("{}\n", fmt::join(table.header, ","));
  for (const Fields& row : table.rows) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

std::string unit_of(const std::string& column) {
  if (column.ends_with("_N")) return "N";
  if (column.ends_with("_mm_s")) return "mm/s";
  return column.ends_with("_C") ? "°C" : "-";
}

bool is_tension(const std::string& column) {
  return column.starts_with('T') && column.ends_with("_N");
}

// With semicolons and decimal commas.
std::string european(const Fields& fields) {
  std::string line;
  for (std::string field : fields) {
    if (field.find(';') != std::string::npos) {
      field = '"' + field + '"';
    } else {
      std::replace(field.begin(), field.end(), '.', ',');
    }
    line += ";" + field;
  }
  return line;
}

std::string in_other_form(const Table& table, Dice& dice) {
  std::string text = "\xEF\xBB\xBF" + table.comments;
  std::replace(text.begin(), text.end(), '\n', ' ');
  text += "\r\n";
  Fields units;
  for (const std::string& column : table.header) units.push_back(unit_of(column));
  text += european(table.header) + ";remark;\r\n" + european(units) + ";-;\r\n";
  int index = 0;
  for (Fields row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (row[c].empty() && is_tension(table.header[c])) row[c] = dice.chance(0.5) ? "NaN" : "n/a";
    }
    text += std::to_string(index++) + european(row) + (dice.chance(0.1) ? ";cable moved" : ";ok");
    text += dice.chance(0.5) ? ";\r\n" : "\r\n";
    if (dice.chance(0.05)) text += "\r\n";
  }
  return text;
}

void copy_some(Table& table, Dice& dice) {
  std::vector<Fields> rows;
  for (const Fields& row : table.rows) {
    rows.push_back(row);
    if (dice.chance(0.05)) rows.push_back(row);
  }
  table.rows = std::move(rows);
}

void add_spikes(Table& table, Dice& dice) {
  for (Fields& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (!is_tension(table.header[c]) || row[c].empty() || !dice.chance(0.01)) continue;
      row[c] = fmt::format("{:.4f}", std::stod(row[c]) * dice.real(3, 10));
    }
  }
}

}  // namespace

const char* dirt_name(Dirt dirt) {
  switch (dirt) {
    case Dirt::form:
      return "form";
    case Dirt::copies:
      return "copies";
    case Dirt::unsorted:
      return "unsorted";
    case Dirt::spikes:
      return "spikes";
  }
  return "";
}

const std::vector<Dirt>& all_dirt() {
  static const std::vector<Dirt> all{Dirt::form, Dirt::copies, Dirt::unsorted, Dirt::spikes};
  return all;
}

std::string dirtied(const std::string& csv, Dirt dirt, std::uint64_t seed) {
  Table table = table_of(csv);
  Dice dice(seed);
  switch (dirt) {
    case Dirt::form:
      return in_other_form(table, dice);
    case Dirt::copies:
      copy_some(table, dice);
      break;
    case Dirt::unsorted:
      dice.shuffle(table.rows);
      break;
    case Dirt::spikes:
      add_spikes(table, dice);
      break;
  }
  return csv_of(table);
}

}  // namespace reeve::testing
