#include "pages/sizing_page.hpp"

#include <fmt/format.h>

#include <utility>

#include "pages/figure_captions.hpp"
#include "pages/figure_names.hpp"
#include "pages/profile_chart.hpp"
#include "pages/routing_parts.hpp"
#include "pages/shell/settings.hpp"
#include "pages/shell/template.hpp"
#include "reports/hand_report.hpp"
#include "reports/sizing_report.hpp"
#include "reports/sizing_words.hpp"

namespace reeve::pages {
namespace {

std::string short_text(double value) { return fmt::format("{:.4g}", value); }

Json line_values(const std::vector<DocumentLine>& lines) {
  Json list = Json::array();
  for (const DocumentLine& line : lines) {
    list.push_back({{"text", line.text}, {"caveat", line.caveat}});
  }
  return list;
}

std::string table_html(const std::string& id, const Section& section) {
  return section.table ? html({id, section.title, *section.table}) : "";
}

std::string slope_html(const SizedDesign& design) {
  Table table{{text_column("dimension"), number_column("slope, less"), number_column("slope, more"),
               text_column("per")},
              {}};
  for (const SizedVariable& sized : design.variables) {
    const char* unit = sized.variable.unit;
    table.add({sized.variable.name, fmt::format("{:+.4g}", sized.sensitivity.slope_less),
               fmt::format("{:+.4g}", sized.sensitivity.slope_more), *unit == '\0' ? "1" : unit});
  }
  return html({"slopes-table",
               "Sensitivities: by how much the goal changes as a dimension gets less, and more",
               std::move(table)});
}

// What both hands ask of a motor, one beside the other.
std::string motor_html(const SizingDetails& details) {
  const MotorDemand& before = details.before.hand->demand;
  const MotorDemand& sized = details.sized.hand->demand;
  Table table{{text_column("of the motor"), text_column("unit"), number_column("before"),
               number_column("sized")},
              {}};
  const auto add = [&](const char* what, const char* unit, double MotorDemand::*of) {
    table.add({what, unit, short_text(before.*of), short_text(sized.*of)});
  };
  const auto add_motion = [&](const char* what, const char* unit, double MotorDemand::*of) {
    const auto cell = [of](const MotorDemand& demand) {
      return demand.can_move() ? short_text(demand.*of) : "-";
    };
    table.add({what, unit, cell(before), cell(sized)});
  };
  add("force", "N", &MotorDemand::force_N);
  add_motion("stroke", "mm", &MotorDemand::stroke_mm);
  add_motion("speed", "mm/s", &MotorDemand::speed_mm_s);
  add("power, at most", "W", &MotorDemand::power_W);
  if (sized.torque_Nm) {
    table.add({"torque at the spool", "N m", short_text(*before.torque_Nm),
               short_text(*sized.torque_Nm)});
    table.add(
        {"speed of the spool", "rpm", short_text(*before.spool_rpm), short_text(*sized.spool_rpm)});
  }
  return html({"motor-table", "The motor, at the nominal coefficients", std::move(table)});
}

// Without a hand there is nothing to fill in.
void add_hand_values(const SizingDetails& details, Json& values) {
  values["hand"] = false;
  values["motor"] = Json::array();
  if (!details.before.hand || !details.sized.hand) return;
  std::string tables = motor_html(details);
  int number = 0;
  for (const Section& section : hand_sections(*details.sized.hand)) {
    tables += table_html(fmt::format("hand-table-{}", ++number), section);
    for (const Json& line : line_values(section.lines)) values["motor"].push_back(line);
  }
  values["hand"] = {{"tables", tables}};
}

class SizingPageBuilder {
 public:
  SizingPageBuilder(const SizingReport& report, const std::string& command)
      : report_(report),
        details_(*report.details),
        command_(command),
        stems_(file_stems(
            {{details_.sized.name, details_.sized.word}, {"", details_.sized.word + "-before"}})) {}

  SizingPage build();

 private:
  std::string drawing(const ShownRouting& shown, std::size_t grasp, const std::string& words,
                      const std::string& stem);
  std::string profiles();

  const SizingReport& report_;
  const SizingDetails& details_;
  const std::string& command_;
  std::vector<std::string> stems_;
  SizingPage page_;
};

std::string SizingPageBuilder::drawing(const ShownRouting& shown, std::size_t grasp,
                                       const std::string& words, const std::string& stem) {
  const ShownGrasp& in = shown.grasps[grasp];
  const std::string id = fmt::format("schematic-{}-{}", words, grasp_id(in.grasp));
  const std::string file = schematic_name(stem, in.grasp);
  page_.figures.push_back(schematic_file(file, shown, in));
  return schematic_html(id, shown, in, file);
}

std::string SizingPageBuilder::profiles() {
  if (details_.profiles.empty()) return "";
  const Figure figure = profile_figure(report_);
  Model sized = report_.options.nominal;
  sized.hardware = report_.designs.front().design.hardware;
  page_.figures.push_back(captioned(figure, sized));
  return figure_html(figure);
}

SizingPage SizingPageBuilder::build() {
  const SizedRouting& best = report_.designs.front();
  const SizingSections sections = sizing_sections(report_);
  std::string others;
  for (std::size_t g = 1; g < details_.sized.grasps.size(); ++g) {
    others += drawing(details_.sized, g, "sized", stems_[0]);
  }
  Json values{
      {"title", "Dimensions of " + title_of(best)},
      {"lead", fmt::format("{}: {}", title_of(best), gain_text(report_.options, best.design))},
      {"opening", line_values(sections.opening)},
      {"lines", line_values(sections.best.lines)},
      {"before", drawing(details_.before, 0, "before", stems_[1])},
      {"sized", drawing(details_.sized, 0, "sized", stems_[0])},
      {"others", others},
      {"first_grasp", grasp_words(details_.before.grasps.front().grasp)},
      {"dimensions",
       table_html("dimensions-table",
                  {"What was chosen, and how far it may be off", sections.best.table, {}})},
      {"ranking", table_html("ranking-table", sections.ranking)},
      {"shares", table_html("shares-table", sections.shares)},
      {"objectives", table_html("objectives-table", sections.objectives)}};
  values["slopes"] = best.design.together ? slope_html(best.design) : "";
  values["profiles"] = profiles();
  add_hand_values(details_, values);
  Model sized = report_.options.nominal;
  sized.hardware = best.design.hardware;
  values["settings"] = settings_html(sized, report_.unconverged, report_.options.grasps, command_);
  page_.html = page_html(
      {values["title"].get<std::string>(), render("sizing.mustache", values), "", Json::object()});
  return std::move(page_);
}

}  // namespace

SizingPage sizing_page(const SizingReport& report, const std::string& command) {
  return SizingPageBuilder(report, command).build();
}

}  // namespace reeve::pages
