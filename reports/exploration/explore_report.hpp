// What `explore` leaves behind: a table for the terminal, JSON for everything else.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/document/chosen_columns.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::reports {

// Where columns are chosen, of the tables that of the best alone.
Document explore_document(const ExploreReport& report, const ListColumns& columns = {});
std::string explore_summary_json(const ExploreReport& report);
// What was asked, as in the summary.
Json explore_settings(const ExploreReport& report);
// What the user should know of how the ranking came about; usually nothing.
std::vector<std::string> notes(const ExploreReport& report);

// Those evaluated that no constraint rejects.
std::uint64_t ranked_designs(const ExploreReport& report);

// "not actuated", "constraint sheaths<=2".
std::string rejection_text(const Rejection& rejection, const ExploreOptions& options);

// Set in the files of an exploration that was stopped; otherwise "".
std::string partial_note(const ExploreReport& report);

}  // namespace reeve::reports
