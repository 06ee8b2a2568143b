// Which exploration a file is of: a hash of what was asked and of the program that answered.
//
// FNV-1a of 64 bits over the settings as JSON, the version, the known routings with their names,
// and how far it came if it was stopped. It tells accidents apart, not forgeries. It needs no
// clock, so that the same command writes the same bytes. (Fowler, Noll, Vo: draft-eastlake-fnv.)
#pragma once

#include <string>

#include "reports/json.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::reports {

// Of the JSON as text, its keys in their order: 16 hexadecimal digits.
std::string hash_of(const Json& json);

std::string exploration_id(const ExploreReport& report);

// That of the whole exploration that this one is a shard of, or of itself.
std::string whole_exploration_id(const ExploreReport& report);

// With a last column `exploration`. Comment lines stay as they are.
std::string stamped_csv(const std::string& csv, const std::string& id);
// What a reader finds there: nothing where there is no such column, or no row.
std::string stamp_of_csv(const std::string& csv);

// Behind an HTML page or an SVG drawing.
std::string stamped_markup(const std::string& markup, const std::string& id);
std::string stamp_of_markup(const std::string& markup);

}  // namespace reeve::reports
