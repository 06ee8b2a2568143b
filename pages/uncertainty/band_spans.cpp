#include "pages/uncertainty/band_spans.hpp"

#include <fmt/format.h>

#include <set>

#include "pages/exploration/objective_title.hpp"
#include "reports/uncertainty/band_report.hpp"

namespace reeve::pages {
namespace {

constexpr const char* spans_name = "5 % to 95 % of the draws";

std::string span_title(const std::string& name, Objective objective, const Band& band) {
  return fmt::format("{}\n{}: {}", name, objective_title(row(objective)),
                     band_text(band, row(objective).decimals));
}

void add_span(const BandedSpot& spot, Objective objective, double at, chart::Spans& spans) {
  const Band* band = find_band(spot.bands, objective);
  if (band == nullptr || band->is_point()) return;
  spans.spans.push_back({at, band->low, band->high, span_title(spot.name, objective, *band)});
}

}  // namespace

std::vector<chart::Layer> band_layers(const std::vector<BandedSpot>& spots,
                                      const std::array<Objective, 2>& axes) {
  chart::Spans across{{}, chart::Along::x, {}};
  chart::Spans up{{}, chart::Along::y, {}};
  std::set<std::string> seen;
  for (const BandedSpot& spot : spots) {
    if (spot.bands.empty() || seen.size() == most_banded) continue;
    if (!seen.insert(fmt::format("{:.3g} {:.3g}", spot.x, spot.y)).second) continue;
    add_span(spot, axes[0], spot.y, across);
    add_span(spot, axes[1], spot.x, up);
  }
  chart::Style thin{chart::Colour::grey};
  thin.line = 1.2;
  thin.opacity = 0.7;
  std::vector<chart::Layer> layers;
  if (!across.spans.empty()) layers.push_back({spans_name, thin, across});
  if (!up.spans.empty()) layers.push_back({spans_name, thin, up});
  return layers;
}

std::string band_caption(const std::vector<chart::Layer>& layers) {
  if (layers.empty()) return "";
  return " Bars: from 5 % to 95 % of the draws, each objective by itself; all designs share the "
         "draws, so that bars may overlap of designs whose order is sure.";
}

}  // namespace reeve::pages
