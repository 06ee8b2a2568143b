#include "readings/header_faults.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/text.hpp"

namespace reeve::readings {

void HeaderFaults::add(InputFault fault) {
  const std::size_t line = csv_.header().line;
  if (!fault.where) fault.where = fmt::format("{}:{}", csv_.name(), line);
  faults_.add(line, "in the header", std::move(fault));
}

void HeaderFaults::add_column(std::size_t column, std::string expected) {
  add({.what = fmt::format("column {}", column + 1),
       .value = for_message(std::string(trimmed(csv_.header().fields[column]))),
       .expected = std::move(expected)});
}

}  // namespace reeve::readings
