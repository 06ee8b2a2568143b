// The columns of a list that are shown, as a user chooses them.
#pragma once

#include <string>
#include <vector>

#include "reports/sheet/sheet.hpp"

namespace reeve::reports {

struct ListColumns {
  std::vector<std::string> chosen;  // by their keys, in this order; none: the usual ones
  bool apart = false;               // of the usual ones mean and worst each have their own
};

// What a column is chosen by.
std::string key(const TableColumn& column);

// Throws InputError that says what there is, of a key that the table has not, or that is there
// twice.
Table with_columns(const Table& table, const std::vector<std::string>& keys);

// "name,routing,uniformity_mean": none of them empty or there twice, all of them among `known`.
// Throws InputError that lists these.
std::vector<std::string> parse_columns(const std::string& text,
                                       const std::vector<std::string>& known);

}  // namespace reeve::reports
