#include "drawing/schematic/schematic_symbols.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawing/schematic/schematic_measures.hpp"
#include "drawing/svg.hpp"

namespace reeve::drawing::symbols {
namespace {

using namespace svg;
using namespace measures;

const char* const ink = " fill=\"currentColor\"";
const char* const solid = " fill=\"currentColor\" stroke=\"none\"";

// A triangle with its tip ahead of `at`.
std::string arrow_head(Point at, double dx, double dy) {
  constexpr double ahead = 5;
  constexpr double behind = 4;
  constexpr double half = 4.5;
  const Point tip{at.x + ahead * dx, at.y + ahead * dy};
  const Point left{at.x - behind * dx - half * dy, at.y - behind * dy + half * dx};
  const Point right{at.x - behind * dx + half * dy, at.y - behind * dy - half * dx};
  return path(move_to(tip) + line_to(left) + line_to(right) + "Z", solid);
}

// Round the turn's centre, from the left to the right or back; `reach` from the apex, in rad.
std::string curved_arrow(const DrawnContact& turn, double radius, double reach, bool to_the_right) {
  const double start = to_the_right ? -reach : reach;
  const double end = -0.75 * start;
  const auto at = [&](double angle) {
    return Point{turn.centre.x + radius * std::sin(angle),
                 turn.centre.y + turn.apex * radius * std::cos(angle)};
  };
  const double sense = to_the_right ? 1 : -1;
  const bool clockwise = (turn.apex < 0) == to_the_right;
  return path(move_to(at(start)) + arc_to(at(end), radius, clockwise), " fill=\"none\"") +
         arrow_head(at(end), sense * std::cos(end), -sense * turn.apex * std::sin(end));
}

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

// Draws the arm from the beam to an eye.
std::string arm(Point eye, double beam) {
  constexpr double half = 2.5;
  return rectangle({eye.x - half, std::min(eye.y, beam), eye.x + half, std::max(eye.y, beam)}, 0,
                   paper);
}

}  // namespace

std::string tube(const DrawnContact& turn, double half) {
  const double outer = turn.radius + half;
  const double inner = turn.radius - half;
  const Point c = turn.centre;
  const double end = c.y - turn.apex * 4;
  const bool clockwise = turn.apex < 0;
  const std::string ring =
      move_to({c.x - outer, end}) + line_to({c.x - outer, c.y}) +
      arc_to({c.x + outer, c.y}, outer, clockwise) + line_to({c.x + outer, end}) +
      line_to({c.x + inner, end}) + line_to({c.x + inner, c.y}) +
      arc_to({c.x - inner, c.y}, inner, !clockwise) + line_to({c.x - inner, end}) + "Z";
  return path(ring, paper);
}

std::string wheel(Point centre, double radius) {
  return circle(centre, radius, paper) + circle(centre, std::max(2.0, radius / 6), solid);
}

std::string sheath(const DrawnContact& sheath, double half) {
  const Point c = sheath.centre;
  const double top = c.y - sheath.length / 2;
  const double bottom = c.y + sheath.length / 2;
  const double ferrule = half / 2;
  std::string coil;
  for (double y = top + ferrule + half; y <= bottom - ferrule; y += half * 0.8) {
    coil += move_to({c.x - half, y}) + line_to({c.x + half, y - half});
  }
  const auto cap = [&](double y) {
    return rectangle({c.x - half - 2, y, c.x + half + 2, y + ferrule}, 1, ink);
  };
  return rectangle({c.x - half, top, c.x + half, bottom}, 0, paper) + path(coil, " fill=\"none\"") +
         cap(top) + cap(bottom - ferrule);
}

std::string fixation(const DrawnEnd& end, double width, double depth) {
  const double deep = end.away * (depth - 2);
  constexpr int ticks = 5;
  std::string commands =
      move_to({end.at.x - width / 2, end.at.y}) + line_to({end.at.x + width / 2, end.at.y});
  for (int i = 0; i < ticks; ++i) {
    const double x = end.at.x - width / 2 + width / ticks * (i + 1);
    commands += move_to({x, end.at.y}) + line_to({x - width / ticks, end.at.y + deep});
  }
  return path(commands, " fill=\"none\"") + circle(end.at, width / 6, solid);
}

std::string knot(Point at, double size) {
  return rectangle({at.x - size / 2, at.y - size / 2, at.x + size / 2, at.y + size / 2}, 0, ink);
}

std::string anchor(Point at, double radius) { return circle(at, radius, solid); }

std::string extensor(Point at, double radius) { return circle(at, radius, paper); }

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
  const auto eye = [&](const Point& at) {
    return circle(at, block.is_bar ? 3 : eye_radius, paper);
  };
  const auto tail = [&](const Point& at) {
    return block.is_bar ? circle(at, 4.5, paper) + circle(at, 1.5, solid)
                        : circle(at, eye_radius, paper);
  };
  return each(block.eyes, eye) + each(block.tails, tail);
}

