#include <fmt/format.h>

#include <utility>

#include "drawing/chart/chart.hpp"
#include "pages/diagnosis/diagnosis_figures.hpp"
#include "pages/diagnosis/diagnosis_labels.hpp"
#include "reports/data_text.hpp"

namespace reeve::pages {
namespace {

std::string axis_title(const AxisName& axis) {
  return axis.unit.empty() || axis.unit == "1" ? axis.name
                                               : fmt::format("{}, {}", axis.name, axis.unit);
}

std::string title(const DiagnosisReport& report, const PartialResiduals& partial,
                  const PartialPoint& point) {
  const Reading& reading = report.data.readings[point.reading];
  return fmt::format("run {}, line {}{}\n{} {:.4g}\n{} {:+.3g} (sd {:.2g})",
                     report.data.runs[reading.run], reading.line,
                     point.held_out ? ", held out" : "", axis_title(partial.x), point.x,
                     axis_title(partial.y), point.y, point.deviation);
}

// Points that no fit has seen are filled, as everywhere on the page.
chart::Layer points(const DiagnosisReport& report, const PartialResiduals& partial, bool held_out) {
  chart::Points points;
  for (const PartialPoint& point : partial.points) {
    if (point.held_out != held_out) continue;
    points.spots.push_back({point.x, point.y, title(report, partial, point), ""});
  }
  const chart::Style fitted{chart::Colour::blue, chart::Symbol::circle, 2.6, 1.1, 0, 0.8};
  const chart::Style unseen{chart::Colour::green, chart::Symbol::diamond, 3.6, 1.1, 0.9};
  return {held_out ? "held out" : "fitted to", held_out ? unseen : fitted, std::move(points)};
}

bool has_held_out(const PartialResiduals& partial) { return partial.points.back().held_out; }

chart::Layer band(const PartialResiduals& partial) {
  chart::Ribbon ribbon{{}, "95 % band"};
  for (const CurvePoint& at : partial.curve) {
    ribbon.through.push_back({at.x, at.low, at.high, ""});
  }
  chart::Style style{chart::Colour::orange};
  style.line = 0;
  style.fill = 0.25;
  return {"95 % band", style, chart::Ribbons{{std::move(ribbon)}}};
}

chart::Layer curve(const PartialResiduals& partial) {
  chart::Polyline line{{}, "fitted"};
  for (const CurvePoint& at : partial.curve) line.through.push_back({at.x, at.y});
  chart::Style style{chart::Colour::orange};
  style.line = 2;
  return {"fitted", style, chart::Paths{{std::move(line)}, false}};
}

std::string counts_text(const PartialResiduals& partial) {
  std::string text;
  if (partial.left_out > 0) {
    text += fmt::format(" Not drawn: {} that hardly depend{} on it.",
                        plural(partial.left_out, "point"), partial.left_out == 1 ? "s" : "");
  }
  if (partial.thinned > 0) {
    text += fmt::format(" Drawn are {} of {} points, chosen evenly by a fixed rule.",
                        partial.points.size(), partial.points.size() + partial.thinned);
  }
  return text;
}

}  // namespace

Figure partial_figure(const DiagnosisReport& report, const std::string& id, const std::string& name,
                      const PartialResiduals& partial) {
  chart::Panel panel;
  panel.x.title = axis_title(partial.x);
  panel.y.title = axis_title(partial.y);
  panel.y.reaches = {0};
  panel.y.format = chart::Format::with_sign;
  const chart::Style nominal{chart::Colour::grey, chart::Symbol::circle, 0, 1.2, 1, 1,
                             chart::Dash::dashed};
  panel.layers.push_back(
      {"without it", nominal, chart::Rules{{{0, "without it", ""}}, chart::Along::y}});
  panel.layers.push_back(band(partial));
  panel.layers.push_back(points(report, partial, false));
  if (has_held_out(partial)) panel.layers.push_back(points(report, partial, true));
  panel.layers.push_back(curve(partial));
  chart::Chart chart;
  chart.alt =
      fmt::format("{} over {}: {} and the fitted curve with its 95 % band.", axis_title(partial.y),
                  axis_title(partial.x), plural(partial.points.size(), "point"));
  chart.width = 300;
  chart.height = 200;
  chart.panels.push_back(std::move(panel));
  return {id, name + ".", simulated_label(report) + counts_text(partial), chart_svg(chart)};
}

}  // namespace reeve::pages
