#include <fmt/format.h>

#include <algorithm>

#include "drawing/chart/chart.hpp"
#include "reports/data_text.hpp"
#include "reports/import_report.hpp"

namespace reeve::reports {
namespace {

// Number of steps of the chart in time; a reader cannot see finer ones.
constexpr std::size_t most_steps = 600;

class LogChart {
 public:
  explicit LogChart(const ImportReport& report) : report_(report), series_(report.series) {
    lay_out_time();
  }

  std::string draw() {
    chart::Chart chart;
    chart.alt = fmt::format(
        "Motion and tensions of {} over time, with {} shaded where they were taken; below, why the "
        "other samples were left out.",
        series_.file, plural(report_.steady.readings.size(), "reading"));
    if (series_.position_mm.is_logged()) {
      add_panel(chart, "position, mm", {&series_.position_mm});
    } else if (series_.speed_mm_s.is_logged()) {
      add_panel(chart, "speed, mm/s", {&series_.speed_mm_s});
    }
    std::vector<const LoggedSignal*> tensions;
    if (series_.motor_tension_N.is_logged()) tensions.push_back(&series_.motor_tension_N);
    for (const LoggedSignal& tension : series_.tensions_N) tensions.push_back(&tension);
    add_panel(chart, "tension, N", tensions);
    chart.panels.push_back(uses());
    chart.panels.back().x.title = restarts_ ? "time, s, one recording behind the other" : "time, s";
    chart.width = 700;
    chart.height = 190;
    chart.shared_x = true;
    return chart_svg(chart);
  }

 private:
  // If the clock is set back, time goes on from the latest time before.
  void lay_out_time() {
    double offset = 0;
    for (std::size_t i = 0; i < series_.size(); ++i) {
      if (i > 0 && series_.time_s[i] < series_.time_s[i - 1]) {
        offset = times_.back() - series_.time_s[i] + report_.steady.usual_step_s;
        restarts_ = true;
      }
      times_.push_back(series_.time_s[i] + offset);
    }
    step_ = std::max<std::size_t>(1, series_.size() / most_steps);
  }

  void add_panel(chart::Chart& chart, const std::string& title,
                 const std::vector<const LoggedSignal*>& signals) const {
    chart::Panel panel;
    panel.y.title = title;
    panel.layers = {taken(Direction::pull), taken(Direction::release)};
    for (std::size_t i = 0; i < signals.size(); ++i) {
      chart::Style style{chart::series_colour(i)};
      style.line = 1;
      panel.layers.push_back({named(*signals[i]), style, chart::Paths{{path(*signals[i])}}});
    }
    chart.panels.push_back(panel);
  }

  // The only signal of its panel is what the axis says.
  std::string named(const LoggedSignal& signal) const {
    if (&signal == &series_.position_mm || &signal == &series_.speed_mm_s) return "";
    return &signal == &series_.motor_tension_N ? "motor tension" : tension_words(signal);
  }

  chart::Layer taken(Direction direction) const {
    const bool pull = direction == Direction::pull;
    chart::PanelBands bands;
    bands.on = chart::Along::x;
    for (const SteadyReading& reading : report_.steady.readings) {
      if (reading.direction != direction) continue;
      bands.bands.push_back(
          {0, times_[reading.begin], times_[reading.end - 1],
           fmt::format("{}, {}", direction_field(direction), plural(reading.samples, "sample"))});
    }
    chart::Style style{pull ? chart::Colour::green : chart::Colour::amber};
    style.fill = pull ? 0.15 : 0.25;
    style.line = 0;
    return {pull ? "taken, pulling" : "taken, releasing", style, bands};
  }

  // The least and the greatest of every few samples, in their order, so that spikes stay.
  chart::Polyline path(const LoggedSignal& signal) const {
    chart::Polyline line;
    const auto add = [&](std::size_t i) { line.through.push_back({times_[i], signal.values[i]}); };
    for (std::size_t begin = 0; begin < series_.size(); begin += step_) {
      const std::size_t end = std::min(begin + step_, series_.size());
      std::size_t least = begin;
      std::size_t greatest = begin;
      for (std::size_t i = begin; i < end; ++i) {
        if (!(signal.values[least] <= signal.values[i])) least = i;
        if (!(signal.values[greatest] >= signal.values[i])) greatest = i;
      }
      add(std::min(least, greatest));
      if (least != greatest) add(std::max(least, greatest));
    }
    return line;
  }

  chart::Panel uses() const {
    chart::Panel panel;
    panel.y.grid = false;
    const std::vector<std::size_t> counts = count_uses(report_.steady.uses);
    chart::Spans spans;
    spans.along = chart::Along::x;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (counts[i] == 0) continue;
      add_spans(spans, all_sample_uses[i], panel.y.categories.size());
      panel.y.categories.push_back(
          fmt::format("{} ({})", sample_use_words(all_sample_uses[i]), counts[i]));
    }
    chart::Style style{chart::Colour::ink};
    style.line = 5;
    panel.layers = {{"", style, spans}};
    return panel;
  }

  // Stretches that a reader would see as one are drawn as one.
  void add_spans(chart::Spans& spans, SampleUse use, std::size_t category) const {
    const double near = (times_.back() - times_.front()) / most_steps;
    const std::size_t first = spans.spans.size();
    for (std::size_t i = 0; i < series_.size(); ++i) {
      if (report_.steady.uses[i] != use) continue;
      if (spans.spans.size() == first || times_[i] > spans.spans.back().high + near) {
        spans.spans.push_back({static_cast<double>(category), times_[i], times_[i], ""});
      }
      spans.spans.back().high = times_[i];
    }
    for (std::size_t i = first; i < spans.spans.size(); ++i) {
      chart::Span& span = spans.spans[i];
      span.high = std::max(span.high, span.low + near);
    }
  }

  const ImportReport& report_;
  const LoggedSeries& series_;
  std::vector<double> times_;
  bool restarts_ = false;
  std::size_t step_ = 1;
};

}  // namespace

std::string log_svg(const ImportReport& report) { return LogChart(report).draw(); }

}  // namespace reeve::reports
