// The figures of an exploration as they stand without a script: for readers without JavaScript, for
// print, and for figures/. The page's script shows the same designs by the same rules, over
// whatever the reader chooses (assets/exploration_charts.js).
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "drawing/chart/chart.hpp"
#include "drawing/shapes.hpp"
#include "pages/exploration/exploration_answer.hpp"
#include "pages/exploration/exploration_designs.hpp"
#include "pages/shell/page.hpp"
#include "search/evaluate/objectives.hpp"

namespace reeve::pages {

using TwoObjectives = std::array<Objective, 2>;

// As many cells as the figure is cut into for thinning.
struct SpotGrid {
  double columns = 90;
  double lines = 60;
};

// The grid is that of a figure with two panels, each of which is lower.
inline constexpr SpotGrid of_two_panels{75, 35};

struct DrawnDesign {
  std::size_t design = 0;
  std::size_t count = 1;  // designs that the mark stands for, itself included
};

// Keeps the first of the designs that lie in one cell of the figure, in their order. Designs on the
// front that differ by more than a dot, and the known routings, are always kept.
std::vector<DrawnDesign> thinned(const std::vector<PageDesign>& designs, const TwoObjectives& axes,
                                 const SpotGrid& grid = {});

// The edge of what the front attains in two objectives: through the spots that none beats in both,
// out to the worst of `shown`; each corner first across, then up or down. Empty without spots.
std::vector<Point> front_edge(const std::vector<Point>& front, const TwoObjectives& axes,
                              const std::vector<Point>& shown);

Point spot(const PageDesign& design, const TwoObjectives& axes);

// Returns the designs with which the live plot opens: those on the nearest spots about the designs
// that none beats in both. Returns none if there are only a few spots, or if they are all.
std::vector<PageDesign> about_the_front(const std::vector<PageDesign>& designs,
                                        const TwoObjectives& axes);

// The designs over two objectives, and below them those about the front, over `ranking` of which
// the front is; `advised` are marked.
LiveFigure pareto_figure(const std::vector<PageDesign>& designs,
                         const std::vector<Objective>& ranking,
                         const std::vector<AdvisedDesign>& advised = {});

// Returns the first two objectives of the ranking. If it has only one, uniformity or efficiency
// joins it.
TwoObjectives first_axes(const std::vector<Objective>& ranking);

// Lines of the best and of the known routings over these objectives, and in grey how many of all
// designs have a value.
LiveFigure parallel_figure(const std::vector<PageDesign>& designs,
                           const std::vector<Objective>& shown);

inline bool is_empty(const chart::Points& points) { return points.spots.empty(); }
inline bool is_empty(const chart::Paths& paths) { return paths.paths.empty(); }

// A layer for each kind of designs, the many below the few. In the legend the few come first:
// layers without marks stand there for them.
template <typename Marks>
std::vector<chart::Layer> kind_layers(const std::array<Marks, kind_count>& marks,
                                      chart::Style (*style)(DesignKind)) {
  constexpr std::array order{DesignKind::sample, DesignKind::listed, DesignKind::front,
                             DesignKind::known, DesignKind::named};
  std::vector<chart::Layer> layers;
  for (const DesignKind kind : order) {
    const Marks& some = marks[static_cast<std::size_t>(kind)];
    if (is_empty(some)) continue;
    layers.insert(layers.begin(), {design_kind_name(kind), style(kind), Marks{}});
    layers.push_back({design_kind_name(kind), style(kind), some});
  }
  return layers;
}

// How figures call a design.
inline std::string label(const PageDesign& design) {
  return design.name.empty() ? design.word : design.name + ": " + design.word;
}

}  // namespace reeve::pages
