// What the plots of an exploration have in common: the order of the kinds of designs, their layers
// in the legend, and how a design is called.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "drawing/chart/chart.hpp"
#include "pages/exploration/exploration_designs.hpp"

namespace reeve::pages {

// The many below the few.
inline constexpr std::array<Kind, kind_count> drawing_order{Kind::sample, Kind::listed, Kind::front,
                                                            Kind::known};

inline bool is_empty(const chart::Points& points) { return points.spots.empty(); }
inline bool is_empty(const chart::Paths& paths) { return paths.paths.empty(); }

// Layers without marks, for the legend: there the few come first, which are drawn last.
template <typename Marks>
std::vector<chart::Layer> keys(const std::array<Marks, kind_count>& marks,
                               chart::Style (*style)(Kind)) {
  std::vector<chart::Layer> layers;
  for (auto kind = drawing_order.rbegin(); kind != drawing_order.rend(); ++kind) {
    if (is_empty(marks[static_cast<std::size_t>(*kind)])) continue;
    layers.push_back({design_kind_name(*kind), style(*kind), Marks{}});
  }
  return layers;
}

inline std::string label(const PageDesign& design) {
  return design.name.empty() ? design.word : design.name + ": " + design.word;
}

}  // namespace reeve::pages
