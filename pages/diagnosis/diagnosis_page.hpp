// The page of a diagnosis: the answer, what it rests on, and what to do next, for whoever built the
// rig. docs/diagnosis.md explains it.
#pragma once

#include <optional>
#include <string>

#include "pages/shell/figure_files.hpp"
#include "pages/shell/page.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"
#include "studies/shown_routing.hpp"
#include "studies/tension_distributions.hpp"

namespace reeve::pages {

struct DiagnosisPageInput {
  const DiagnosisReport& report;
  std::string command;  // the command that makes the page again
  // The routing of the next measurement in its grasp, by the extended model; without it the
  // measurement has no schematic.
  std::optional<SolvedRouting> next{};
  // Before and after; without it the page has none.
  std::optional<TensionDistributions> distributions{};
};

PageFiles diagnosis_page(const DiagnosisPageInput& input);

}  // namespace reeve::pages
