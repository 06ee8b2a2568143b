#include "pages/distribution_figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/text.hpp"
#include "drawing/chart/chart.hpp"
#include "pages/routing_parts.hpp"
#include "pages/tension_charts.hpp"
#include "reports/document/document.hpp"

namespace reeve::pages {
namespace {

constexpr const char* model_name = "model";

using DistributionRows = std::vector<const TensionDistribution*>;

std::string measured(const TensionDistributions& all) {
  return all.data && all.data->simulated ? "simulated data" : "measured";
}

bool any(const DistributionRows& rows, bool (*of)(const StrandShare&)) {
  for (const TensionDistribution* row : rows) {
    for (const RoutingShares& routing : row->routings) {
      if (std::ranges::any_of(routing.strands, of)) return true;
    }
  }
  return false;
}

bool is_published(const StrandShare& strand) { return strand.published.has_value(); }
bool is_measured(const StrandShare& strand) { return strand.measured.has_value(); }
bool is_faulty(const StrandShare& strand) {
  return strand.published && !strand.published->fault.empty();
}

std::vector<std::string> headings(const TensionDistribution& row) {
  std::vector<NamedRouting> routings;
  for (const RoutingShares& routing : row.routings)
    routings.push_back({routing.name, routing.word});
  return labels(routings);
}

// Lines of what is published are hollow and dashed, for readers and printers without colours.
const chart::Style model_style{chart::Colour::blue, chart::Symbol::circle, 4, 2};
const chart::Style measured_style{chart::Colour::green, chart::Symbol::circle, 4, 1.2, 0.5};

chart::Style published_style(bool faulty) {
  chart::Style style{chart::Colour::orange, chart::Symbol::diamond, 5, 1.5, 0};
  if (faulty) style.symbol = chart::Symbol::triangle;
  return style;
}

std::string published_name(bool faulty) {
  return faulty ? "published, not found by the check" : "published";
}

// Symbols of those that the check finds, or of the others.
chart::Layer published_points(const RoutingShares& routing, bool faulty) {
  chart::Points points;
  for (std::size_t i = 0; i < routing.strands.size(); ++i) {
    const StrandShare& strand = routing.strands[i];
    if (!strand.published || is_faulty(strand) != faulty) continue;
    const std::string why = faulty ? "\n" + strand.published->fault : "";
    points.spots.push_back({static_cast<double>(i), strand.published->share,
                            fmt::format("{}, {}: {}{}", strand.strand, routing.published_source,
                                        percent(strand.published->share), why),
                            ""});
  }
  return {published_name(faulty), published_style(faulty), points};
}

chart::Layer published_line(const RoutingShares& routing) {
  chart::Polyline line;
  for (std::size_t i = 0; i < routing.strands.size(); ++i) {
    const StrandShare& strand = routing.strands[i];
    if (strand.published) {
      line.through.push_back({static_cast<double>(i), strand.published->share});
    }
  }
  chart::Style style = published_style(false);
  style.dash = chart::Dash::dashed;
  return {"", style, chart::Paths{{line}, false}};
}

// The means, and as far as a standard deviation to both sides.
std::vector<chart::Layer> measured_layers(const RoutingShares& routing, const std::string& name) {
  chart::Bars bars;
  chart::Spans deviations;
  for (std::size_t i = 0; i < routing.strands.size(); ++i) {
    const StrandShare& strand = routing.strands[i];
    if (!strand.measured) continue;
    const double mean = strand.measured->mean;
    const auto at = static_cast<double>(i);
    const std::string of =
        routing.readings == 1 ? "" : fmt::format(", mean of {} readings", routing.readings);
    bars.bars.push_back(
        {at, mean, fmt::format("{}, {}: {}{}", strand.strand, name, percent(mean), of), ""});
    if (!strand.measured->deviation) continue;
    const double deviation = *strand.measured->deviation;
    deviations.spans.push_back({at, mean - deviation, mean + deviation, ""});
  }
  chart::Style ink;
  ink.colour = chart::Colour::ink;
  return {{name, measured_style, bars}, {"", ink, deviations}};
}

std::vector<chart::Layer> model_layers(const RoutingShares& routing) {
  chart::Polyline line;
  chart::Points points;
  for (std::size_t i = 0; i < routing.strands.size(); ++i) {
    const StrandShare& strand = routing.strands[i];
    const auto at = static_cast<double>(i);
    line.through.push_back({at, strand.model});
    points.spots.push_back(
        {at, strand.model,
         fmt::format("{}, {}: {}", strand.strand, model_name, percent(strand.model)), ""});
  }
  return {{model_name, model_style, chart::Paths{{line}, false}},
          {model_name, model_style, points}};
}

chart::Panel panel(const RoutingShares& routing, const std::string& title,
                   const std::string& measured_name) {
  chart::Panel panel;
  panel.title = title;
  for (const StrandShare& strand : routing.strands) panel.x.categories.push_back(strand.strand);
  panel.x.grid = false;
  panel.y.title = "share of the sum";
  panel.y.format = chart::Format::percent;
  panel.y.least = 0;
  panel.y.greatest = 1;
  panel.y.reaches = {0};
  const auto add = [&](chart::Layer layer) { panel.layers.push_back(std::move(layer)); };
  if (!measured_name.empty()) {
    for (chart::Layer& layer : measured_layers(routing, measured_name)) add(std::move(layer));
  }
  if (std::ranges::any_of(routing.strands, is_published)) {
    add(published_line(routing));
    add(published_points(routing, false));
    if (std::ranges::any_of(routing.strands, is_faulty)) {
      add(published_points(routing, true));
    }
  }
  for (chart::Layer& layer : model_layers(routing)) add(std::move(layer));
  return panel;
}

char letter(std::size_t row) { return static_cast<char>('a' + row); }

std::string row_title(std::size_t row, const TensionDistribution& distribution) {
  const auto two = [&](const char* what) {
    const std::vector<std::string>& others = distribution.other_effects;
    return fmt::format("({}) {}: {}{}μ of tubes {:.2g}, of sheaths {:.2g}", letter(row), what,
                       fmt::join(others, ", "), others.empty() ? "" : "; ", distribution.tube_mu,
                       distribution.sheath_mu);
  };
  switch (distribution.kind) {
    case FrictionKind::coefficient:
      return fmt::format("({}) μ of tubes and sheaths {:g}", letter(row), distribution.tube_mu);
    case FrictionKind::model:
      return two("the nominal model");
    case FrictionKind::diagnosed:
      return two("as diagnosed");
  }
  return "";
}

chart::Chart drawn(const DistributionRows& rows, const TensionDistributions& all) {
  const std::string measured_name = any(rows, is_measured) ? measured(all) : "";
  chart::Chart chart;
  chart.shared_y = true;
  chart.height = 150;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<std::string> titles = headings(*rows[i]);
    for (std::size_t k = 0; k < titles.size(); ++k) {
      chart.panels.push_back(panel(rows[i]->routings[k], titles[k], measured_name));
      if (k == 0) chart.panels.back().heading = row_title(i, *rows[i]);
    }
    chart.width = panel_width(rows[i]->routings.front().strands.size());
    chart.columns = columns(chart.width, titles.size());
  }
  return chart;
}

std::string alt(const DistributionRows& rows) {
  std::string text = "Strand tensions as shares of their sum.";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += " " + row_title(i, *rows[i]) + ", model:";
    for (const RoutingShares& routing : rows[i]->routings) {
      text += " " + (routing.name.empty() ? routing.word : routing.name);
      for (const StrandShare& strand : routing.strands) {
        text += " " + fixed(100 * strand.model, 0);
      }
      text += " %;";
    }
  }
  return text;
}

