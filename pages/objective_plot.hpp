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

// Where a design is drawn, at its nominal values.
struct BandedSpot {
  double x = 0;
  double y = 0;
  Bands bands;
  std::string name;
};

// More crosses than these hide each other.
inline constexpr std::size_t most_banded = 16;

// What the points of the plot span along both axes. Bars reach at most half of that beyond them, so
// that points stay apart that one chooses by; of one place alone they are whole.
using PointsSpan = std::array<chart::Extent, 2>;

struct BandBars {
  std::vector<chart::Layer> layers;
  bool cut = false;  // some reach further than they are drawn
};

// Of the first so many that have bands on these axes, each once; nothing where there is none.
BandBars band_bars(const std::vector<BandedSpot>& spots, const std::array<Objective, 2>& axes,
                   const PointsSpan& points);

// What the caption says of them; "" where there is none.
std::string band_caption(const BandBars& bars);

}  // namespace reeve::pages
