// Uses of a log's samples, and its columns, in words.
#pragma once

#include <string>
#include <vector>

#include "readings/log/logged_series.hpp"
#include "readings/log/sample_use.hpp"

namespace reeve::reports {

// "the carriage stands"
const char* sample_use_words(SampleUse use);

// Returns the name of a tension's column, without its unit: "T1", "Ta".
std::string tension_words(const LoggedSignal& tension);

// Parallel to all_sample_uses.
std::vector<std::size_t> count_uses(const std::vector<SampleUse>& uses);

}  // namespace reeve::reports
