#include "pages/objective_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "pages/page_words.hpp"
#include "reports/exploration/band_report.hpp"

namespace reeve::pages {
namespace {

constexpr const char* spans_name = "5 % to 95 % of the draws";

std::string span_title(const std::string& name, Objective objective, const Band& band) {
  return fmt::format("{}\n{}: {}", name, objective_title(row(objective)),
                     band_text(band, row(objective).decimals));
}

chart::Extent reach(const chart::Extent& points) {
  if (points.empty() || points.low == points.high) return {};
  const double beyond = (points.high - points.low) / 2;
  return {points.low - beyond, points.high + beyond};
}

// Returns true if it had to be cut. Its title has the whole band.
bool add_span(const BandedSpot& spot, Objective objective, double at, const chart::Extent& points,
              chart::Spans& spans) {
  const Band* band = find_band(spot.bands, objective);
  if (band == nullptr || band->is_point()) return false;
  const chart::Extent most = reach(points);
  const double low = most.empty() ? band->low : std::clamp(band->low, most.low, most.high);
  const double high = most.empty() ? band->high : std::clamp(band->high, most.low, most.high);
  spans.spans.push_back({at, low, high, span_title(spot.name, objective, *band)});
  return low != band->low || high != band->high;
}

}  // namespace

chart::Axis objective_axis(Objective objective, const std::string& cost_unit) {
  const ObjectiveRow& about = row(objective);
  std::string unit = about.unit == std::string_view("1") ? "" : fmt::format(", {}", about.unit);
  if (objective == Objective::cost && !cost_unit.empty()) unit = ", " + cost_unit;
  chart::Axis axis;
  axis.title = fmt::format("{}{} ({} is better)", objective_title(about), unit,
                           about.better == Better::higher ? "higher" : "lower");
  axis.least = about.least;
  axis.greatest = about.greatest;
  axis.whole = about.is_count();
  return axis;
}

BandBars band_bars(const std::vector<BandedSpot>& spots, const std::array<Objective, 2>& axes,
                   const PointsSpan& points) {
  BandBars bars;
  chart::Spans across{{}, chart::Along::x, {}};
  chart::Spans up{{}, chart::Along::y, {}};
  std::set<std::string> seen;
  for (const BandedSpot& spot : spots) {
    if (spot.bands.empty() || seen.size() == most_banded) continue;
    if (!seen.insert(fmt::format("{:.3g} {:.3g}", spot.x, spot.y)).second) continue;
    if (add_span(spot, axes[0], spot.y, points[0], across)) bars.cut = true;
    if (add_span(spot, axes[1], spot.x, points[1], up)) bars.cut = true;
  }
  chart::Style thin{chart::Colour::grey};
  thin.line = 1.2;
  thin.opacity = 0.7;
  if (!across.spans.empty()) bars.layers.push_back({spans_name, thin, across});
  if (!up.spans.empty()) bars.layers.push_back({spans_name, thin, up});
  return bars;
}

std::string band_caption(const BandBars& bars) {
  if (bars.layers.empty()) return "";
  std::string text =
      " Bars: from 5 % to 95 % of the draws, each objective by itself; all designs share the "
      "draws, so that bars may overlap of designs whose order is sure.";
  if (bars.cut) {
    text +=
        " Bars that reach far beyond the points end where the plot does; their hints and the "
        "table have the whole bands.";
  }
  return text;
}

}  // namespace reeve::pages
