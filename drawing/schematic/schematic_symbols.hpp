// The symbols of a schematic, told apart by shape: a tube is a half ring, a bearing a wheel with
// its axle, a sheath a coiled sleeve, a fixation hatched ground, a tied end a filled square, a tip
// where a tendon ends a filled circle, a block a shell round its wheels, a bar a beam with holes.
//
// They leave the ink and its width to the group around them.
#pragma once

#include <string>

#include "drawing/schematic/schematic_layout.hpp"

namespace reeve::drawing::symbols {

// The ink of all that is not filled.
inline const char* const strokes = " stroke=\"currentColor\" stroke-width=\"1.5\"";

// Fill of symbols that hide the tendons behind them.
inline const char* const paper = " class=\"reeve-paper\" fill=\"#ffffff\"";

// The half ring on which a tendon of that radius lies; `half` is half its width.
std::string tube(const DrawnContact& turn, double half);
std::string wheel(Point centre, double radius);
std::string sheath(const DrawnContact& sheath, double half);
std::string fixation(const DrawnEnd& end, double width, double depth);
std::string knot(Point at, double size);
// A tendon's end at a fingertip.
std::string anchor(Point at, double radius);
std::string extensor(Point at, double radius);
// The shell of a block's sheaves, which narrows to its tail; or a bar.
std::string shell(const DrawnBlock& block);
// The rings at which tendons are tied to the block.
std::string eyes(const DrawnBlock& block);
// A ball with hatching.
std::string object(const Box& box);
// Hatching along both sides of a finger.
std::string hatching(const Box& finger);

// Along a contact, in walk order or against it.
std::string sliding(const DrawnContact& contact, bool with_walk);
std::string straight_arrow(Point from, Point to);

// The outlines of the palm and all fingers as one.
std::string hand(const SchematicLayout& layout);

// The symbols of the legend with their texts.
std::string legend(const Legend& legend);

}  // namespace reeve::drawing::symbols
