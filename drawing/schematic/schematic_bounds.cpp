// What the symbols of a schematic cover.
#include <algorithm>

#include "drawing/schematic/floating_measures.hpp"
#include "drawing/schematic/schematic_layout.hpp"
#include "drawing/schematic/schematic_measures.hpp"

namespace reeve::drawing {

using namespace measures;

Box bounds(const DrawnContact& contact) {
  const Point& at = contact.centre;
  if (contact.place == ContactPlace::sheath) {
    constexpr double ferrule = sleeve + 2;
    constexpr double arrow = sleeve + 13;
    const bool right = contact.arrow_side > 0;
    return {at.x - (right ? ferrule : arrow), at.y - contact.length / 2,
            at.x + (right ? arrow : ferrule), at.y + contact.length / 2};
  }
  const bool wheel = contact.kind == ContactKind::bearing || contact.kind == ContactKind::block;
  const double reach = contact.radius + (wheel ? thickest / 2 : sleeve);
  const double inner = wheel ? contact.radius - thickest / 2 : 4;
  return {at.x - reach, at.y - (contact.apex > 0 ? inner : reach), at.x + reach,
          at.y + (contact.apex > 0 ? reach : inner)};
}

Box bounds(const DrawnEnd& end) {
  if (end.hold != EndHold::fixed) {
    return {end.at.x - knot_size / 2, end.at.y - knot_size / 2, end.at.x + knot_size / 2,
            end.at.y + knot_size / 2};
  }
  const double deep = end.away * fixation_depth;
  return {end.at.x - fixation_width / 2, end.at.y + std::min(0.0, deep),
          end.at.x + fixation_width / 2, end.at.y + std::max(0.0, deep)};
}

std::vector<Box> bounds(const DrawnBlock& block) {
  std::vector<Box> found;
  Box beam{block.tails.front().x, block.beam, block.tails.front().x, block.beam};
  const auto widen = [&](const Point& at) {
    beam.left = std::min(beam.left, at.x);
    beam.right = std::max(beam.right, at.x);
  };
  const auto add = [&](const Point& at, double half, double to) {
    found.push_back(
        {at.x - half, std::min(at.y - half, to), at.x + half, std::max(at.y + half, to)});
    widen(at);
  };
  for (const Point& axle : block.axles) add(axle, block.sheave, block.beam);
  for (const Point& eye : block.eyes) add(eye, eye_radius, block.beam);
  for (const Point& tail : block.tails) add(tail, eye_radius, block.beam);
  const double half = block.is_bar ? bar_half : beam_half;
  found.push_back({beam.left - half, beam.top - half, beam.right + half, beam.bottom + half});
  found.push_back(block.motion);
  return found;
}

}  // namespace reeve::drawing
