#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_axis.hpp"
#include "pages/diagnosis/diagnosis_figures.hpp"
#include "pages/diagnosis/diagnosis_labels.hpp"

namespace reeve::pages {
namespace {

// In units of the noise: scales are linear up to here, and 95 % of noise lies within.
constexpr double linear_to = 2;
constexpr std::size_t most_bins = 8;

using Residual = double ReadingMark::*;

// Positions of the marks along the column; NaN for those that have no value of it.
struct PlacesAlong {
  std::vector<std::string> categories;  // in the order in which they come first; none for numbers
  std::vector<double> places;           // parallel to the marks
};

PlacesAlong along(const std::vector<ReadingMark>& marks, const MarkColumn& column) {
  PlacesAlong result;
  for (const ReadingMark& mark : marks) {
    if (column.category == nullptr) {
      result.places.push_back(column.number(*mark.reading).value_or(std::nan("")));
      continue;
    }
    std::vector<std::string>& known = result.categories;
    const auto found = std::ranges::find(known, mark.*column.category);
    result.places.push_back(static_cast<double>(found - known.begin()));
    if (found == known.end()) known.push_back(mark.*column.category);
  }
  return result;
}

std::string title(const ReadingMark& mark, double residual) {
  return fmt::format("{} {}, run {}, line {}\n{:+.3g} sd", mark.routing, mark.strand, mark.run,
                     mark.reading->line, residual);
}

chart::Layer points(const std::vector<ReadingMark>& marks, const PlacesAlong& along,
                    Residual residual) {
  chart::Points points;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const double value = marks[i].*residual;
    points.spots.push_back({along.places[i], value, title(marks[i], value), ""});
  }
  chart::Style style;
  style.size = 1.9;
  style.opacity = 0.5;
  return {"", style, points};
}

// The place at which each mark is counted: its category, or the middle of its bin.
std::vector<double> groups(const PlacesAlong& along) {
  if (!along.categories.empty()) return along.places;
  chart::Extent extent;
  for (const double place : along.places) extent.add(place);
  if (extent.empty() || extent.low == extent.high) return along.places;
  const double step = chart::nice_ticks(extent, most_bins + 1).step;
  std::vector<double> middles;
  for (const double place : along.places) {
    const double last = std::ceil(extent.high / step) - 1;
    middles.push_back((std::min(std::floor(place / step), last) + 0.5) * step);
  }
  return middles;
}

// Mean, and as far as a standard deviation to both sides, of each category or bin.
std::vector<chart::Layer> means(const std::vector<ReadingMark>& marks, const PlacesAlong& along,
                                Residual residual) {
  std::map<double, std::vector<double>> values;
  const std::vector<double> places = groups(along);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const double value = marks[i].*residual;
    if (std::isfinite(value) && std::isfinite(places[i])) values[places[i]].push_back(value);
  }
  chart::Spans spreads;
  chart::Points points;
  for (const auto& [place, group] : values) {
    const auto count = static_cast<double>(group.size());
    double mean = 0;
    for (const double value : group) mean += value / count;
    double squares = 0;
    for (const double value : group) squares += (value - mean) * (value - mean);
    const double spread = group.size() > 1 ? std::sqrt(squares / (count - 1)) : 0;
    const std::string title = fmt::format("mean {:+.3g} sd, standard deviation {:.3g} sd, of {}",
                                          mean, spread, group.size());
    spreads.spans.push_back({place, mean - spread, mean + spread, title});
    points.spots.push_back({place, mean, title, ""});
  }
  const chart::Style style{chart::Colour::orange, chart::Symbol::diamond, 4, 2};
  return {{"", style, spreads}, {"", style, points}};
}

chart::Panel panel(const std::vector<ReadingMark>& marks, const PlacesAlong& along,
                   Residual residual) {
  chart::Panel panel;
  panel.x.categories = along.categories;
  panel.x.grid = false;
  panel.y.title = "residual, sd of noise";
  panel.y.linear_to = linear_to;
  panel.y.reaches = {-3, 3};
  panel.y.format = chart::Format::with_sign;
  chart::Style band{chart::Colour::grey};
  band.fill = 0.15;
  panel.layers = {{"", band, chart::PanelBands{{{0, -linear_to, linear_to, ""}}, chart::Along::y}},
                  points(marks, along, residual)};
  append(panel.layers, means(marks, along, residual));
  return panel;
}

}  // namespace

Figure residual_figure(const DiagnosisReport& report, const std::vector<ReadingMark>& marks,
                       const MarkColumn& column) {
  const bool extended = !report.result.causes.empty();
  const PlacesAlong places = along(marks, column);
  chart::Chart chart;
  chart.panels.push_back(panel(marks, places, &ReadingMark::residual_before));
  chart.panels.front().heading = fmt::format("by {}", column.title);
  if (extended) {
    chart.panels.front().title = "before";
    chart.panels.push_back(panel(marks, places, &ReadingMark::residual_after));
    chart.panels.back().title = "after";
  }
  chart.alt = fmt::format(
      "Residuals in standard deviations of the noise over {}{}; in grey what 95 % of noise "
      "does.",
      column.title, extended ? ", before and after the model is extended" : "");
  chart.width = extended ? 126 : 260;
  chart.height = 170;
  chart.columns = 2;
  chart.shared_x = chart.shared_y = true;
  return {column.id, fmt::format("By {}.", column.title), simulated_label(report),
          chart_svg(chart)};
}

}  // namespace reeve::pages
