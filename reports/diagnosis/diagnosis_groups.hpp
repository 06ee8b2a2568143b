// Diagnosis report: differences between the named groups of rows.
#pragma once

#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/output/json.hpp"
#include "studies/diagnosis_study.hpp"

namespace reeve::reports {

// "By group, each fitted by itself, sheath_friction differs: mu = 0.180 (0.170 to 0.190) in A,
// 0.120 (0.110 to 0.130) in B; B stands out (p < 0.001)"; none where no parameter differs.
std::vector<std::string> group_sentences(const DiagnosisReport& report);
// Each coefficient and cause, group by group; no rows without groups.
Table group_table(const DiagnosisReport& report);
// States that each group's readings scatter differently; empty if they do not.
std::string group_scatter_sentence(const DiagnosisReport& report);

Json by_group_json(const DiagnosisReport& report);
Json noise_of_groups_json(const DiagnosisReport& report);

}  // namespace reeve::reports
