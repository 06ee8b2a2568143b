#include <fmt/format.h>

#include "core/text.hpp"
#include "drawing/chart/chart.hpp"
#include "pages/closing_figure.hpp"
#include "pages/figures.hpp"
#include "pages/pages.hpp"
#include "pages/routing_parts.hpp"
#include "pages/shell/glossary.hpp"
#include "pages/shell/settings.hpp"
#include "pages/shell/template.hpp"
#include "pages/tension_charts.hpp"
#include "reports/assumed_words.hpp"
#include "reports/document/document.hpp"
#include "reports/hand_report.hpp"
#include "reports/jam_words.hpp"

namespace reeve::pages {
namespace {

const char* verb(Direction direction) {
  return direction == Direction::pull ? "pulls the tendons in" : "lets the fingers draw them out";
}

Figure tension_figure(const ShownRouting& report) {
  chart::Chart chart = tension_chart(report);
  chart.alt = "Bars of the strand tensions over the motor tension." + chart.alt;
  return {"tensions", "Strand tensions in each grasp",
          "At a motor tension of 1; colours tell the fingers apart.", chart_svg(chart)};
}

// Returns the sentence that people look for first.
std::string summary(const ShownRouting& report) {
  const ObjectiveValues& values = report.values;
  return fmt::format(
      "Over the grasps below its mean uniformity is {} (worst {}) and its mean efficiency {} "
      "(worst {}).",
      fixed(value(values, Objective::uniformity_mean)),
      fixed(value(values, Objective::uniformity_worst)),
      fixed(value(values, Objective::efficiency_mean)),
      fixed(value(values, Objective::efficiency_worst)));
}

Json jams(const ShownRouting& report) {
  Json list = Json::array();
  for (const ShownGrasp& shown : report.grasps) {
    if (!shown.state.jams) continue;
    const std::string stalled = stalled_motors(report.network, shown.state);
    list.push_back(fmt::format("With {} {}", grasp_words(shown.grasp),
                               stalled.empty() ? "the routing jams" : stalled));
  }
  return list;
}

// False, which the template passes over, without one.
Json hand_values(const ShownRouting& report, std::vector<FigureFile>& files) {
  if (!report.hand) return false;
  const HandParts parts = hand_parts(*report.hand);
  std::string figures;
  for (std::size_t i = 0; i < report.hand->closings.size(); ++i) {
    for (const Figure& figure : closing_figures(report.hand->closings[i], i + 1)) {
      figures += figure_html(figure);
      files.push_back(captioned(figure, report.model));
    }
  }
  return {{"tables", parts.tables}, {"lines", parts.lines}, {"figures", figures}};
}

GraspSet grasps(const ShownRouting& report) {
  GraspSet grasps;
  for (const ShownGrasp& shown : report.grasps) grasps.push_back({shown.grasp, 1});
  return grasps;
}

}  // namespace

PageFiles routing_page(const ShownRouting& report, const std::string& command) {
  PageFiles page;
  std::string first;
  std::string others;
  const std::string name = report.is_named() ? report.name : "";
  const std::string stem = file_stems({{name, report.word}}).front();
  for (const ShownGrasp& shown : report.grasps) {
    const std::string file = schematic_name(stem, shown.grasp);
    (first.empty() ? first : others) +=
        schematic_html("schematic-" + grasp_id(shown.grasp), report, shown, file);
    page.figures.push_back(schematic_file(file, report, shown));
  }
  Json values{{"name", name},
              {"routing_of", name.empty() ? report.name : ""},
              {"word", report.word},
              {"canonical", report.canonical == report.word ? "" : report.canonical},
              {"verb", verb(report.direction)},
              {"summary", summary(report)},
              {"shared", shared_carriage_text(report.network, report.model.hardware.tendon)},
              {"jams", jams(report)},
              {"jam_sentence", jam_sentence(report.smallest_jams, report.values, report.network)},
              {"assumed", assumed_text(report.model)},
              {"objectives", html(routing_objectives(report))},
              {"first", first},
              {"others", others},
              {"tensions", html(tension_table(report))},
              {"contacts", html(contact_table(report))}};
  values["glossary"] = glossary_html("Strand, held, jam, slides: what they mean", routing_terms());
  values["hand"] = hand_values(report, page.figures);
  values["has_strands"] = report.network.fingers > 0;
  if (report.network.fingers > 0) {
    const Figure tensions = tension_figure(report);
    values["figure"] = figure_html(tensions);
    values["shares"] = html(share_table(report));
    page.figures.push_back(captioned(tensions, report.model));
  }
  values["settings"] = settings_html(report.model, report.unconverged, grasps(report), command);
  const std::string title = name.empty() ? report.word : name + " " + report.word;
  page.html = page_html({title, render("routing.mustache", values), "", Json::object()});
  return page;
}

}  // namespace reeve::pages
