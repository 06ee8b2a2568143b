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

// "the 5 % quantile of uniformity_mean x efficiency_mean over 100 draws of the coefficients"
std::string goal_text(const SizingOptions& options);
// "TR1 (M-1-T-2-F)", or the word alone.
std::string title_of(const SizedRouting& routing);
// "0.0347 -> 0.164 (+371.0 %)"; of a target without the percentage.
std::string gain_text(const SizingOptions& options, const SizedDesign& design);

// "so far off alone before 1 % of the goal is lost", of a target "before shares miss by 0.01 more".
std::string tolerance_text(const SizingOptions& options);
// Explains "any" beside a number; "" if no number has it.
std::string any_text(const SizedDesign& design);
// Says how far all dimensions may be off at once, in a sentence; the design has tolerances.
std::string together_text(const SizingOptions& options, const SizedDesign& design);
// "sheath_angle[1] by +0.3 rad with tip_angle[1,2] by -0.1 rad"
std::string moves_text(const SizedDesign& design, const std::vector<double>& moves,
                       const char* between = " with ");

}  // namespace reeve::reports
