// The geometry of random charts: no text over another, all within the picture, marks within their
// frames, and marks where the ticks say.
#include "drawing/chart/chart_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "numerics/random.hpp"

namespace reeve::drawing::chart {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Item {
  std::string text;
  Box box;
};

bool overlap_visibly(const Box& a, const Box& b) {
  constexpr double touch = 0.01;
  return a.left < b.right - touch && b.left < a.right - touch && a.top < b.bottom - touch &&
         b.top < a.bottom - touch;
}

bool within(const Box& box, const Box& room) {
  constexpr double hair = 0.01;
  return box.left >= room.left - hair && box.right <= room.right + hair &&
         box.top >= room.top - hair && box.bottom <= room.bottom + hair;
}

std::vector<Item> texts(const ChartLayout& layout) {
  std::vector<Item> items;
  const auto add = [&](const ChartText& text) {
    items.push_back({text.drawn.text, text.drawn.box});
  };
  for (const ChartText& heading : layout.headings) add(heading);
  for (const LaidPanel& panel : layout.panels) {
    for (const ChartText& text : panel.texts) add(text);
  }
  for (const std::vector<LaidLabel>& labels : layout.labels) {
    for (const LaidLabel& label : labels) add(label.text);
  }
  for (const LegendEntry& entry : layout.legend) {
    add(entry.text);
    items.push_back({"symbol of " + entry.text.drawn.text, entry.symbol});
  }
  return items;
}

void expect_tidy(const ChartLayout& layout) {
  ASSERT_TRUE(std::isfinite(layout.width) && std::isfinite(layout.height));
  const std::vector<Item> items = texts(layout);
  const Box picture{0, 0, layout.width, layout.height};
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_TRUE(within(items[i].box, picture)) << items[i].text;
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(overlap_visibly(items[i].box, items[k].box))
          << items[i].text << " | " << items[k].text;
    }
    for (const LaidPanel& panel : layout.panels) {
      const bool inside = within(items[i].box, panel.frame);
      EXPECT_TRUE(inside || !overlap_visibly(items[i].box, panel.frame)) << items[i].text;
    }
  }
  for (std::size_t p = 0; p < layout.panels.size(); ++p) {
    EXPECT_TRUE(within(layout.panels[p].frame, picture));
    for (const LaidLabel& label : layout.labels[p]) {
      EXPECT_TRUE(within(label.text.drawn.box, layout.panels[p].frame));
    }
  }
}

// The symbols of points; where bars stand on the frame those of small values may too.
void expect_marks_inside(const ChartLayout& layout) {
  for (const LaidPanel& laid : layout.panels) {
    for (const Layer& layer : laid.panel->layers) {
      const auto* points = std::get_if<Points>(&layer.marks);
      if (points == nullptr) continue;
      for (const Spot& spot : points->spots) {
        if (!can_be_drawn(spot.x) || !can_be_drawn(spot.y)) continue;
        const Point at = place(laid, spot.x, spot.y);
        const double size = layer.style.size;
        EXPECT_TRUE(within({at.x - size, at.y - size, at.x + size, at.y + size}, laid.frame))
            << spot.x << ", " << spot.y;
      }
    }
  }
}

std::string some_text(std::uint64_t seed, std::uint64_t i) {
  static const std::vector<std::string> pieces{"M-1-P-2-M",
                                               "Zugkraft",
                                               "µ",
                                               "wrong grasp",
                                               "W",
                                               "i.l",
                                               "<&\">",
                                               " ",
                                               "",
                                               "TR7",
                                               "1b-P-2b-P-3b-P-1b+4-P-5-P-4"};
  std::string text;
  const auto count = static_cast<std::uint64_t>(4 * uniform(seed, 11, i));
  for (std::uint64_t k = 0; k < count; ++k) {
    text += pieces[static_cast<std::size_t>(uniform(seed, 12, 10 * i + k) *
                                            static_cast<double>(pieces.size()))];
  }
  return text;
}

Axis some_axis(std::uint64_t seed, std::uint64_t i) {
  Axis axis;
  axis.title = some_text(seed, 100 + i);
  const double kind = uniform(seed, 13, i);
  if (kind < 0.3) {
    const auto count = static_cast<std::uint64_t>(1 + 15 * uniform(seed, 14, i));
    for (std::uint64_t k = 0; k < count; ++k) {
      axis.categories.push_back(some_text(seed, 200 + 20 * i + k));
    }
  } else if (kind < 0.5) {
    axis.linear_to = 2;
  } else if (kind < 0.6) {
    axis.whole = true;
  }
  if (kind > 0.9) axis.least = 0;
  if (kind > 0.95) axis.greatest = 1;
  axis.format = static_cast<Format>(static_cast<int>(3 * uniform(seed, 15, i)));
  return axis;
}

