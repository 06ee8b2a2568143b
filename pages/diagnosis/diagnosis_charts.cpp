#include "pages/diagnosis/diagnosis_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_axis.hpp"
#include "pages/diagnosis/diagnosis_labels.hpp"

namespace reeve::pages {
namespace {

constexpr double linear_to_N = 0.1;  // of the logarithmic scales: a slack strand reads 0

struct DrawnModel {
  const char* title;
  double ReadingMark::*predicted_N;
};

std::vector<DrawnModel> models(const DiagnosisReport& report) {
  if (report.result.causes.empty()) return {{"the model as it stands", &ReadingMark::before_N}};
  return {{"before: the model as it stands", &ReadingMark::before_N},
          {"after: the extended model", &ReadingMark::after_N}};
}

std::vector<std::string> routings(const std::vector<ReadingMark>& marks) {
  std::vector<std::string> found;
  for (const ReadingMark& mark : marks) {
    if (std::find(found.begin(), found.end(), mark.routing) == found.end()) {
      found.push_back(mark.routing);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string title(const ReadingMark& mark, double predicted_N, bool has_held_out) {
  const Reading& reading = *mark.reading;
  std::string text =
      fmt::format("{} {}, run {}, line {}", mark.routing, mark.strand, mark.run, reading.line);
  if (has_held_out) text += mark.held_out ? ", held out" : ", training";
  text += mark.grasp.empty() ? "\n" : fmt::format("\nheld fingers: {}; ", mark.grasp);
  text += reading.direction == Direction::pull ? "pull" : "release";
  if (reading.motor_tension_N) text += fmt::format("; motor {:.4g} N", *reading.motor_tension_N);
  return text +
         fmt::format("\nmeasured {:.4g} N, predicted {:.4g} N", mark.measured_N, predicted_N);
}

chart::Points points(const std::vector<ReadingMark>& marks, const DrawnModel& model,
                     const std::string& routing, bool held_out, bool has_held_out) {
  chart::Points points;
  for (const ReadingMark& mark : marks) {
    if (mark.routing != routing || mark.held_out != held_out) continue;
    const double predicted_N = mark.*model.predicted_N;
    points.spots.push_back(
        {predicted_N, mark.measured_N, title(mark, predicted_N, has_held_out), ""});
  }
  return points;
}

// Filled what no fit has seen, hollow what was fitted to; of one name, so that the legend has it
// once, filled where both are.
std::vector<chart::Layer> layers(const std::vector<ReadingMark>& marks, const DrawnModel& model,
                                 bool has_held_out) {
  std::vector<chart::Layer> layers;
  const std::vector<std::string> names = routings(marks);
  for (std::size_t i = 0; i < names.size(); ++i) {
    chart::Style style{chart::series_colour(i), chart::series_symbol(i), 3.2, 1.2, 0.9};
    const auto add = [&](bool held_out) {
      layers.push_back({names[i], style, points(marks, model, names[i], held_out, has_held_out)});
    };
    if (has_held_out) add(true);
    style.fill = 0;
    add(false);
  }
  return layers;
}

// What hollow and filled symbols mean; without marks, only for the legend.
void explain_filling(chart::Panel& panel) {
  chart::Style grey{chart::Colour::grey, chart::Symbol::circle, 3.2, 1.2, 0};
  panel.layers.push_back({"fitted to", grey, chart::Points{}});
  grey.fill = 0.9;
  panel.layers.push_back({"held out", grey, chart::Points{}});
}

chart::Extent tensions(const std::vector<ReadingMark>& marks) {
  chart::Extent extent;
  extent.add(0);
  for (const ReadingMark& mark : marks) {
    for (const double tension : {mark.measured_N, mark.before_N, mark.after_N}) extent.add(tension);
  }
  return extent;
}

chart::Panel panel(const std::vector<ReadingMark>& marks, const DrawnModel& model, double linear_to,
                   bool has_held_out) {
  const chart::Extent extent = tensions(marks);
  chart::Panel panel;
  panel.title = model.title;
  panel.x.title = "predicted, N";
  panel.y.title = "measured, N";
  panel.x.reaches = {extent.low, extent.high};
  panel.x.linear_to = linear_to;
  panel.one_scale = true;
  const chart::Style line{chart::Colour::grey, chart::Symbol::circle, 0, 1.5, 1, 1,
                          chart::Dash::dashed};
  panel.layers.push_back(
      {"", line,
       chart::Paths{{{{{extent.low, extent.low}, {extent.high, extent.high}}, ""}}, false}});
  for (chart::Layer& layer : layers(marks, model, has_held_out)) {
    panel.layers.push_back(std::move(layer));
  }
  return panel;
}

std::string drawn(const DiagnosisReport& report, const std::vector<ReadingMark>& marks,
                  double linear_to) {
  chart::Chart chart;
  const bool has_held_out = report.result.held_out_runs > 0;
  for (const DrawnModel& model : models(report)) {
    chart.panels.push_back(panel(marks, model, linear_to, has_held_out));
  }
  if (has_held_out) explain_filling(chart.panels.front());
  chart.alt = compared_alt(report);
  chart.width = chart.height = 270;
  chart.columns = chart.panels.size();
  return chart_svg(chart);
}

}  // namespace

Figure compared_figure(const DiagnosisReport& report, const std::vector<ReadingMark>& marks) {
  return {"compared", "Measured against predicted tension.",
          simulated_label(report) +
              "Each point is one sensor in one reading; on the dashed line both agree." +
              (report.result.held_out_runs == 0
                   ? ""
                   : " Hollow points were fitted to, filled ones are of runs that no fit has "
                     "seen.") +
              thinned_text(report, marks.size()),
          drawn(report, marks, 0)};
}

Figure compared_logarithmic_figure(const DiagnosisReport& report,
                                   const std::vector<ReadingMark>& marks) {
  return {"compared-logarithmic", "Measured against predicted tension, logarithmic.",
          simulated_label(report) +
              fmt::format("The same points; the scales are linear below {:g} N, so that 0 has a "
                          "place.",
                          linear_to_N) +
              thinned_text(report, marks.size()),
          drawn(report, marks, linear_to_N)};
}

std::string thinned_text(const DiagnosisReport& report, std::size_t drawn) {
  const std::size_t all = report.result.cells.size();
  if (drawn == all) return "";
  return fmt::format(
      " Drawn are {} of {} values, chosen evenly by a fixed rule; residuals.csv has "
      "all.",
      drawn, all);
}

}  // namespace reeve::pages
