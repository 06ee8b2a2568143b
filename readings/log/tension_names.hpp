// Names of columns that are not read as a tension, and would be one in another unit.
#pragma once

#include <optional>
#include <string_view>

#include "readings/column_name.hpp"

namespace reeve::readings {

// Which one: "T3 [V]", "Motor Tension (Nm)". Nothing of a name whose unit tells another quantity,
// such as the temperature "T3 [°C]".
std::optional<ColumnName> tension_in_no_unit_of_force(std::string_view name);

}  // namespace reeve::readings
