#include "drawing/chart/chart_colours.hpp"

namespace reeve::drawing::chart {

std::string colour_class(Colour colour) {
  return std::string(" reeve-") + colours[static_cast<std::size_t>(colour)].name;
}

std::string colour_attribute(Colour colour) {
  if (colour == Colour::ink) return "";
  return std::string(" color=\"") + colours[static_cast<std::size_t>(colour)].on_white + "\"";
}

}  // namespace reeve::drawing::chart
