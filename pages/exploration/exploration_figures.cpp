#include "pages/exploration/exploration_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "drawing/chart/chart_axis.hpp"
#include "pages/objective_plot.hpp"
#include "pages/page_words.hpp"

namespace reeve::pages {
namespace {

// Shares of the way from the least to the greatest.
double share(double value, const chart::Extent& extent) {
  return extent.high > extent.low ? (value - extent.low) / (extent.high - extent.low) : 0.5;
}

// Kind, column and line; known routings and named designs have cells of their own.
using GridCell = std::tuple<int, double, double>;

GridCell grid_cell(const PageDesign& design, std::size_t index, const Point& at,
                   const SpotGrid& grid) {
  const int kind = static_cast<int>(design.kind);
  if (design.kind == DesignKind::known || design.kind == DesignKind::named) {
    return {kind, static_cast<double>(index), 0};
  }
  const double finer = design.kind == DesignKind::front ? 5 : 1;
  return {kind, std::round(at.x * grid.columns * finer), std::round(at.y * grid.lines * finer)};
}

bool has_place(Point at) { return std::isfinite(at.x) && std::isfinite(at.y); }

template <typename Choose>
Point reduced(const std::vector<Point>& points, Choose choose) {
  Point result = points.front();
  for (const Point& at : points) result = {choose(result.x, at.x), choose(result.y, at.y)};
  return result;
}

// Returns the points that none beats in both values, the greatest x first; greater is better.
std::vector<Point> unbeaten(std::vector<Point> points) {
  std::ranges::sort(
      points, [](const Point& a, const Point& b) { return a.x != b.x ? a.x > b.x : a.y > b.y; });
  std::vector<Point> edge;
  for (const Point& at : points) {
    if (edge.empty() || at.y > edge.back().y) edge.push_back(at);
  }
  return edge;
}

// Turned so that greater is better.
Point turned(Point at, const TwoObjectives& axes) {
  const auto up = [](Objective objective) { return row(objective).better == Better::higher; };
  return {up(axes[0]) ? at.x : -at.x, up(axes[1]) ? at.y : -at.y};
}

// Returns where designs lie, turned so that greater is better, each place once.
std::vector<Point> distinct_places(const std::vector<PageDesign>& designs,
                                   const TwoObjectives& axes) {
  std::set<std::pair<double, double>> places;
  for (const PageDesign& design : designs) {
    const Point at = turned(spot(design, axes), axes);
    if (has_place(at)) places.insert({at.x, at.y});
  }
  std::vector<Point> points;
  for (const auto& [x, y] : places) points.push_back({x, y});
  return points;
}

// How far a place lies from the box of the unbeaten ones, in shares of what all span, by the axis
// along which it lies farther.
class FrontDistance {
 public:
  explicit FrontDistance(const std::vector<Point>& places)
      : worst_(reduced(places, [](double a, double b) { return std::min(a, b); })),
        best_(reduced(places, [](double a, double b) { return std::max(a, b); })),
        low_(reduced(unbeaten(places), [](double a, double b) { return std::min(a, b); })) {}

  double operator()(Point at) const {
    return std::max({0.0, share_below(low_.x - at.x, best_.x - worst_.x),
                     share_below(low_.y - at.y, best_.y - worst_.y)});
  }

 private:
  static double share_below(double below, double span) { return span > 0 ? below / span : 0; }

