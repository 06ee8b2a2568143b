#include "reports/catalogue_document.hpp"

#include "drawing/schematic/schematic_svg.hpp"

namespace reeve::reports {

std::string catalogue_document(const std::vector<ShownEntry>& entries) {
  constexpr std::size_t in_a_row = 4;
  std::vector<Schematic> schematics;
  for (const ShownEntry& entry : entries) {
    const GraspView view{entry.grasp, Direction::pull, entry.state};
    schematics.push_back(schematic(entry.network, entry.title, view, false));
  }
  return schematic_sheet(schematics, in_a_row, "Routings of the catalogue");
}

}  // namespace reeve::reports
