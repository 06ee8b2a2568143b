// Which unit a column's numbers are in: what the user says goes before what the file says, and the
// name and the row of units must agree.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "diagnosis/data/csv.hpp"
#include "diagnosis/data/intake/column_name.hpp"
#include "diagnosis/data/intake/reading_options.hpp"

namespace reeve::diagnosis {

// What the name means where the user has said so, or else the name itself.
const std::string& meaning_of(const std::string& name, const ReadingOptions& options);

// The row below the header if it has units in place of readings.
bool is_units_row(const CsvRow& header, const CsvRow& row, const ReadingOptions& options);

// Whether the text is that column's name, or means the same.
bool means(const std::string& text, const std::string& name, DataRole role,
           const MeasuredPlace& place);

// Nothing where nobody says it. Throws InputError that says what was expected.
std::optional<Unit> unit_of(const ColumnName& named, const std::string& name,
                            const std::optional<CsvRow>& units, std::size_t index,
                            const ReadingOptions& options);

}  // namespace reeve::diagnosis
