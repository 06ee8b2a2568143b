#include "pages/exploration/exploration_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "drawing/chart/chart.hpp"
#include "drawing/chart/chart_axis.hpp"
#include "pages/band_spans.hpp"
#include "pages/exploration/design_layers.hpp"
#include "pages/exploration/objective_axis.hpp"
#include "pages/exploration/objective_title.hpp"
#include "pages/exploration/phrases.hpp"
#include "reports/data_text.hpp"

namespace reeve::pages {
namespace {

std::string title(const PageDesign& design, const TwoObjectives& axes, std::size_t count) {
  std::string text = label(design) + "\n";
  text += design.rank > 0 ? fmt::format("rank {}", design.rank) : design_kind_name(design.kind);
  for (const Objective objective : axes) {
    text += fmt::format("\n{} {}", objective_title(row(objective)),
                        four_digits(value(design.values, objective)));
  }
  if (count > 1) text += fmt::format("\nand {} more in this spot", count - 1);
  return text;
}

// Known routings that share a spot share their label, which the first of them bears.
std::map<std::size_t, std::string> known_labels(const std::vector<PageDesign>& designs,
                                                const std::vector<DrawnDesign>& drawn,
                                                const TwoObjectives& axes) {
  struct Shared {
    std::size_t first;
    std::vector<std::string> names;
  };
  std::map<std::string, Shared> spots;
  for (const DrawnDesign& each : drawn) {
    const PageDesign& design = designs[each.design];
    if (design.kind != Kind::known) continue;
    const Point at = spot(design, axes);
    Shared& shared =
        spots.try_emplace(fmt::format("{:.3g} {:.3g}", at.x, at.y), Shared{each.design, {}})
            .first->second;
    shared.names.push_back(design.name.empty() ? design.word : design.name);
  }
  std::map<std::size_t, std::string> labels;
  for (auto& [at, shared] : spots) {
    std::sort(shared.names.begin(), shared.names.end());
    labels[shared.first] = fmt::format("{}", fmt::join(shared.names, ", "));
  }
  return labels;
}

chart::Paths edge_of_front(const std::vector<PageDesign>& designs, const TwoObjectives& axes) {
  std::vector<Point> front;
  std::vector<Point> all;
  for (const PageDesign& design : designs) {
    all.push_back(spot(design, axes));
    if (design.front == 1) front.push_back(all.back());
  }
  return {{{front_edge(front, axes, all), "edge of the front"}}, true};
}

bool has_front(const std::vector<PageDesign>& designs) {
  return std::any_of(designs.begin(), designs.end(),
                     [](const PageDesign& design) { return design.front == 1; });
}

// The live plot, of other axes, has the line where the first has none.
std::string edge_caption(bool drawn, bool front) {
  if (!front) return "";
  return drawn
             ? "The dashed line is the edge of the Pareto front, drawn where both axes are what the "
               "ranking counts. "
             : "Where both axes are what the ranking counts, a dashed line is the edge of the "
               "Pareto front. ";
}

PointsSpan span(const std::vector<PageDesign>& designs, const TwoObjectives& axes) {
  PointsSpan points;
  for (const PageDesign& design : designs) {
    const Point at = spot(design, axes);
    points[0].add(at.x);
    points[1].add(at.y);
  }
  return points;
}

bool counts(const std::vector<Objective>& ranking, const TwoObjectives& axes) {
  return std::all_of(axes.begin(), axes.end(), [&](Objective axis) {
    return std::find(ranking.begin(), ranking.end(), axis) != ranking.end();
  });
}

std::vector<chart::Layer> point_layers(const std::vector<PageDesign>& designs,
                                       const std::vector<DrawnDesign>& drawn,
                                       const TwoObjectives& axes) {
  std::map<std::size_t, std::string> labels = known_labels(designs, drawn, axes);
  std::array<chart::Points, kind_count> points;
  // The best last, above the others.
  for (auto each = drawn.rbegin(); each != drawn.rend(); ++each) {
    const PageDesign& design = designs[each->design];
    const Point at = spot(design, axes);
    points[static_cast<std::size_t>(design.kind)].spots.push_back(
        {at.x, at.y, title(design, axes, each->count), labels[each->design]});
  }
  std::vector<chart::Layer> layers = keys<chart::Points>(points, design_style);
  for (const Kind kind : drawing_order) {
    chart::Points& some = points[static_cast<std::size_t>(kind)];
    if (!some.spots.empty())
      layers.push_back({design_kind_name(kind), design_style(kind), std::move(some)});
  }
  return layers;
}

// Of known routings and of the front, whose values one chooses by.
std::vector<BandedSpot> banded(const std::vector<PageDesign>& designs,
                               const std::vector<DrawnDesign>& drawn, const TwoObjectives& axes) {
  std::vector<BandedSpot> spots;
  for (const DrawnDesign& each : drawn) {
    const PageDesign& design = designs[each.design];
    if (design.kind != Kind::front && design.kind != Kind::known) continue;
    const Point at = spot(design, axes);
    spots.push_back({at.x, at.y, design.bands, label(design)});
  }
  return spots;
}

}  // namespace

TwoObjectives first_axes(const std::vector<Objective>& ranking) {
  if (ranking.size() > 1) return {ranking[0], ranking[1]};
  const Objective first = ranking.front();
  return {first, first == Objective::efficiency_mean ? Objective::uniformity_mean
                                                     : Objective::efficiency_mean};
}

ExplorationPicture pareto_picture(const std::vector<PageDesign>& designs,
                                  const std::vector<Objective>& ranking,
                                  const std::vector<AdvisedDesign>& advised) {
  const TwoObjectives axes = first_axes(ranking);
  const std::vector<DrawnDesign> drawn = thinned(designs, axes);
  chart::Panel panel;
  panel.x = objective_axis(axes[0]);
  panel.y = objective_axis(axes[1]);
  const bool has_edge = counts(ranking, axes) && has_front(designs);
  if (has_edge) {
    chart::Style dashed{chart::Colour::orange};
    dashed.dash = chart::Dash::dashed;
    panel.layers.push_back({"", dashed, edge_of_front(designs, axes)});
  }
  const BandBars bands = band_bars(banded(designs, drawn, axes), axes, span(designs, axes));
  panel.layers.insert(panel.layers.end(), bands.layers.begin(), bands.layers.end());
  for (chart::Layer& layer : point_layers(designs, drawn, axes)) {
    panel.layers.push_back(std::move(layer));
  }
  chart::Points rings;
  for (const AdvisedDesign& design : advised) {
    const auto found = std::find_if(designs.begin(), designs.end(), [&](const PageDesign& each) {
      return each.word == design.word;
    });
    if (found == designs.end()) continue;
    const Point at = spot(*found, axes);
    rings.spots.push_back({at.x, at.y, title(*found, axes, 1), design.label});
  }
  if (!rings.spots.empty()) panel.layers.push_back({"advised", advised_style(), rings});
  chart::Chart chart;
  chart.height = 430;
  chart.width = 640;
  chart.alt = fmt::format("Scatter plot of the designs over {}; {} marks stand for {} designs.",
                          objective_titles(ranking), drawn.size(), designs.size());
  chart.panels.push_back(std::move(panel));
  return {{"pareto", "Designs by two objectives.",
           edge_caption(has_edge, has_front(designs)) +
               "Where several designs share a spot, the first is drawn." + band_caption(bands),
           chart_svg(chart)},
          chart.alt};
}

}  // namespace reeve::pages
