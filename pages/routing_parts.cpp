#include "pages/routing_parts.hpp"

#include <algorithm>

#include "core/motor_sides.hpp"
#include "core/text.hpp"
#include "drawing/schematic/schematic_svg.hpp"
#include "pages/figures.hpp"
#include "pages/shell/glossary.hpp"
#include "pages/shell/template.hpp"
#include "reports/document/text_table.hpp"
#include "reports/exploration/tradeoff_report.hpp"
#include "reports/output/json.hpp"
#include "reports/shown_value.hpp"

namespace reeve::pages {
namespace {

std::string title(const SolvedRouting& report) {
  return report.name.empty() ? report.word : report.name + ": " + report.word;
}

std::string drawing(const std::string& ids, const SolvedRouting& report, const ShownGrasp& shown) {
  const GraspView view{shown.grasp, report.direction, shown.state};
  return schematic_svg(schematic(report.network, title(report), view), ids);
}

std::string heading(const ShownGrasp& shown) {
  return grasp_words(shown.grasp) + (shown.state.jams ? " (jams)" : "");
}

}  // namespace

std::string objective_text(Objective objective, double value) {
  return fixed(value, shown_decimals(objective, value, row(objective).is_count() ? 0 : 3));
}

std::vector<std::pair<Segment, double>> strands(const Network& network, const TensionState& state) {
  std::vector<std::pair<Segment, double>> result;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    if (network.segments[i].kind == SegmentKind::strand) {
      result.emplace_back(network.segments[i], state.tension[i]);
    }
  }
  std::ranges::sort(result,
                    [](const auto& a, const auto& b) { return a.first.number < b.first.number; });
  return result;
}

std::string schematic_html(const std::string& id, const SolvedRouting& report,
                           const ShownGrasp& shown, const std::string& file) {
  return schematic_html(id, drawing(id, report, shown), file);
}

FigureFile schematic_file(const std::string& file, const SolvedRouting& report,
                          const ShownGrasp& shown) {
  return {file, drawing("schematic", report, shown), schematic_caption(report, shown)};
}

HtmlTable tension_table(const SolvedRouting& report) {
  Table table{{text_column("grasp")}, {}};
  for (const Segment& segment : report.network.segments) {
    table.columns.push_back(number_column(segment_name(segment)));
  }
  const int motors = carriage_count(report.network);
  for (int motor = 1; motors > 1 && motor <= motors; ++motor) {
    table.columns.push_back(number_column(motor_name(motor)));
  }
  for (const char* figure : {"uniformity", "efficiency", "force transmission"}) {
    table.columns.push_back(number_column(figure));
  }
  for (const ShownGrasp& shown : report.grasps) {
    std::vector<std::string> cells{heading(shown)};
    for (const double tension : shown.state.tension) cells.push_back(fixed(tension));
    if (motors > 1) {
      for (const double tension : motor_tensions(report.network, shown.state)) {
        cells.push_back(fixed(tension));
      }
    }
    for (const double figure : {shown.performance.uniformity, shown.performance.efficiency,
                                shown.performance.force_transmission}) {
      cells.push_back(fixed(figure));
    }
    table.add(std::move(cells));
  }
  return {"tensions-table", "Tensions over the motor tension", std::move(table)};
}

HtmlTable share_table(const SolvedRouting& report) {
  Table table{{text_column("grasp")}, {}};
  for (const auto& [segment, tension] : strands(report.network, report.grasps.front().state)) {
    table.columns.push_back(number_column(segment_name(segment)));
  }
  for (const ShownGrasp& shown : report.grasps) {
    std::vector<std::string> cells{heading(shown)};
    for (const auto& [segment, tension] : strands(report.network, shown.state)) {
      cells.push_back(fixed(100 * tension / shown.performance.force_transmission, 1));
    }
    table.add(std::move(cells));
  }
  return {"shares-table", "Shares of the strands in their sum, %", std::move(table)};
}

HtmlTable contact_table(const SolvedRouting& report) {
  Table table{{text_column("contact"), text_column("kind")}, {}};
  for (const ShownGrasp& shown : report.grasps)
    table.columns.push_back(text_column(heading(shown)));
  for (const ShownContact& contact : shown_contacts(report)) {
    std::vector<std::string> cells{contact.between, contact.kind};
    cells.insert(cells.end(), contact.slides.begin(), contact.slides.end());
    table.add(std::move(cells));
  }
  return {"contacts-table", "Which way the tendon slides", std::move(table)};
}

HtmlTable routing_objectives(const ShownRouting& report) {
  Table table{{text_column("objective"), number_column("value"), text_column("unit"),
               text_column("meaning")},
              {}};
  for (const ObjectiveRow& row : objective_table()) {
    if (!is_there(row, report.values)) continue;
    if (row.objective == Objective::cost && !report.prices) continue;
    const bool priced = row.objective == Objective::cost && !report.prices->unit.empty();
    table.add({objective_title(row),
               objective_text(row.objective, value(report.values, row.objective)),
               priced ? report.prices->unit : row.unit, row.meaning});
  }
  return {"objectives-table", "Objectives over these grasps, pulling", std::move(table)};
}

std::string tradeoff_html(const ListedTradeoff& tradeoff) {
  const Section section = tradeoff_section(tradeoff);
  if (!section.table) return "";
  return render(
      "tradeoff.mustache",
      {{"title", section.title},
       {"table", html({"tradeoff-table",
                       "gain: change from the line above; kept: value relative to the best design.",
                       *section.table})},
       {"glossary", glossary_html("Gain, kept, knee: what they mean", tradeoff_terms())}});
}

}  // namespace reeve::pages
