#include "pages/diagnosis/diagnosis_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_axis.hpp"
#include "pages/diagnosis/diagnosis_labels.hpp"

namespace reeve::pages {
namespace {

// linear part of the logarithmic scales: a slack strand reads 0
constexpr double linear_to_N = 0.1;

struct FigureModel {
  const char* title;
  double ReadingMark::*predicted_N;
};

std::vector<FigureModel> models(const DiagnosisReport& report) {
  if (report.result.causes.empty()) return {{"the nominal model", &ReadingMark::before_N}};
  return {{"before: the nominal model", &ReadingMark::before_N},
          {"after: the extended model", &ReadingMark::after_N}};
}

std::vector<std::string> routings(const std::vector<ReadingMark>& marks) {
  std::vector<std::string> found;
  for (const ReadingMark& mark : marks) {
    if (std::ranges::find(found, mark.routing) == found.end()) {
      found.push_back(mark.routing);
    }
  }
  std::ranges::sort(found);
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

chart::Points points(const std::vector<ReadingMark>& marks, const FigureModel& model,
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
std::vector<chart::Layer> layers(const std::vector<ReadingMark>& marks, const FigureModel& model,
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

// Explains hollow and filled symbols in the legend; it draws no marks.
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

chart::Panel panel(const std::vector<ReadingMark>& marks, const FigureModel& model,
                   double linear_to, bool has_held_out) {
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
  append(panel.layers, layers(marks, model, has_held_out));
  return panel;
}

std::string drawn(const DiagnosisReport& report, const std::vector<ReadingMark>& marks,
                  double linear_to) {
  chart::Chart chart;
  const bool has_held_out = report.result.held_out_runs > 0;
  for (const FigureModel& model : models(report)) {
    chart.panels.push_back(panel(marks, model, linear_to, has_held_out));
  }
  if (has_held_out) explain_filling(chart.panels.front());
  chart.alt = compared_alt(report);
  chart.width = chart.height = 270;
  chart.columns = chart.panels.size();
  return chart_svg(chart);
}

constexpr std::size_t most_runs = 40;

std::string title(const std::string& run, const RunGain& gain, bool extended) {
  std::string text = fmt::format("run {}: {} measured values\nbefore {:.3g} N", run, gain.cells,
                                 gain.rms_before_N);
  if (extended) text += fmt::format(", after {:.3g} N", gain.rms_after_N);
  return text + fmt::format("\nnoise alone {:.3g} N", gain.rms_noise_N);
}

chart::Panel panel(const DiagnosisReport& report, std::size_t runs, bool extended) {
  chart::Panel panel;
  panel.x.title = "root mean square residual, N";
  panel.x.least = 0;
  panel.x.reaches = {0};
  panel.y.title = "run";
  chart::Spans gains{{}, chart::Along::x, {}};
  chart::Points noise;
  chart::Points before;
  chart::Points after;
  for (std::size_t i = 0; i < runs; ++i) {
    const RunGain& gain = report.result.run_gains[i];
    const std::string& run = report.data.runs[gain.run];
    const std::string text = title(run, gain, extended);
    const auto at = static_cast<double>(i);
    panel.y.categories.push_back(run);
    gains.spans.push_back({at, gain.rms_before_N, gain.rms_after_N, text});
    noise.spots.push_back({gain.rms_noise_N, at, text, ""});
    before.spots.push_back({gain.rms_before_N, at, text, ""});
    after.spots.push_back({gain.rms_after_N, at, text, ""});
  }
  chart::Style ink{chart::Colour::ink};
  if (extended) panel.layers.push_back({"", ink, gains});
  panel.layers.push_back({"noise alone", {chart::Colour::grey, chart::Symbol::tick, 6}, noise});
  panel.layers.push_back({"before", {chart::Colour::blue, chart::Symbol::circle, 5}, before});
  if (extended) {
    panel.layers.push_back({"after", {chart::Colour::orange, chart::Symbol::diamond, 5}, after});
  }
  return panel;
}

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

Figure runs_figure(const DiagnosisReport& report) {
  const std::size_t all = report.result.run_gains.size();
  const std::size_t drawn = std::min(all, most_runs);
  const bool extended = !report.result.causes.empty();
  std::string caption = simulated_label(report) +
                        (extended ? "From the nominal model to the extended one. " : "") +
                        "Grey ticks: what noise alone leaves on average.";
  if (all > drawn) {
    caption +=
        fmt::format(" Drawn are the first {} of {} runs; diagnosis.json has all.", drawn, all);
  }
  chart::Chart chart;
  chart.alt = fmt::format("Root mean square residuals of {} held-out runs{}, and of noise alone.",
                          all, extended ? ", before and after" : "");
  chart.width = 330;
  chart.height = row_px * static_cast<double>(drawn);
  chart.panels.push_back(panel(report, drawn, extended));
  return {"held-out-runs", "Each held-out run by itself.", caption, chart_svg(chart)};
}

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
