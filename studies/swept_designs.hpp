// Listed designs over one coefficient.
#pragma once

#include <optional>
#include <vector>

#include "search/uncertainty/sweep.hpp"
#include "studies/listed_design.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::studies {

struct SweptDesigns {
  Sweep sweep;
  std::vector<ListedDesign> designs;  // parallel to the sweep's
};

// Nothing if stopped.
std::optional<SweptDesigns> swept_designs(const std::vector<ListedDesign>& designs,
                                          const SweepOptions& options,
                                          const StudySupervision& supervision);

}  // namespace reeve::studies
