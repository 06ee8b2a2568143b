#include "pages/routing_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "pages/figures.hpp"
#include "pages/shell/glossary.hpp"
#include "pages/shell/template.hpp"
#include "reports/exploration/tradeoff_report.hpp"
#include "reports/hand_report.hpp"
#include "reports/jam_words.hpp"
#include "reports/output/json.hpp"

namespace reeve::pages {
namespace {

// Heading of the grasp.
std::string heading(const Network& network, const ShownGrasp& shown) {
  return grasp_words(shown.grasp) + jam_mark(network, shown.state);
}

}  // namespace

std::vector<std::pair<Segment, double>> strands(const Network& network, const TensionState& state) {
  std::vector<std::pair<Segment, double>> result;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    if (network.segments[i].kind == SegmentKind::strand) {
      result.emplace_back(network.segments[i], state.tension[i]);
    }
  }
  std::ranges::sort(result, {}, [](const auto& strand) { return strand.first.number; });
  return result;
}

std::string schematic_html(const std::string& id, const SolvedRouting& report,
                           const ShownGrasp& shown, const std::string& file) {
  return schematic_html(id, show_svg(report, &shown, id), file);
}

FigureFile schematic_file(const std::string& file, const SolvedRouting& report,
                          const ShownGrasp& shown) {
  return {file, show_svg(report, &shown), schematic_caption(report, shown)};
}

HtmlTable tension_table(const SolvedRouting& report) {
  return {"tensions-table", "Tensions over the motor tension",
          reports::tension_table(
              report, {"grasp", "", "force transmission", grasp_names(report, heading)})};
}

HtmlTable share_table(const SolvedRouting& report) {
  Table table{{text_column("grasp")}, {}};
  for (const auto& [segment, tension] : strands(report.network, report.grasps.front().state)) {
    table.columns.push_back(number_column(segment_name(segment)));
  }
  for (const ShownGrasp& shown : report.grasps) {
    std::vector<std::string> cells{heading(report.network, shown)};
    for (const auto& [segment, tension] : strands(report.network, shown.state)) {
      cells.push_back(fixed(100 * tension / shown.performance.force_transmission, 1));
    }
    table.add(std::move(cells));
  }
  return {"shares-table", "Shares of the strands in their sum, %", std::move(table)};
}

HtmlTable contact_table(const SolvedRouting& report) {
  return {"contacts-table", "Which way the tendon slides",
          reports::contact_table(report, grasp_names(report, heading))};
}

HtmlTable routing_objectives(const ShownRouting& report) {
  Table table = objective_list(report);
  for (TableRow& row : table.rows) std::ranges::replace(row.cells.front(), '_', ' ');
  return {"objectives-table", "Objectives over these grasps, pulling", std::move(table)};
}

Json line_values(const std::vector<DocumentLine>& lines) {
  return list_json(lines, [](const DocumentLine& line) {
    return Json{{"text", line.text}, {"caveat", line.caveat}};
  });
}

HandParts hand_parts(const ShownHand& hand) {
  HandParts parts;
  std::vector<DocumentLine> lines;
  int number = 0;
  for (const Section& section : hand_sections(hand)) {
    parts.tables += html({fmt::format("hand-table-{}", ++number), section.title, *section.table});
    append(lines, section.lines);
  }
  parts.lines = line_values(lines);
  return parts;
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
