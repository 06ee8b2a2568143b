#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "drawing/chart/chart.hpp"
#include "pages/exploration/exploration_designs.hpp"
#include "pages/objective_plot.hpp"
#include "pages/page_words.hpp"
#include "pages/ranking_parts.hpp"
#include "pages/routing_parts.hpp"
#include "pages/tension_charts.hpp"
#include "reports/document/document.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/shown_value.hpp"

namespace reeve::pages {
namespace {

// Beyond this only the front's points have their names beside them.
constexpr std::size_t most_labels = 12;
constexpr std::size_t most_names = 3;

using Axes = std::pair<Objective, Objective>;

Axes axes(const std::vector<Objective>& objectives) {
  if (objectives.size() > 1) return {objectives[0], objectives[1]};
  const Objective first = objectives.front();
  return {first, first == Objective::uniformity_mean ? Objective::efficiency_mean
                                                     : Objective::uniformity_mean};
}

// Designs that lie on one point.
struct SharedSpot {
  double x = 0;
  double y = 0;
  bool on_front = false;
  std::vector<std::string> names;
  Bands bands;  // bands of the first of them
};

bool reads_alike(Objective objective, double one, double other) {
  return objective_text(objective, one) == objective_text(objective, other);
}

std::vector<SharedSpot> points(const RankReport& report, const Labels& labels, const Axes& axes) {
  std::vector<SharedSpot> result;
  for (std::size_t i = 0; i < report.designs.size(); ++i) {
    const RankedDesign& ranked = report.designs[i].ranked;
    const double x = value(ranked.design.values, axes.first);
    const double y = value(ranked.design.values, axes.second);
    auto found = std::ranges::find_if(result, [&](const SharedSpot& point) {
      return reads_alike(axes.first, point.x, x) && reads_alike(axes.second, point.y, y);
    });
    if (found == result.end())
      found = result.insert(found, {x, y, false, {}, report.designs[i].bands});
    found->on_front = found->on_front || ranked.front == 1;
    found->names.push_back(labels[i]);
  }
  return result;
}

std::string shortened(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < most_names; ++i) {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  if (names.size() > most_names) text += fmt::format(" and {} more", names.size() - most_names);
  return text;
}

chart::Spot spot(const SharedSpot& point, const Axes& on, bool labelled) {
  const std::string names = shortened(point.names);
  const auto line = [](Objective objective, double value) {
    return fmt::format("\n{} {}", objective_title(row(objective)),
                       objective_text(objective, value));
  };
  return {point.x, point.y, names + line(on.first, point.x) + line(on.second, point.y),
          labelled ? names : ""};
}

std::string rank_alt(const RankReport& report, const Labels& labels) {
  std::string text = "Range of each routing's rank over the draws.";
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const RankDistribution& drawn = *report.designs[i].distribution;
    text += fmt::format(" {}: median {}, {} to {}.", labels[i], fixed(drawn.median, 0),
                        fixed(drawn.low, 0), fixed(drawn.high, 0));
  }
  return text;
}

}  // namespace

Figure pareto_figure(const RankReport& report, const Labels& labels) {
  const Axes on = axes(report.order.objectives);
  const bool all_named = labels.size() <= most_labels;
  std::string alt = fmt::format("{} against {}.", objective_title(row(on.second)),
                                objective_title(row(on.first)));
  chart::Points front;
  chart::Points dominated;
  std::vector<BandedSpot> banded;
  PointsSpan span;
  for (const SharedSpot& point : points(report, labels, on)) {
    if (all_named || point.on_front) {
      banded.push_back({point.x, point.y, point.bands, shortened(point.names)});
    }
    span[0].add(point.x);
    span[1].add(point.y);
    (point.on_front ? front : dominated)
        .spots.push_back(spot(point, on, all_named || point.on_front));
    alt += fmt::format(" {}: {}, {}.", shortened(point.names), objective_text(on.first, point.x),
                       objective_text(on.second, point.y));
  }
  std::string caption = "Routings on one point share its label.";
  if (!all_named) caption += " Only those on the Pareto front are labelled.";
  if (report.order.objectives.size() > 2) {
    caption += " The front is over " + objective_titles(report.order.objectives) +
               "; the first two of them are drawn.";
  }
  chart::Panel panel;
  panel.x = objective_axis(on.first, cost_unit(report.prices));
  panel.y = objective_axis(on.second, cost_unit(report.prices));
  chart::Style best = design_style(DesignKind::front);
  chart::Style other = design_style(DesignKind::listed);
  best.size = other.size = 5;
  other.opacity = 1;
  const BandBars bars = band_bars(banded, {on.first, on.second}, span);
  panel.layers = bars.layers;
  caption += band_caption(bars);
  panel.layers.push_back({"on the Pareto front", best, front});
  panel.layers.push_back({"dominated", other, dominated});
  chart::Chart chart;
  chart.alt = alt;
  chart.panels.push_back(std::move(panel));
  return {"pareto", "The routings over two objectives.", caption, chart_svg(chart)};
}

Figure rank_figure(const RankReport& report, const Labels& labels) {
  chart::Panel panel;
  panel.x.title = "rank";
  panel.x.least = 1;
  panel.x.greatest = static_cast<double>(labels.size());
  panel.x.reaches = {1, *panel.x.greatest};
  panel.x.whole = true;
  panel.y.categories = labels;
  panel.y.grid = false;
  chart::Spans ranges{{}, chart::Along::x, {}};
  chart::Points medians;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const RankDistribution& drawn = *report.designs[i].distribution;
    const auto at = static_cast<double>(i);
    const std::string title =
        fmt::format("{}\nmedian rank {:g}\n5 % to 95 %: {:g} to {:g}\nfirst in {} of the draws",
                    labels[i], drawn.median, drawn.low, drawn.high, share_text(drawn.first));
    ranges.spans.push_back({at, drawn.low, drawn.high, title});
    medians.spots.push_back({drawn.median, at, title, ""});
  }
  chart::Style line;
  line.line = 4;
  line.opacity = 0.6;
  panel.layers = {{"5 % to 95 % of the draws", line, ranges},
                  {"median", {chart::Colour::blue, chart::Symbol::circle, 5}, medians}};
  chart::Chart chart;
  chart.alt = rank_alt(report, labels);
  chart.width = 480;
  chart.height = 24 * static_cast<double>(labels.size());
  chart.panels.push_back(std::move(panel));
  return {"ranks", "Rank where the coefficients are drawn from their ranges.",
          "Point: median; line: 5 % to 95 % of the draws.", chart_svg(chart)};
}

Figure tensions_figure(const std::vector<ShownRouting>& routings, const Labels& labels,
                       std::size_t grasp, std::size_t most) {
  std::vector<TensionPanel> panels;
  const Grasp held = routings.front().grasps[grasp].grasp;
  for (std::size_t i = 0; i < routings.size() && i < most; ++i) {
    panels.push_back({labels[i], &routings[i].network, &routings[i].grasps[grasp].state});
  }
  chart::Chart chart = tension_chart(panels);
  chart.alt = "Bars of strand tensions, " + grasp_words(held) + "." + chart.alt;
  return {"tensions-" + grasp_id(held), "Strand tensions, " + grasp_words(held) + ".",
          "At a motor tension of 1; colours tell the fingers apart.", chart_svg(chart)};
}

}  // namespace reeve::pages
