#include <algorithm>
#include <cmath>

#include "drawing/schematic/floating_measures.hpp"
#include "drawing/schematic/schematic_symbols.hpp"
#include "drawing/svg.hpp"

namespace reeve::drawing::symbols {
namespace {

using namespace svg;
using namespace measures;

const char* const solid = " fill=\"currentColor\" stroke=\"none\"";

// A plate that narrows from a wheel to its foot.
std::string cheek(Point axle, double half, double foot) {
  const double narrow = half / 3;
  return path(move_to({axle.x - half, axle.y}) + line_to({axle.x - narrow, foot}) +
                  line_to({axle.x + narrow, foot}) + line_to({axle.x + half, axle.y}) + "Z",
              paper);
}

Box beam(const DrawnBlock& block) {
  Box box{block.tails.front().x, block.beam, block.tails.front().x, block.beam};
  for (const auto* points : {&block.axles, &block.eyes, &block.tails}) {
    for (const Point& at : *points) {
      box.left = std::min(box.left, at.x);
      box.right = std::max(box.right, at.x);
    }
  }
  return box;
}

Box grown(const Box& box, double by) {
  return {box.left - by, box.top - by, box.right + by, box.bottom + by};
}

// From the beam to an eye.
std::string arm(Point eye, double beam) {
  constexpr double half = 2.5;
  return rectangle({eye.x - half, std::min(eye.y, beam), eye.x + half, std::max(eye.y, beam)}, 0,
                   paper);
}

}  // namespace

std::string anchor(Point at, double radius) { return circle(at, radius, solid); }

std::string shell(const DrawnBlock& block) {
  const Box box = beam(block);
  // Within a legend there is less room.
  if (block.is_bar) {
    const double half = std::min(bar_half, (box.right - box.left) / 4);
    return rectangle(grown(box, half), half - 1, paper);
  }
  const bool alone = box.right == box.left;
  if (alone && !block.axles.empty()) {
    return cheek(block.axles.front(), block.sheave * 0.75, block.tails.front().y);
  }
  std::string content;
  for (const Point& eye : block.eyes) content += arm(eye, block.beam);
  for (const Point& tail : block.tails) content += arm(tail, block.beam);
  for (const Point& axle : block.axles) {
    content += cheek(axle, block.sheave * 0.75, block.beam);
  }
  if (!alone) content += rectangle(grown(box, beam_half), 3, paper);
  return content;
}

std::string eyes(const DrawnBlock& block) {
  std::string content;
  for (const Point& eye : block.eyes) {
    content += circle(eye, block.is_bar ? 3 : eye_radius, paper);
  }
  for (const Point& tail : block.tails) {
    content += block.is_bar ? circle(tail, 4.5, paper) + circle(tail, 1.5, solid)
                            : circle(tail, eye_radius, paper);
  }
  return content;
}

}  // namespace reeve::drawing::symbols
