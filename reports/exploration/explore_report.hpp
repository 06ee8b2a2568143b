// Output of `explore`: a table for the terminal, JSON for everything else.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/document/chosen_columns.hpp"
#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::reports {

// If columns are chosen, the only table is that of the best designs.
Document explore_document(const ExploreReport& report, const ListColumns& columns = {});
std::string explore_summary_json(const ExploreReport& report);
// Returns the settings of the request, as in the summary.
Json explore_settings(const ExploreReport& report);

// Id of an exploration: a hash of the request and of the program that answered. It is of the
// settings as JSON, the version, the known routings with their names, and how far it came if it was
// stopped.
std::string exploration_id(const ExploreReport& report);
// Returns the id of the whole exploration that this one is a shard of, or its own.
std::string whole_exploration_id(const ExploreReport& report);

// Returns notes on how the ranking came about; usually none.
std::vector<std::string> notes(const ExploreReport& report);

// Number of evaluated designs that no constraint rejects.
std::uint64_t ranked_designs(const ExploreReport& report);

// "not actuated", "constraint sheaths<=2".
std::string rejection_text(const Rejection& rejection, const ExploreOptions& options);

// Set in the files of an exploration that was stopped; otherwise "".
std::string partial_note(const ExploreReport& report);

}  // namespace reeve::reports