  Point worst_;
  Point best_;
  Point low_;
};

std::string title(const PageDesign& design, const TwoObjectives& axes, std::size_t count) {
  std::string text = label(design) + "\n";
  text += design.rank > 0 ? fmt::format("rank {}", design.rank) : design_kind_name(design.kind);
  for (const Objective objective : axes) {
    text += fmt::format("\n{} {}", objective_title(row(objective)),
                        four_digits(value(design.values, objective)));
  }
  if (count > 1) text += fmt::format("\nand {} more in this spot", count - 1);
  return text;
}

// Known routings that share a spot share their label, which the first of them bears.
std::map<std::size_t, std::string> known_labels(const std::vector<PageDesign>& designs,
                                                const std::vector<DrawnDesign>& drawn,
                                                const TwoObjectives& axes) {
  struct Shared {
    std::size_t first;
    std::vector<std::string> names;
  };
  std::map<std::string, Shared> spots;
  for (const DrawnDesign& each : drawn) {
    const PageDesign& design = designs[each.design];
    if (design.kind != DesignKind::known) continue;
    const Point at = spot(design, axes);
    Shared& shared =
        spots.try_emplace(fmt::format("{:.3g} {:.3g}", at.x, at.y), Shared{each.design, {}})
            .first->second;
    shared.names.push_back(design.name.empty() ? design.word : design.name);
  }
  std::map<std::size_t, std::string> labels;
  for (auto& [at, shared] : spots) {
    std::ranges::sort(shared.names);
    labels[shared.first] = fmt::format("{}", fmt::join(shared.names, ", "));
  }
  return labels;
}

chart::Paths edge_of_front(const std::vector<PageDesign>& designs, const TwoObjectives& axes) {
  std::vector<Point> front;
  std::vector<Point> all;
  for (const PageDesign& design : designs) {
    all.push_back(spot(design, axes));
    if (design.front == 1) front.push_back(all.back());
  }
  return {{{front_edge(front, axes, all), "edge of the front"}}, true};
}

bool has_front(const std::vector<PageDesign>& designs) {
  return std::ranges::any_of(designs, [](const PageDesign& design) { return design.front == 1; });
}

// The live plot, of other axes, has the line where the first has none.
std::string edge_caption(bool drawn, bool front) {
  if (!front) return "";
  return drawn
             ? "The dashed line is the edge of the Pareto front, drawn where both axes are what the "
               "ranking counts. "
             : "Where both axes are what the ranking counts, a dashed line is the edge of the "
               "Pareto front. ";
}

PointsSpan span(const std::vector<PageDesign>& designs, const TwoObjectives& axes) {
  PointsSpan points;
  for (const PageDesign& design : designs) {
    const Point at = spot(design, axes);
    points[0].add(at.x);
    points[1].add(at.y);
  }
  return points;
}

bool counts(const std::vector<Objective>& ranking, const TwoObjectives& axes) {
  return std::ranges::all_of(
      axes, [&](Objective axis) { return std::ranges::find(ranking, axis) != ranking.end(); });
}

std::vector<chart::Layer> point_layers(const std::vector<PageDesign>& designs,
                                       const std::vector<DrawnDesign>& drawn,
                                       const TwoObjectives& axes) {
  std::map<std::size_t, std::string> labels = known_labels(designs, drawn, axes);
  std::array<chart::Points, kind_count> points;
  // The best last, above the others.
  for (auto each = drawn.rbegin(); each != drawn.rend(); ++each) {
    const PageDesign& design = designs[each->design];
    const Point at = spot(design, axes);
    points[static_cast<std::size_t>(design.kind)].spots.push_back(
        {at.x, at.y, title(design, axes, each->count), labels[each->design]});
  }
  return kind_layers(points, design_style);
}

// Returns the known routings and the front, among whose values a reader chooses.
std::vector<BandedSpot> banded(const std::vector<PageDesign>& designs,
                               const std::vector<DrawnDesign>& drawn, const TwoObjectives& axes) {
  std::vector<BandedSpot> spots;
  for (const DrawnDesign& each : drawn) {
    const PageDesign& design = designs[each.design];
    if (design.kind != DesignKind::front && design.kind != DesignKind::known) continue;
    const Point at = spot(design, axes);
    spots.push_back({at.x, at.y, design.bands, label(design)});
  }
  return spots;
}

}  // namespace

Point spot(const PageDesign& design, const TwoObjectives& axes) {
  return {value(design.values, axes[0]), value(design.values, axes[1])};
}

std::vector<DrawnDesign> thinned(const std::vector<PageDesign>& designs, const TwoObjectives& axes,
                                 const SpotGrid& grid) {
  chart::Extent x;
  chart::Extent y;
  for (const PageDesign& design : designs) {
    x.add(spot(design, axes).x);
    y.add(spot(design, axes).y);
  }
  std::vector<DrawnDesign> drawn;
  std::map<GridCell, std::size_t> cells;  // place in `drawn`
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const Point at = spot(designs[i], axes);
    const Point within{share(at.x, x), share(at.y, y)};
    const auto [found, is_new] =
        cells.try_emplace(grid_cell(designs[i], i, within, grid), drawn.size());
    if (is_new) {
      drawn.push_back({i, 1});
    } else {
      ++drawn[found->second].count;
    }
  }
  return drawn;
}

std::vector<Point> front_edge(const std::vector<Point>& front, const TwoObjectives& axes,
                              const std::vector<Point>& shown) {
  if (front.empty()) return {};
  std::vector<Point> sorted;
  for (const Point& at : front) sorted.push_back(turned(at, axes));
  const std::vector<Point> edge = unbeaten(std::move(sorted));
  Point worst = edge.back();
  for (const Point& at : shown) {
    worst.x = std::min(worst.x, turned(at, axes).x);
    worst.y = std::min(worst.y, turned(at, axes).y);
  }
  std::vector<Point> line{{edge.front().x, worst.y}};
  line.insert(line.end(), edge.begin(), edge.end());
  line.push_back({worst.x, edge.back().y});
  for (Point& at : line) at = turned(at, axes);
  return line;
}

