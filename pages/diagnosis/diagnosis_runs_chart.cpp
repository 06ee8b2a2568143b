#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drawing/chart/chart.hpp"
#include "pages/diagnosis/diagnosis_charts.hpp"
#include "pages/diagnosis/diagnosis_labels.hpp"

namespace reeve::pages {
namespace {

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

}  // namespace

Figure runs_figure(const DiagnosisReport& report) {
  const std::size_t all = report.result.run_gains.size();
  const std::size_t drawn = std::min(all, most_runs);
  const bool extended = !report.result.causes.empty();
  std::string caption = simulated_label(report) +
                        (extended ? "From the model as it stands to the extended one. " : "") +
                        "Grey ticks: what noise alone leaves on average.";
  if (all > drawn) {
    caption +=
        fmt::format(" Drawn are the first {} of {} runs; diagnosis.json has all.", drawn, all);
  }
  chart::Chart chart;
  chart.alt = fmt::format("Root mean square residuals of {} held-out runs{}, and of noise alone.",
                          all, extended ? ", before and after" : "");
  chart.width = 480;
  chart.height = row_px * static_cast<double>(drawn);
  chart.panels.push_back(panel(report, drawn, extended));
  return {"held-out-runs", "Each held-out run by itself.", caption, chart_svg(chart)};
}

}  // namespace reeve::pages