Points some_points(const Panel& panel, std::uint64_t seed, std::uint64_t i) {
  const auto coordinate = [&](const Axis& axis, std::uint32_t stream, std::uint64_t k) {
    if (!axis.categories.empty()) {
      return std::floor(uniform(seed, stream, k) * static_cast<double>(axis.categories.size()));
    }
    if (uniform(seed, stream + 1, k) < 0.03) return k % 2 == 0 ? none : infinite;
    return std::pow(10, 8 * uniform(seed, 16, i) - 3) * normal(seed, stream, k);
  };
  Points points;
  const auto count = static_cast<std::uint64_t>(40 * uniform(seed, 17, i));
  for (std::uint64_t k = 0; k < count; ++k) {
    points.spots.push_back({coordinate(panel.x, 20, 50 * i + k),
                            coordinate(panel.y, 22, 50 * i + k), "",
                            k < 6 ? some_text(seed, 400 + 50 * i + k) : ""});
  }
  return points;
}

Chart some_chart(std::uint64_t seed) {
  Chart chart;
  chart.columns = static_cast<std::size_t>(1 + 4 * uniform(seed, 1, 0));
  chart.width = 60 + 500 * uniform(seed, 1, 1);
  chart.height = 60 + 300 * uniform(seed, 1, 2);
  const bool categories = uniform(seed, 1, 3) < 0.5;
  chart.shared_y = !categories && uniform(seed, 1, 4) < 0.5;
  const auto count = static_cast<std::uint64_t>(1 + 5 * uniform(seed, 1, 5));
  for (std::uint64_t i = 0; i < count; ++i) {
    Panel panel;
    if (uniform(seed, 2, i) < 0.2) panel.heading = some_text(seed, 50 + i);
    panel.title = some_text(seed, 60 + i);
    panel.x = some_axis(seed, 2 * i);
    panel.y = some_axis(seed, 2 * i + 1);
    if (!categories) panel.x.categories = panel.y.categories = {};
    for (std::uint64_t k = 0; k < 3; ++k) {
      Style style{series_colour(k), series_symbol(k), 1 + 6 * uniform(seed, 3, k)};
      panel.layers.push_back({some_text(seed, 70 + k), style, some_points(panel, seed, 3 * i + k)});
    }
    chart.panels.push_back(std::move(panel));
  }
  return chart;
}

TEST(ChartLayout, KeepsTextsApartAndMarksInsideWhateverTheChart) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    const Chart chart = some_chart(seed);
    const ChartLayout laid = layout(chart);
    expect_tidy(laid);
    expect_marks_inside(laid);
  }
}

Chart of_points(const std::vector<double>& x, const std::vector<double>& y) {
  Points points;
  for (std::size_t i = 0; i < x.size(); ++i) points.spots.push_back({x[i], y[i], "", ""});
  Chart chart;
  chart.panels.resize(1);
  chart.panels[0].layers.push_back({"all", {}, points});
  return chart;
}

TEST(ChartLayout, TakesNothingOnePointAndPointsAllAlike) {
  for (const Chart& chart :
       {of_points({}, {}), of_points({0}, {0}), of_points({5, 5}, {-3, -3}),
        of_points({none, 1}, {2, none}), of_points({infinite, -infinite}, {1, 2}),
        of_points({1e300, 1}, {1, 2}), of_points({1e99, -1e99}, {1e-99, 2e-99}), Chart{}}) {
    const ChartLayout laid = layout(chart);
    expect_tidy(laid);
    expect_marks_inside(laid);
    for (const LaidPanel& panel : laid.panels) EXPECT_GE(panel.x.ticks.size(), 2U);
  }
}

TEST(ChartLayout, TakesLimitsRulesAndBandsThatAreNoNumbers) {
  Chart chart = of_points({1, 2}, {3, 4});
  Panel& panel = chart.panels[0];
  panel.x.reaches = {none, infinite};
  panel.layers.push_back({"", {}, Rules{{{none, "", "gone"}, {infinite, "", ""}}, Along::x}});
  panel.layers.push_back({"", {}, PanelBands{{{0, none, infinite, ""}}, Along::y}});
  const ChartLayout laid = layout(chart);
  expect_tidy(laid);
  EXPECT_EQ(laid.panels[0].x.scale.low, 1);
  EXPECT_EQ(laid.panels[0].x.scale.high, 2);
  EXPECT_TRUE(laid.labels[0].empty());
}

