// A chart as values: panels with two axes each, and in them layers of marks; and its drawing.
//
//   chart::Chart chart;
//   chart.alt = "Measured over predicted tensions";  // for who cannot see it
//   chart::Panel panel;
//   panel.x.title = "predicted, N";
//   panel.y.title = "measured, N";
//   chart::Style hollow{chart::series_colour(0), chart::series_symbol(0)};
//   hollow.fill = 0;
//   panel.layers.push_back({"TR1", hollow, chart::Points{{{1.9, 2.1, "line 7: T1", ""}}}});
//   chart.panels.push_back(panel);
//   write_file("chart.svg", chart_svg(chart));
//
// What the writer sees to:
// - An axis reaches over all marks, and on to the next tick if that is near and possible.
// - Marks with a value that is no finite number are left out, and a line breaks there.
// - Layers are drawn in their order. Those of one name share an entry of the legend, where their
//   symbols lie over each other; without a name a layer has none. A layer without marks is in the
//   legend all the same, and explains what others look like.
// - `title` is what a reader sees who points at a mark; it may have several lines.
// - Labels lie beside their marks, and never over each other or beyond the frame; the first are
//   placed first, and one for which there is no room is left out.
// - The same chart gives the same bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "drawing/shapes.hpp"

namespace reeve::drawing::chart {

// Okabe and Ito's colours, which readers who are colour-blind tell apart; ink is the text's, and
// violet is for few marks that bear a label.
enum class Colour : std::uint8_t { blue, orange, green, pink, sky, amber, ink, grey, violet };

enum class Symbol : std::uint8_t { circle, square, triangle, diamond, cross, wedge, tick };

// On white. A page that shows a chart in the dark gives the classes reeve-blue, reeve-orange, …
// another `color`; reeve-chart has that of the ink.
struct NamedColour {
  Colour colour;
  const char* name;
  const char* on_white;
};

inline constexpr std::array<NamedColour, 9> colours{{{Colour::blue, "blue", "#0072b2"},
                                                     {Colour::orange, "orange", "#d55e00"},
                                                     {Colour::green, "green", "#009e73"},
                                                     {Colour::pink, "pink", "#cc79a7"},
                                                     {Colour::sky, "sky", "#56b4e9"},
                                                     {Colour::amber, "amber", "#e69f00"},
                                                     {Colour::ink, "ink", "#1a1a1a"},
                                                     {Colour::grey, "grey", "#808080"},
                                                     {Colour::violet, "violet", "#7b3fa0"}}};

// Colour and symbol of the i-th of several classes. Seven colours and six symbols are 42 pairs.
Colour series_colour(std::size_t i);
Symbol series_symbol(std::size_t i);

enum class Dash : std::uint8_t { solid, dashed, dotted };

struct Style {
  Colour colour = Colour::blue;
  Symbol symbol = Symbol::circle;
  double size = 4;    // half the width of a symbol, px
  double line = 1.5;  // width of lines and of outlines, px
  double fill = 1;    // opacity of symbols, bars, bands and ribbons inside their outline
  double opacity = 1;
  Dash dash = Dash::solid;
};

enum class Along : std::uint8_t { x, y };

// A point of the data. On an axis with categories 0, 1, … are their places.
struct Spot {
  double x = 0;
  double y = 0;
  std::string title;
  std::string label;
};

// A span from `low` to `high` on one axis, at the place `at` of the other.
struct Span {
  double at = 0;
  double low = 0;
  double high = 0;
  std::string title;
};

struct Polyline {
  std::vector<Point> through;  // points of the data
  std::string title;
};

// A value on one axis.
struct Level {
  double at = 0;
  std::string title;
  std::string label;
};

// Share of a category: several layers of bars or spans divide it into slots, and this is one of
// them.
struct Slot {
  std::size_t slot = 0;
  std::size_t slots = 1;
};

struct Points {
  std::vector<Spot> spots;
};

// Upright from 0, over categories.
struct Bars {
  std::vector<Spot> bars;
  Slot beside;
};

// Straight lines along an axis.
struct Spans {
  std::vector<Span> spans;
  Along along = Along::y;
  Slot beside;
};

// `steps`: first along x, then along y.
struct Paths {
  std::vector<Polyline> paths;
  bool steps = false;
};

// Areas between what is low and what is high at each place on the x axis; they break where there is
// no number.
struct Ribbon {
  std::vector<Span> through;  // their titles say nothing
  std::string title;
};

struct Ribbons {
  std::vector<Ribbon> ribbons;
};

// Across the whole panel, between two values on that axis.
struct PanelBands {
  std::vector<Span> bands;  // `at` says nothing
  Along on = Along::y;
};

// Lines across the whole panel, at a value on that axis.
struct Rules {
  std::vector<Level> rules;
  Along on = Along::x;
};

// The labels of these spots and no symbols, centred on their places whatever else lies there.
struct Texts {
  std::vector<Spot> texts;
};

using Marks = std::variant<Points, Bars, Spans, Paths, PanelBands, Rules, Texts, Ribbons>;

struct Layer {
  std::string name;  // name in the legend
  Style style;
  Marks marks;
};

enum class Format : std::uint8_t { plain, percent, with_sign };

struct Axis {
  std::string title;  // title with the unit: "motor tension, N"
  std::vector<std::string>
      categories;               // if there are any, the axis is of these; x: to the right, y: down
  std::optional<double> least;  // limit of possible values: no tick lies beyond
  std::optional<double> greatest;
  std::vector<double> reaches;  // values that lie on the axis whatever the marks do
  // Above 0: a value v lies at sign(v) ln(1 + |v| / linear_to), linear up to there and logarithmic
  // beyond.
  double linear_to = 0;
  bool whole = false;  // ticks at whole numbers only
  Format format = Format::plain;
  bool grid = true;
  bool hidden = false;  // neither ticks nor title; it ends where the marks do
};

struct Panel {
  std::string heading;  // begins a new row of panels, below this
  std::string title;
  Axis x;
  Axis y;
  bool one_scale = false;  // y is in all but its title as x, for what is to be compared with itself
  std::vector<Layer> layers;
};

// Panels of one size, in rows.
struct Chart {
  std::string alt;  // description in words
  std::vector<Panel> panels;
  std::size_t columns = 1;
  double width = 600;  // width of each panel's frame, px
  double height = 340;
  bool shared_y = false;  // one scale for all panels, with numbers at the first of each row only
  bool shared_x = false;  // one scale for all panels
};

}  // namespace reeve::drawing::chart

namespace reeve::drawing {

// Draws a chart as a file of SVG, on white.
//
// A page that inlines it may restyle the classes reeve-chart (its `color` is the ink), reeve-paper,
// reeve-grid and those of the colours: colours are attributes, which any style overrides. Marks are
// the elements inside reeve-points, reeve-bars, reeve-spans, reeve-paths, reeve-bands and
// reeve-rules; data-series says which series a group shows. No identifiers are in it, so a page can
// hold several.
std::string chart_svg(const chart::Chart& chart);

}  // namespace reeve::drawing
