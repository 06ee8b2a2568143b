#include "drawing/schematic/floating_paths.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/schematic/floating_measures.hpp"

namespace reeve::drawing {
namespace {

using namespace measures;
using Path = std::vector<Corner>;

void append(Path& path, const Path& more) { path.insert(path.end(), more.begin(), more.end()); }

// From a port's line to the middle of what lies there.
Path inward(const FloatingPlaces& places, std::size_t port) {
  const Point at = places.at(port);
  const PortRole role = places.all.ports[port].role;
  const bool has_turn = places.all.ports[port].twin != nowhere;
  if (role != PortRole::turn && !(role == PortRole::strand && has_turn)) return {{at, 0}};
  const Point centre = places.centre(port);
  const double apex = centre.y + (places.all.faces_down(port) ? -tip_radius : tip_radius);
  return {{{at.x, apex}, tip_radius}, {{centre.x, apex}, 0}};
}

// Along its lane; nothing where the line runs straight on.
Path along(const FloatingPlaces& places, const Stretch& stretch, bool backwards) {
  const double y = height(places.arrangement.heights, stretch);
  const double from = places.at(stretch.port[backwards ? 1 : 0]).x;
  const double to = places.at(stretch.port[backwards ? 0 : 1]).x;
  const double radius = std::min(bend, std::abs(to - from) / 2);
  if (radius == 0) return {};
  return {{{from, y}, radius}, {{to, y}, radius}};
}

Path between(const FloatingPlaces& places, std::size_t segment, std::size_t port) {
  std::vector<const Stretch*> stretches;
  for (const Stretch& stretch : places.arrangement.lanes.stretches) {
    if (stretch.segment == segment) stretches.push_back(&stretch);
  }
  Path path;
  if (stretches.empty()) return path;
  const bool backwards = stretches.front()->port[0] != port;
  if (backwards) std::reverse(stretches.begin(), stretches.end());
  for (const Stretch* stretch : stretches) append(path, along(places, *stretch, backwards));
  return path;
}

}  // namespace

Point FloatingPlaces::at(std::size_t port) const {
  const double x = left + column(all, arrangement.columns, port);
  if (all.ports[port].role != PortRole::strand) return {x, height(all, arrangement.heights, port)};
  return {x, fingertips[all.of(port).index]};
}

Point FloatingPlaces::centre(std::size_t port) const {
  const Point at = this->at(port);
  const Point other = this->at(all.ports[port].twin);
  return {(at.x + other.x) / 2, at.y};
}

std::vector<Corner> path(const FloatingPlaces& places, std::size_t segment) {
  const SegmentEnds& ends = places.all.segments[segment];
  const auto [begin, end] = ends.port;
  if (begin == nowhere && end == nowhere) return {};
  if (begin == nowhere || end == nowhere) {
    const std::size_t port = begin == nowhere ? end : begin;
    const double y = loose_end(places.all, places.arrangement.heights, port, ends.loose);
    Path path{{{places.at(port).x, y}, 0}};
    append(path, inward(places, port));
    if (end == nowhere) std::reverse(path.begin(), path.end());
    return path;
  }
  Path path = inward(places, begin);
  std::reverse(path.begin(), path.end());
  append(path, between(places, segment, begin));
  append(path, inward(places, end));
  return path;
}

}  // namespace reeve::drawing
