// Common parts of reports on measured data: the label of simulated data, notes, fields.
#pragma once

#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "readings/measured_data.hpp"
#include "readings/note.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {

inline constexpr const char* simulated_text = "simulated: a comment line of the data says so";

// "1 run", "2 runs"
std::string plural(std::size_t count, const std::string& noun);

DocumentLine simulated_line();

// "1;2", as in a file of measured tensions
std::string held_field(Grasp grasp);
const char* direction_field(Direction direction);

// The last column of a CSV, with the comma before it; both empty where no column names groups.
std::string group_heading(const MeasuredData& data);
std::string group_field(const MeasuredData& data, const Reading& reading);

// One line each.
Section notes_section(const std::vector<DataNote>& notes);
Json notes_json(const std::vector<DataNote>& notes);

}  // namespace reeve::reports
