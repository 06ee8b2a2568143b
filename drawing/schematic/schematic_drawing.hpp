// What is inside a schematic's file: symbols, tendons with their tensions, texts.
#pragma once

#include <string>

#include "drawing/schematic/schematic_svg.hpp"

namespace reeve::drawing {

std::string draw(const Schematic& schematic);
std::string draw(const Legend& legend);

}  // namespace reeve::drawing