// What a reader does: from the two ticks beside a mark to its value.
TEST(ChartLayout, PutsMarksWhereTheTicksSay) {
  const Chart chart = of_points({0.31, 0.5, 0.77}, {12, 40, 33});
  const ChartLayout laid = layout(chart);
  const LaidPanel& panel = laid.panels.front();
  const auto read = [](const LaidAxis& axis, double at) {
    const Tick& a = axis.ticks[0];
    const Tick& b = axis.ticks[1];
    return std::stod(a.text) +
           (at - a.at) / (b.at - a.at) * (std::stod(b.text) - std::stod(a.text));
  };
  const auto& points = std::get<Points>(chart.panels[0].layers[0].marks);
  for (const Spot& spot : points.spots) {
    const Point at = place(panel, spot.x, spot.y);
    EXPECT_NEAR(read(panel.x, at.x), spot.x, 1e-9);
    EXPECT_NEAR(read(panel.y, at.y), spot.y, 1e-9);
  }
  EXPECT_LT(place(panel, 0, 40).y, place(panel, 0, 12).y);  // more is up
}

TEST(ChartLayout, SharesOneScaleWhereAsked) {
  Chart chart = of_points({1, 2}, {0, 1});
  chart.panels.push_back(of_points({1, 2}, {0, 50}).panels[0]);
  chart.columns = 2;
  EXPECT_NE(layout(chart).panels[0].y.scale.high, layout(chart).panels[1].y.scale.high);
  chart.shared_y = true;
  const ChartLayout shared = layout(chart);
  EXPECT_EQ(shared.panels[0].y.scale.high, shared.panels[1].y.scale.high);
  EXPECT_EQ(shared.panels[0].frame.top, shared.panels[1].frame.top);
  EXPECT_LT(shared.panels[1].texts.size(), shared.panels[0].texts.size());
}

TEST(ChartLayout, GivesOneScaleToWhatIsComparedWithItself) {
  Chart chart = of_points({1, 68}, {2, 30});
  chart.panels[0].one_scale = true;
  chart.width = chart.height = 300;
  const LaidPanel panel = layout(chart).panels.front();
  for (const double value : {0.0, 17.0, 68.0}) {
    const Point at = place(panel, value, value);
    EXPECT_NEAR(at.x - panel.frame.left, panel.frame.bottom - at.y, 1e-9);
  }
}

TEST(ChartLayout, BeginsARowAtAHeadingAndWhereTheColumnsEnd) {
  Chart chart;
  chart.panels.resize(4);
  chart.panels[0].heading = "(a)";
  chart.panels[3].heading = "(b)";
  chart.columns = 2;
  chart.width = 100;
  const ChartLayout laid = layout(chart);
  EXPECT_EQ(laid.headings.size(), 2U);
  EXPECT_EQ(laid.panels[0].frame.top, laid.panels[1].frame.top);
  EXPECT_GT(laid.panels[2].frame.top, laid.panels[1].frame.bottom);
  EXPECT_EQ(laid.panels[2].frame.left, laid.panels[0].frame.left);
  EXPECT_GT(laid.panels[3].frame.top, laid.headings[1].drawn.box.bottom);
  EXPECT_GT(laid.headings[1].drawn.box.top, laid.panels[2].frame.bottom);
}

TEST(ChartLayout, ReadsCategoriesFromTheTopDown) {
  Chart chart;
  chart.panels.resize(1);
  chart.panels[0].y.categories = {"best", "next"};
  const LaidPanel panel = layout(chart).panels.front();
  EXPECT_LT(panel.y.ticks[0].at, panel.y.ticks[1].at);
}

TEST(ChartLegend, GoesOnInAnotherRowWhereTheChartEnds) {
  Chart chart;
  chart.panels.resize(1);
  chart.width = 300;
  for (int i = 0; i < 12; ++i) {
    chart.panels[0].layers.push_back({"series number " + std::to_string(i), {}, Points{}});
  }
  const ChartLayout laid = layout(chart);
  EXPECT_LT(laid.width, 420);
  EXPECT_GT(laid.legend.back().symbol.top, laid.legend.front().symbol.bottom);
  expect_tidy(laid);
}

TEST(ChartLegend, NamesASeriesOnceWithAllItsSymbols) {
  Chart chart = of_points({1}, {1});
  chart.panels[0].layers[0].name = "model";
  chart.panels[0].layers.push_back({"model", {}, Paths{}});
  chart.panels[0].layers.push_back({"", {}, Points{}});
  chart.panels[0].layers.push_back({"what grey means", {}, Points{}});
  chart.panels.push_back(chart.panels[0]);
  const ChartLayout laid = layout(chart);
  ASSERT_EQ(laid.legend.size(), 2U);
  EXPECT_EQ(laid.legend[0].layers.size(), 2U);
  EXPECT_EQ(laid.legend[1].text.drawn.text, "what grey means");
}

}  // namespace
}  // namespace reeve::drawing::chart
