// The 5–95 % bands of designs as bars both ways in a plot over two objectives.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reports/chart/chart.hpp"
#include "search/uncertainty/bands.hpp"

namespace reeve::pages {

// Where a design is drawn, at its nominal values.
struct BandedSpot {
  double x = 0;
  double y = 0;
  Bands bands;
  std::string name;
};

// More crosses than these hide each other.
inline constexpr std::size_t most_banded = 16;

// Of the first so many that have bands on these axes, each once; nothing where there is none.
std::vector<chart::Layer> band_layers(const std::vector<BandedSpot>& spots,
                                      const std::array<Objective, 2>& axes);

// What the caption says of them; "" where there is none.
std::string band_caption(const std::vector<chart::Layer>& layers);

}  // namespace reeve::pages
