#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_axis.hpp"
#include "pages/exploration/exploration_figures.hpp"
#include "pages/page_words.hpp"
#include "reports/data_text.hpp"

namespace reeve::pages {
namespace {

// number of best designs: more lines cannot be told apart
constexpr std::size_t parallel_lines = 30;
constexpr std::size_t density_bins = 24;
constexpr double parallel_height = 330;

// The best, and all known routings.
std::vector<std::size_t> with_lines(const std::vector<PageDesign>& designs) {
  std::vector<std::size_t> picked;
  std::size_t best = 0;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const bool ranked = designs[i].rank > 0 && best < parallel_lines;
    best += ranked ? 1 : 0;
    if (ranked || designs[i].kind == DesignKind::known) picked.push_back(i);
  }
  return picked;
}

chart::Style line_style(DesignKind kind) {
  const chart::Style point = design_style(kind);
  chart::Style style;
  style.colour = point.colour;
  style.line = kind == DesignKind::front || kind == DesignKind::known ? 2 : 1.2;
  style.opacity = kind == DesignKind::listed ? 0.7 : 1;
  if (kind == DesignKind::known) style.dash = chart::Dash::dashed;
  return style;
}

// From 0, the worst, to 1, the best of the designs.
struct DesignHeights {
  std::array<chart::Extent, objective_count> extents;

  explicit DesignHeights(const std::vector<PageDesign>& designs) {
    for (const PageDesign& design : designs) {
      for (std::size_t i = 0; i < objective_count; ++i) extents[i].add(design.values[i]);
    }
  }

  double operator()(const PageDesign& design, std::size_t i) const {
    const chart::Extent& extent = extents[i];
    if (extent.low >= extent.high) return 0.5;
    const double share = (design.values[i] - extent.low) / (extent.high - extent.low);
    return objective_table()[i].better == Better::higher ? share : 1 - share;
  }
};

// Bars across an axis, the wider the more designs have such a value: their width is the square root
// of the share in the fullest, so that a few show beside thousands.
chart::Paths density(const DesignHeights& heights, const std::vector<PageDesign>& designs,
                     const std::vector<Objective>& shown) {
  chart::Paths bars;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    std::vector<std::size_t> counts(density_bins);
    for (const PageDesign& design : designs) {
      const double at = heights(design, static_cast<std::size_t>(shown[k]));
      if (!std::isfinite(at)) continue;
      const auto bin = static_cast<std::size_t>(at * density_bins);
      ++counts[std::min(bin, density_bins - 1)];
    }
    const std::size_t most = *std::ranges::max_element(counts);
    for (std::size_t bin = 0; bin < density_bins; ++bin) {
      if (counts[bin] == 0) continue;
      const double half =
          0.36 * std::sqrt(static_cast<double>(counts[bin]) / static_cast<double>(most));
      const auto at = static_cast<double>(k);
      const double height = (static_cast<double>(bin) + 0.5) / density_bins;
      bars.paths.push_back(
          {{{at - half, height}, {at + half, height}}, plural(counts[bin], "design")});
    }
  }
  return bars;
}

// The best value above each axis, the worst below.
chart::Texts ends(const DesignHeights& heights, const std::vector<Objective>& shown) {
  constexpr double beyond = 0.055;
  chart::Texts texts;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const chart::Extent& extent = heights.extents[static_cast<std::size_t>(shown[k])];
    if (extent.empty()) continue;
    const bool up = row(shown[k]).better == Better::higher;
    const auto at = static_cast<double>(k);
    texts.texts.push_back({at, 1 + beyond, "", four_digits(up ? extent.high : extent.low)});
    texts.texts.push_back({at, -beyond, "", four_digits(up ? extent.low : extent.high)});
  }
  return texts;
}

chart::Panel parallel_panel(const std::vector<PageDesign>& designs,
                            const std::vector<std::size_t>& picked,
                            const std::vector<Objective>& shown) {
  const DesignHeights heights(designs);
  chart::Panel panel;
  for (const Objective objective : shown) {
    panel.x.categories.push_back(objective_title(row(objective)) +
                                 (row(objective).better == Better::higher ? "" : " (inverted)"));
  }
  panel.y.hidden = true;
  panel.y.reaches = {-0.11, 1.11};
  chart::Style grey{chart::Colour::grey};
  grey.line = 0.9 * parallel_height / density_bins;
  grey.opacity = 0.35;
  panel.layers = {{"how many designs", grey, density(heights, designs, shown)}};
  std::array<chart::Paths, kind_count> paths;
  for (auto i = picked.rbegin(); i != picked.rend(); ++i) {
    const PageDesign& design = designs[*i];
    chart::Polyline line{{}, label(design)};
    for (std::size_t k = 0; k < shown.size(); ++k) {
      line.through.push_back(
          {static_cast<double>(k), heights(design, static_cast<std::size_t>(shown[k]))});
    }
    paths[static_cast<std::size_t>(design.kind)].paths.push_back(std::move(line));
  }
  append(panel.layers, kind_layers(paths, line_style));
  chart::Style ink;
  ink.colour = chart::Colour::ink;
  panel.layers.push_back({"", ink, ends(heights, shown)});
  return panel;
}

}  // namespace

LiveFigure parallel_figure(const std::vector<PageDesign>& designs,
                           const std::vector<Objective>& shown) {
  const std::vector<std::size_t> picked = with_lines(designs);
  chart::Chart chart;
  chart.width = 760;
  chart.height = parallel_height;
  chart.panels.push_back(parallel_panel(designs, picked, shown));
  chart.alt = fmt::format(
      "Parallel coordinates of all objectives: lines of {}, the best and the known routings, over "
      "grey bars that show where all {} lie.",
      plural(picked.size(), "design"), designs.size());
  return {{"parallel", "Designs by all objectives.",
           fmt::format(
               "Lines: the best {} and the known routings, {} in all; grey bars: where all {} lie, "
               "the wider the more. Up is better on every axis: where less is better the axis is "
               "turned round. The numbers are the best and the worst value.",
               parallel_lines, picked.size(), designs.size()),
           chart_svg(chart)},
          chart.alt};
}

}  // namespace reeve::pages