// "(a) 16.2 %, (b) 6.0 %"; "" if there is none.
std::string errors_text(const DistributionRows& rows,
                        std::optional<double> MeanShareErrors::*which) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::optional<double> error = rows[i]->share_errors.*which;
    if (!error) continue;
    text += fmt::format("{}({}) {}", text.empty() ? "" : ", ", letter(i), percent(*error));
  }
  return text;
}

std::string measured_text(const DistributionRows& rows, const TensionDistributions& all) {
  const bool mean = any(rows, [](const StrandShare& strand) {
    return strand.measured && strand.measured->deviation;
  });
  std::string text = all.data->simulated ? " Bars: simulated data, of no rig" : " Bars: measured";
  text += mean ? ", mean of the readings ± their standard deviation." : ".";
  text +=
      " The root of the summed squared differences of the shares, averaged over the routings, "
      "is of the model in " +
      errors_text(rows, &MeanShareErrors::model);
  const std::string published = errors_text(rows, &MeanShareErrors::published);
  if (!published.empty()) text += "; of what is published in " + published;
  return text + ".";
}

// "" where no routing has a choice of grasps.
std::string grasp_of(const DistributionRows& rows) {
  const Grasp grasp = rows.front()->grasp;
  const bool one_finger = std::ranges::all_of(rows, [](const TensionDistribution* distribution) {
    return std::ranges::all_of(distribution->routings, [](const RoutingShares& routing) {
      return routing.strands.size() <= 2;
    });
  });
  return one_finger && grasp.held == 0 ? "" : grasp_words(grasp);
}

std::string caption(const DistributionRows& rows, const TensionDistributions& all) {
  const std::string grasp = grasp_of(rows);
  std::string text = (grasp.empty() ? "Pulling" : "With " + grasp + ", pulling") +
                     "; the strands of each routing add up to 100 %. Line and circles: "
                     "the model.";
  if (any(rows, is_published)) {
    text += " Dashed line and diamonds: what is printed of the routing for these coefficients.";
  }
  if (any(rows, is_faulty)) {
    text +=
        " Triangles: printed values that the check does not find, mostly for a fault of the "
        "source.";
  }
  if (any(rows, is_measured)) text += measured_text(rows, all);
  const bool sensors =
      std::ranges::any_of(rows, [](const TensionDistribution* row) { return row->sensors_differ; });
  if (sensors) text += " What is wrong with the sensors is in the bars and not in the lines.";
  return text;
}

std::vector<DistributionRows> by_grasp(const TensionDistributions& all) {
  std::vector<DistributionRows> groups;
  for (const TensionDistribution& distribution : all.list) {
    if (groups.empty() || !(groups.back().front()->grasp == distribution.grasp)) {
      groups.emplace_back();
    }
    groups.back().push_back(&distribution);
  }
  return groups;
}

}  // namespace

std::vector<Figure> distribution_figures(const TensionDistributions& distributions) {
  std::vector<Figure> figures;
  for (const DistributionRows& rows : by_grasp(distributions)) {
    const std::string id =
        figures.empty() ? "figure-9" : "figure-9-" + grasp_id(rows.front()->grasp);
    chart::Chart chart = drawn(rows, distributions);
    chart.alt = alt(rows);
    const std::string grasp = grasp_of(rows);
    figures.push_back({id, "Tension distributions" + (grasp.empty() ? "" : ", " + grasp) + ".",
                       caption(rows, distributions), chart_svg(chart)});
  }
  return figures;
}

}  // namespace reeve::pages
