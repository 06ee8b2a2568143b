#include "pages/sweep_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "drawing/chart/chart.hpp"
#include "pages/objective_plot.hpp"
#include "pages/page_words.hpp"
#include "pages/shell/template.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/exploration/sweep_report.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::pages {
namespace {

constexpr std::size_t distinct_colours = 7;

// Designs whose curves are the same to what can be seen.
struct SharedCurve {
  const SweepCurve* curve;
  std::string names;
};

bool look_alike(const SweepCurve& a, const SweepCurve& b) {
  const auto same = [](double one, double other) { return fixed(one) == fixed(other); };
  if (!std::equal(a.values.begin(), a.values.end(), b.values.begin(), same)) return false;
  return std::equal(a.bands.begin(), a.bands.end(), b.bands.begin(),
                    [&](const Band& one, const Band& other) {
                      return same(one.low, other.low) && same(one.high, other.high);
                    });
}

std::vector<SharedCurve> shared_curves(const SweptDesigns& swept, std::size_t objective) {
  std::vector<SharedCurve> curves;
  for (std::size_t i = 0; i < swept.designs.size(); ++i) {
    const SweepCurve& curve = swept.sweep.designs[i][objective];
    const std::string name = short_name(swept.designs[i]);
    const auto found = std::ranges::find_if(
        curves, [&](const SharedCurve& other) { return look_alike(*other.curve, curve); });
    if (found != curves.end()) {
      found->names += ", " + name;
    } else if (curves.size() < studies::most_swept) {
      curves.push_back({&curve, name});
    }
  }
  return curves;
}

chart::Layer ribbon_layer(const SharedCurve& shared, const std::vector<double>& at,
                          chart::Style style) {
  chart::Ribbon ribbon{{}, shared.names + "\n5 % to 95 % of the draws"};
  for (std::size_t k = 0; k < shared.curve->bands.size(); ++k) {
    const Band& band = shared.curve->bands[k];
    ribbon.through.push_back({at[k], band.low, band.high, ""});
  }
  style.fill = 0.15;
  return {shared.names, style, chart::Ribbons{{ribbon}}};
}

chart::Layer line_layer(const SharedCurve& shared, const std::vector<double>& at,
                        chart::Style style) {
  chart::Polyline line{{}, shared.names};
  for (std::size_t k = 0; k < at.size(); ++k) {
    line.through.push_back({at[k], shared.curve->values[k]});
  }
  style.line = 2;
  return {shared.names, style, chart::Paths{{line}}};
}

chart::Layer crossings(const SweptDesigns& swept) {
  chart::Rules rules;
  const std::vector<std::string> sentences = lead_sentences(swept);
  for (std::size_t i = 1; i < swept.sweep.leads.size(); ++i) {
    rules.rules.push_back({swept.sweep.leads[i].from, sentences[i - 1] + "\n" + sentences[i], ""});
  }
  chart::Style dotted{chart::Colour::ink};
  dotted.line = 1;
  dotted.dash = chart::Dash::dotted;
  return {rules.rules.empty() ? "" : "the first place changes hands", dotted, rules};
}

chart::Axis coefficient_axis(const CoefficientRange& over) {
  chart::Axis axis;
  axis.title = coefficient_title(over.coefficient);
  axis.least = 0;
  axis.reaches = {over.range.low, over.range.high};
  return axis;
}

std::string sweep_alt(const SweptDesigns& swept, Objective objective) {
  std::string alt = fmt::format("{} over the {}.", objective_title(row(objective)),
                                coefficient_title(swept.sweep.over.coefficient));
  for (const std::string& sentence : lead_sentences(swept)) alt += " " + sentence + ".";
  return alt;
}

Figure sweep_figure(const SweptDesigns& swept, std::size_t objective) {
  const SweepCurve& any = swept.sweep.designs.front()[objective];
  chart::Panel panel;
  panel.x = coefficient_axis(swept.sweep.over);
  panel.y = objective_axis(any.objective);
  const std::vector<SharedCurve> curves = shared_curves(swept, objective);
  std::vector<chart::Layer> lines;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    chart::Style style{chart::series_colour(i)};
    if (i >= distinct_colours) style.dash = chart::Dash::dashed;
    if (!curves[i].curve->bands.empty()) {
      panel.layers.push_back(ribbon_layer(curves[i], swept.sweep.at, style));
    }
    lines.push_back(line_layer(curves[i], swept.sweep.at, style));
  }
  for (chart::Layer& line : lines) panel.layers.push_back(std::move(line));
  panel.layers.push_back(crossings(swept));
  chart::Chart chart;
  chart.alt = sweep_alt(swept, any.objective);
  chart.panels.push_back(std::move(panel));
  std::string id = std::string("sweep-") + row(any.objective).name;
  std::ranges::replace(id, '_', '-');
  const std::string caption =
      any.bands.empty() ? "Lines: everything else as the hardware says."
                        : "Lines: everything else as the hardware says; areas: 5 % to 95 % of the "
                          "draws of all other coefficients.";
  return {id,
          fmt::format("{} over {}.", objective_title(row(any.objective)),
                      row(swept.sweep.over.coefficient).name),
          caption, chart_svg(chart)};
}

}  // namespace

std::vector<Figure> sweep_figures(const SweptDesigns& swept) {
  std::vector<Figure> figures;
  if (swept.designs.empty()) return figures;
  for (std::size_t o = 0; o < swept.sweep.designs.front().size(); ++o) {
    figures.push_back(sweep_figure(swept, o));
  }
  return figures;
}

std::string sweep_html(const SweptDesigns& swept, const std::vector<Figure>& figures) {
  if (figures.empty()) return "";
  Json values{{"title", "Over the " + coefficient_title(swept.sweep.over.coefficient)}};
  values["sentences"] =
      list_json(lead_sentences(swept), [](const std::string& sentence) { return sentence + "."; });
  std::string html;
  for (const Figure& figure : figures) html += figure_html(figure);
  values["figures"] = html;
  return render("sweep.mustache", values);
}

}  // namespace reeve::pages
