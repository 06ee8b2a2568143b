// How an exploration was made, in plain words: what was generated, how judged, what rejected.
#pragma once

#include <string>
#include <vector>

#include "reports/exploration/explore_report.hpp"

namespace reeve::pages {

// Sentences.
std::vector<std::string> explored_words(const ExploreReport& report);
std::vector<std::string> rejected_words(const ExploreReport& report);

}  // namespace reeve::pages
