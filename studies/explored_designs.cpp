#include "studies/explored_designs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "readings/csv.hpp"

namespace reeve::studies {

std::vector<Routing> explored_designs(const std::filesystem::path& folder, std::size_t count) {
  CsvReader csv = CsvReader::open(folder / "designs.csv");
  const std::vector<std::string>& columns = csv.header().fields;
  const auto column = std::find(columns.begin(), columns.end(), "routing");
  if (column == columns.end()) {
    throw InputError({.where = csv.name(),
                      .what = "no column 'routing'",
                      .expected = "the designs.csv of an exploration",
                      .form = InputForm::unknown});
  }
  std::vector<Routing> routings;
  for (CsvRow row; routings.size() < count && csv.next(row);) {
    if (row.ragged) throw InputError(*row.ragged);
    const std::string& word = row.fields[static_cast<std::size_t>(column - columns.begin())];
    try {
      routings.push_back(parse_routing(word));
    } catch (const InputError& error) {
      throw error.at(fmt::format("{}:{}", csv.name(), row.line));
    }
  }
  if (routings.empty()) {
    throw InputError(
        {.where = csv.name(), .what = "it holds no design", .form = InputForm::unknown});
  }
  return routings;
}

}  // namespace reeve::studies
