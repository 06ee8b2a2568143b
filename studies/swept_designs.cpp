#include "studies/swept_designs.hpp"

#include <utility>

namespace reeve::studies {

std::optional<SweptDesigns> swept_designs(const std::vector<ListedDesign>& designs,
                                          const SweepOptions& options,
                                          const StudySupervision& supervision) {
  std::vector<Routing> routings;
  for (const ListedDesign& design : designs) routings.push_back(design.routing);
  auto swept = sweep(routings, options, supervision.during("sweeping"));
  if (!swept) return std::nullopt;
  return SweptDesigns{std::move(*swept), designs};
}

}  // namespace reeve::studies
