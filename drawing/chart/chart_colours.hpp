// The colours of charts on white. A page that shows one in the dark gives the classes reeve-blue,
// reeve-orange, … another `color`; reeve-chart has that of the ink.
#pragma once

#include <array>
#include <string>

#include "drawing/chart/chart.hpp"

namespace reeve::drawing::chart {

struct NamedColour {
  Colour colour;
  const char* name;
  const char* on_white;
};

inline constexpr std::array<NamedColour, 9> colours{{{Colour::blue, "blue", "#0072b2"},
                                                     {Colour::orange, "orange", "#d55e00"},
                                                     {Colour::green, "green", "#009e73"},
                                                     {Colour::pink, "pink", "#cc79a7"},
                                                     {Colour::sky, "sky", "#56b4e9"},
                                                     {Colour::amber, "amber", "#e69f00"},
                                                     {Colour::ink, "ink", "#1a1a1a"},
                                                     {Colour::grey, "grey", "#808080"},
                                                     {Colour::violet, "violet", "#7b3fa0"}}};

// " reeve-blue", to follow another class.
std::string colour_class(Colour colour);

// " color="#0072b2"", which `currentColor` then means; ink is what the picture has.
std::string colour_attribute(Colour colour);

}  // namespace reeve::drawing::chart
