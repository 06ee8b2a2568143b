#include <fmt/format.h>

#include <utility>

#include "drawing/chart/chart.hpp"
#include "pages/diagnosis/diagnosis_charts.hpp"
#include "pages/diagnosis/diagnosis_labels.hpp"

namespace reeve::pages {
namespace {

std::string interval(const EstimatedParameter& parameter) {
  return fmt::format("{:.4g} ({:.4g} to {:.4g})", parameter.value, parameter.low, parameter.high);
}

// A row for each thing that is known of the parameter.
chart::Panel panel(const NamedCause& cause, const EstimatedParameter& parameter) {
  chart::Panel panel;
  panel.title = cause.name;
  panel.x.title = parameter.unit == "1" ? parameter.name
                                        : fmt::format("{}, {}", parameter.name, parameter.unit);
  panel.y.categories = {"estimate", "nominal", "literature"};
  panel.y.grid = false;
  const std::string title = fmt::format("{} {}", parameter.name, interval(parameter));
  chart::Style ink{chart::Colour::ink, chart::Symbol::diamond, 5, 3};
  panel.layers = {
      {"", ink, chart::Spans{{{0, parameter.low, parameter.high, title}}, chart::Along::x, {}}},
      {"",
       {chart::Colour::blue, chart::Symbol::diamond, 5},
       chart::Points{{{parameter.value, 0, title, ""}}}}};
  if (parameter.nominal) {
    const chart::Style hollow{chart::Colour::blue, chart::Symbol::circle, 5, 2, 0};
    panel.layers.push_back(
        {"", hollow,
         chart::Points{
             {{*parameter.nominal, 1, fmt::format("nominal {:.4g}", *parameter.nominal), ""}}}});
  }
  if (parameter.literature) {
    const auto [low, high] = *parameter.literature;
    const chart::Style broad{chart::Colour::grey, chart::Symbol::circle, 5, 10, 1, 0.5};
    panel.layers.push_back(
        {"", broad,
         chart::Spans{{{2, low, high, fmt::format("literature {:.4g} to {:.4g}", low, high)}},
                      chart::Along::x,
                      {}}});
  }
  return panel;
}

}  // namespace

Figure parameters_figure(const DiagnosisReport& report) {
  chart::Chart chart;
  chart.alt = "Estimates with 95 % intervals:";
  for (const NamedCause& cause : report.result.causes) {
    for (const EstimatedParameter& parameter : cause.parameters) {
      chart.panels.push_back(panel(cause, parameter));
      chart.alt += fmt::format(" {} of {} {};", parameter.name, cause.name, interval(parameter));
    }
  }
  chart.width = 250;
  chart.height = 3 * row_px;
  chart.columns = 2;
  return {"parameters", "Sizes of the causes.",
          simulated_label(report) +
              "Diamond with bar: estimate and its 95 % interval. Circle: the nominal value, at "
              "which nothing would be wrong. Grey: the literature's range.",
          chart_svg(chart)};
}

}  // namespace reeve::pages
