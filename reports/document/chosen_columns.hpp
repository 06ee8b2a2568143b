// The columns of a list that are shown, as a user chooses them.
#pragma once

#include <string>
#include <vector>

#include "reports/document/document.hpp"

namespace reeve::reports {

struct ListColumns {
  std::vector<std::string> chosen;  // by their keys, in this order; none: the usual ones
  bool apart = false;               // among the usual columns, mean and worst each have their own
  std::string cost_unit = "";       // unit of the prices
};

// Returns the key by which a column is chosen.
std::string key(const TableColumn& column);

// Throws InputError that says what there is, of a key that the table has not, or that is there
// twice.
Table with_columns(const Table& table, const std::vector<std::string>& keys);

// Names that there would be if something else were asked for, and what.
struct MissingColumns {
  std::vector<std::string> names;
  std::string with;
};

// "name,routing,uniformity_mean": none of them empty or there twice, all of them among `known`.
// Throws InputError that lists these, or of one that is missing says with what it would be there.
std::vector<std::string> parse_columns(const std::string& text,
                                       const std::vector<std::string>& known,
                                       const std::vector<MissingColumns>& missing = {});

}  // namespace reeve::reports
