// What became of the samples of a log, in words.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/series/sample_use.hpp"

namespace reeve::reports {

// "the carriage stands"
const char* sample_use_words(SampleUse use);

// Parallel to all_sample_uses.
std::vector<std::size_t> count_uses(const std::vector<SampleUse>& uses);

}  // namespace reeve::reports