std::string object(const Box& box) {
  const Point centre{(box.left + box.right) / 2, (box.top + box.bottom) / 2};
  const double radius = (box.right - box.left) / 2;
  std::string hatch;
  for (const double off : {-0.66, -0.33, 0.0, 0.33, 0.66}) {
    const double half = radius * std::sqrt(1 - off * off);
    constexpr double diagonal = 1 / std::numbers::sqrt2;
    const Point middle{centre.x + off * radius * diagonal, centre.y + off * radius * diagonal};
    hatch += move_to({middle.x - half * diagonal, middle.y + half * diagonal}) +
             line_to({middle.x + half * diagonal, middle.y - half * diagonal});
  }
  return circle(centre, radius, " class=\"reeve-object\" fill=\"#f2c14e\"") +
         path(hatch, " fill=\"none\"");
}

std::string hatching(const Box& finger) {
  constexpr double spacing = 9;
  constexpr double tick = 5;
  const double begin = finger.top + (finger.right - finger.left) / 2;
  std::string commands;
  for (double y = begin; y + tick < finger.bottom; y += spacing) {
    commands += move_to({finger.left, y}) + line_to({finger.left - tick, y + tick}) +
                move_to({finger.right, y}) + line_to({finger.right + tick, y + tick});
  }
  return path(commands, " fill=\"none\"");
}

std::string sliding(const DrawnContact& contact, bool with_walk) {
  const bool forward = with_walk == contact.forward;
  if (contact.kind == ContactKind::bar) {
    // A sheave in its place would turn the same way; there is room on the side of the arms.
    DrawnContact over = contact;
    over.apex = -contact.apex;
    return curved_arrow(over, turning_arrow, 0.95, !forward);
  }
  if (contact.place != ContactPlace::sheath) {
    return curved_arrow(contact, contact.radius - 13, 1.3, forward);
  }
  constexpr double aside = sleeve + 8;
  const double half = contact.length / 2 - 12;
  const double x = contact.centre.x + contact.arrow_side * aside;
  const Point top{x, contact.centre.y - half};
  const Point bottom{x, contact.centre.y + half};
  return forward ? straight_arrow(top, bottom) : straight_arrow(bottom, top);
}

std::string straight_arrow(Point from, Point to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double dx = (to.x - from.x) / length;
  const double dy = (to.y - from.y) / length;
  constexpr double head = 5;
  const Point neck{to.x - head * dx, to.y - head * dy};
  return line(from, neck) + arrow_head(neck, dx, dy);
}

std::string hand(const SchematicLayout& layout) {
  constexpr double rounding = 16;
  const Box& palm = layout.hand;
  // The palm goes on as the side of a finger that stands at the edge.
  const double left =
      layout.fingers.empty() || layout.fingers.front().outline.left > palm.left + 1 ? rounding : 0;
  const double right =
      layout.fingers.empty() || layout.fingers.back().outline.right < palm.right - 1 ? rounding : 0;
  std::string outline = move_to({palm.left, palm.top + left});
  if (left > 0) outline += arc_to({palm.left + left, palm.top}, left, true);
  for (const DrawnFinger& finger : layout.fingers) {
    const Box& box = finger.outline;
    const double radius = (box.right - box.left) / 2;
    outline += line_to({box.left, box.bottom}) + line_to({box.left, box.top + radius}) +
               arc_to({box.right, box.top + radius}, radius, true) +
               line_to({box.right, box.bottom});
  }
  outline += line_to({palm.right - right, palm.top});
  if (right > 0) outline += arc_to({palm.right, palm.top + right}, right, true);
  outline += line_to({palm.right, palm.bottom - rounding}) +
             arc_to({palm.right - rounding, palm.bottom}, rounding, true) +
             line_to({palm.left + rounding, palm.bottom}) +
             arc_to({palm.left, palm.bottom - rounding}, rounding, true) + "Z";
  return path(outline, " class=\"reeve-hand\" fill=\"#f3efe8\"");
}

}  // namespace reeve::drawing::symbols