TwoObjectives first_axes(const std::vector<Objective>& ranking) {
  if (ranking.size() > 1) return {ranking[0], ranking[1]};
  const Objective first = ranking.front();
  return {first, first == Objective::efficiency_mean ? Objective::uniformity_mean
                                                     : Objective::efficiency_mean};
}

namespace {

struct ParetoPanel {
  chart::Panel panel;
  std::size_t marks = 0;
  bool has_edge = false;
  std::string bands;  // the caption's words on the bands
};

ParetoPanel pareto_panel(const std::vector<PageDesign>& designs,
                         const std::vector<Objective>& ranking, const TwoObjectives& axes,
                         const std::vector<AdvisedDesign>& advised, const SpotGrid& grid) {
  const std::vector<DrawnDesign> drawn = thinned(designs, axes, grid);
  const BandBars bands = band_bars(banded(designs, drawn, axes), axes, span(designs, axes));
  ParetoPanel made{
      {}, drawn.size(), counts(ranking, axes) && has_front(designs), band_caption(bands)};
  chart::Panel& panel = made.panel;
  panel.x = objective_axis(axes[0]);
  panel.y = objective_axis(axes[1]);
  if (made.has_edge) {
    chart::Style dashed{chart::Colour::orange};
    dashed.dash = chart::Dash::dashed;
    panel.layers.push_back({"", dashed, edge_of_front(designs, axes)});
  }
  panel.layers.insert(panel.layers.end(), bands.layers.begin(), bands.layers.end());
  append(panel.layers, point_layers(designs, drawn, axes));
  chart::Points rings;
  for (const AdvisedDesign& design : advised) {
    const auto found = std::ranges::find(designs, design.word, &PageDesign::word);
    if (found == designs.end()) continue;
    const Point at = spot(*found, axes);
    rings.spots.push_back({at.x, at.y, title(*found, axes, 1), design.label});
  }
  if (!rings.spots.empty()) panel.layers.push_back({"advised", advised_style(), rings});
  return made;
}

}  // namespace

std::vector<PageDesign> about_the_front(const std::vector<PageDesign>& designs,
                                        const TwoObjectives& axes) {
  constexpr std::size_t nearest = 8;  // places; fewer need no window of their own
  const std::vector<Point> places = distinct_places(designs, axes);
  if (places.size() <= nearest) return {};
  const FrontDistance distance(places);
  std::vector<double> distances;
  for (const Point& at : places) distances.push_back(distance(at));
  std::nth_element(distances.begin(), distances.begin() + nearest - 1, distances.end());
  const double limit = distances[nearest - 1];
  std::vector<PageDesign> near;
  for (const PageDesign& design : designs) {
    const Point at = turned(spot(design, axes), axes);
    if (has_place(at) && distance(at) <= limit) near.push_back(design);
  }
  if (near.size() == designs.size()) return {};
  return near;
}

LiveFigure pareto_figure(const std::vector<PageDesign>& designs,
                         const std::vector<Objective>& ranking,
                         const std::vector<AdvisedDesign>& advised) {
  const TwoObjectives axes = first_axes(ranking);
  const std::vector<PageDesign> near = about_the_front(designs, axes);
  const SpotGrid grid = near.empty() ? SpotGrid{} : of_two_panels;
  ParetoPanel all = pareto_panel(designs, ranking, axes, advised, grid);
  chart::Chart chart;
  chart.height = near.empty() ? 430 : 300;
  chart.width = 640;
  chart.alt = fmt::format("Scatter plot of the designs over {}; {} marks stand for {} designs.",
                          objective_titles(ranking), all.marks, designs.size());
  if (!near.empty()) {
    all.panel.title = "all";
    chart.alt += " Below it those about the front.";
  }
  chart.panels.push_back(std::move(all.panel));
  if (!near.empty()) {
    chart.panels.push_back(pareto_panel(near, ranking, axes, advised, grid).panel);
    chart.panels.back().title = "about the front";
  }
  return {{"pareto", "Designs by two objectives.",
           edge_caption(all.has_edge, has_front(designs)) +
               "Where several designs share a spot, the first is drawn." + all.bands,
           chart_svg(chart)},
          chart.alt};
}

}  // namespace reeve::pages
