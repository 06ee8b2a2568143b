// Which unit a column's numbers are in: what the user says goes before what the file says, and all
// that the file says must agree: the name, the row of units, and the meaning that a name is given,
// which may be one of another unit ("Kraft [kgf]" as motor_tension_N), or of none.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "readings/column_name.hpp"
#include "readings/csv.hpp"
#include "readings/reading_options.hpp"

namespace reeve::readings {

// What the name means where the user has said so, or else the name itself.
const std::string& meaning_of(const std::string& name, const ReadingOptions& options);

// The row below the header if it has units in place of readings.
bool is_units_row(const CsvRow& header, const CsvRow& row, const ReadingOptions& options);

// Whether the text is that column's name, or means the same.
bool means(const std::string& text, const std::string& name, DataRole role,
           const MeasuredPlace& place);

// What the column's name says, or else the meaning that it is given.
std::optional<Unit> unit_of_name(const ColumnName& named, const std::string& name,
                                 const ReadingOptions& options);

// Nothing where nobody says it. Throws InputError that says what was expected.
std::optional<Unit> unit_of(const ColumnName& named, const std::string& name,
                            const std::optional<CsvRow>& units, std::size_t index,
                            const ReadingOptions& options);

}  // namespace reeve::readings
