// A plot over objectives: its axes, and the 5–95 % bands of designs as bars both ways.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_axis.hpp"
#include "search/evaluate/objectives.hpp"
#include "search/uncertainty/bands.hpp"

namespace reeve::pages {

// Named with its unit and which way is better; no longer than what the objective can be.
chart::Axis objective_axis(Objective objective, const std::string& cost_unit = "");

// Position of a design in the plot, at its nominal values.
struct BandedSpot {
  double x = 0;
  double y = 0;
  Bands bands;
  std::string name;
};

// More crosses than these hide each other.
inline constexpr std::size_t most_banded = 16;

// Span of the plot's points along both axes. Bars reach at most half of it beyond them, so that the
// points stay apart. If all points coincide, the bars are whole.
using PointsSpan = std::array<chart::Extent, 2>;

struct BandBars {
  std::vector<chart::Layer> layers;
  bool cut = false;  // some reach further than they are drawn
};

// Returns the bars of the first designs that have bands on these axes, each once; nothing if there
// are none.
BandBars band_bars(const std::vector<BandedSpot>& spots, const std::array<Objective, 2>& axes,
                   const PointsSpan& points);

// Returns the caption's words on the bars; "" if there are none.
std::string band_caption(const BandBars& bars);

}  // namespace reeve::pages
