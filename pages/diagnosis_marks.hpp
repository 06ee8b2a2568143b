// The compared readings as charts take them: one datum for each measured tension, a part of them
// where they are many.
//
// Names of columns are the user's, and Vega reads dots and brackets in the name of a field as a
// path: columns of the file are c0, c1, … here, and their names only titles.
#pragma once

#include <string>
#include <vector>

#include "reports/diagnosis_report.hpp"
#include "reports/json.hpp"

namespace reeve {

// Something that residuals can follow.
struct MarkColumn {
  std::string field;  // in the data
  std::string id;     // for the figure
  std::string title;
  bool categories = false;
};

struct MarkColumns {
  std::vector<MarkColumn> shown;
  std::vector<std::string> missing;   // that the file does not have
  std::vector<std::string> constant;  // that never change, with their value
  std::size_t not_drawn = 0;          // beyond what a page holds
};

MarkColumns mark_columns(const DiagnosisReport& report);

// measured, before, after (N); residual_before, residual_after (sd of the noise); held_out,
// routing, strand, grasp, direction, run, line; and the columns' fields. At most this many, drawn
// by a fixed rule from all; all where they are fewer.
Json marks(const DiagnosisReport& report, const std::vector<MarkColumn>& columns, std::size_t most);

// Of those marks only these fields.
Json fields_of(const Json& marks, const std::vector<std::string>& fields);

// The catalogue's name of a routing, or its word.
std::string routing_label(const DiagnosisReport& report, const std::string& word);

}  // namespace reeve
