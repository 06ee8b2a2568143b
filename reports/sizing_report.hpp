// Sized routings as a table, as JSON, and as a hardware file.
#pragma once

#include <string>
#include <vector>

#include "catalog/hardware_file.hpp"
#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/uncertainty_ranges.hpp"
#include "reports/document/document.hpp"
#include "studies/sizing_study.hpp"

namespace reeve::reports {

// Compares the present hardware, model and grasps with those of an exploration's summary.json.
// Returns the names of those that differ: "hardware, grasps"; "" if none does or if the text is no
// such file.
std::string differing_settings(const std::string& summary, const Model& model,
                               const GraspSet& grasps);

// Pieces of it, for the document and the page. Without a table or a line one holds nothing.
struct SizingSections {
  std::vector<DocumentLine> opening;
  Section ranking;     // if there are several designs
  Section best;        // the dimensions of the best
  Section shares;      // shares of a target
  Section objectives;  // before and sized
};
SizingSections sizing_sections(const SizingReport& report);

// The ranking, if there are several designs, and the best of them in full. If columns are chosen,
// the one table that has them: the dimensions of the best, or the ranking.
Document sizing_document(const SizingReport& report, const std::vector<std::string>& columns = {});

// Names of the columns that can be chosen in either table; no name is in both.
std::vector<std::string> dimension_column_names();
std::vector<std::string> sized_column_names(const Hardware& hardware);

std::string sizing_json(const SizingReport& report);

// The hardware of the best, with comments that say what it was sized for. `vary` goes along, so
// that it can be sized again.
std::string sized_hardware_toml(const SizingReport& report, const VaryTable& vary);

}  // namespace reeve::reports
