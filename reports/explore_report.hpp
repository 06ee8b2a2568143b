// What `explore` leaves behind: a table for the terminal, JSON for everything else.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "reports/design_list.hpp"
#include "reports/sheet.hpp"
#include "search/explore.hpp"
#include "search/uncertainty.hpp"

namespace reeve {

struct ExploreReport {
  ExploreOptions options;
  ExploreResult result;
  std::vector<ListedDesign> front;
  std::vector<ListedDesign> top;
  std::vector<std::string> reference_names;  // parallel to result.references
  // Only where uncertainty was asked for.
  std::optional<UncertaintyOptions> uncertainty;
  bool draws_stopped = false;  // before there were distributions
};

// Distributions are parallel to the longer of top and front, or empty.
ExploreReport explore_report(const ExploreOptions& options, ExploreResult result,
                             const std::vector<RankDistribution>& distributions,
                             const Catalogue& catalogue);

Sheet explore_sheet(const ExploreReport& report);
std::string explore_summary_json(const ExploreReport& report);
// What the user should know of how the ranking came about; usually nothing.
std::vector<std::string> notes(const ExploreReport& report);

// Set in the files of an exploration that was stopped; otherwise "".
std::string partial_note(const ExploreReport& report);

}  // namespace reeve
