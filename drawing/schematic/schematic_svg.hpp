// Draws a schematic: geometry and, if there is one, a solved state; nothing is computed here.
//
// The drawing stands on paper of its own, so that it can be read on any page. A page that inlines
// it may restyle the classes reeve-schematic (its `color` is the ink), reeve-paper, reeve-hand,
// reeve-carriage, reeve-object and reeve-tendon: colours are attributes, which any style overrides.
#pragma once

#include <string>
#include <vector>

#include "core/tension/tension.hpp"
#include "drawing/schematic/schematic_layout.hpp"

namespace reeve::drawing {

// A routing in one grasp, solved.
struct GraspView {
  Grasp grasp;
  Direction direction = Direction::pull;
  const TensionState& state;
};

struct Schematic {
  SchematicLayout layout;
  const TensionState* state = nullptr;  // none: the parts alone
  Direction direction = Direction::pull;
  CarriageTravels carriages{};
  std::vector<double> motor_tension{};
};

Schematic schematic(const Network& network, const std::string& title, bool with_legend = true);
// Keeps a pointer to the view's state.
Schematic schematic(const Network& network, const std::string& title, const GraspView& view,
                    bool with_legend = true);
Schematic schematic(const Network& network, const Places& places, const std::string& title,
                    const GraspView& view, bool with_legend = true);

// A whole file. Identifiers in it begin with `ids`, so that a page can hold several.
std::string schematic_svg(const Schematic& schematic, const std::string& ids = "schematic");

// The symbols' meanings alone, for drawings without a legend.
std::string schematic_legend(double width, const std::string& ids, const DrawnParts& parts);

// Several side by side, `columns` in a row, over one legend.
std::string schematic_sheet(const std::vector<Schematic>& schematics, std::size_t columns,
                            const std::string& title, const std::string& ids = "sheet");

}  // namespace reeve::drawing
