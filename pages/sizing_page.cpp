#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drawing/chart/chart.hpp"
#include "pages/figures.hpp"
#include "pages/pages.hpp"
#include "pages/routing_parts.hpp"
#include "pages/shell/settings.hpp"
#include "pages/shell/template.hpp"
#include "reports/document/chosen_columns.hpp"
#include "reports/hand_report.hpp"
#include "reports/sizing_report.hpp"

namespace reeve::pages {
namespace {

std::string short_text(double value) { return fmt::format("{:.4g}", value); }

std::string table_html(const std::string& id, const Section& section) {
  return section.table ? html({id, section.title, *section.table}) : "";
}

// Names the dimensions that the first screen has room for; the table below has all of them.
std::string summary_html(const Section& best) {
  constexpr std::size_t most_rows = 6;
  if (!best.table) return "";
  Table table = with_columns(*best.table, {"dimension", "unit", "before", "sized", "less", "more"});
  const std::size_t all = table.rows.size();
  std::string caption = "Dimensions, and the tolerance of each alone";
  if (all > most_rows) {
    caption += fmt::format("; {} more below", all - most_rows);
    table.rows.resize(most_rows);
  }
  return html({"summary-table", caption, std::move(table)});
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
               "Sensitivities: change of the goal per unit of a dimension, below and above",
               std::move(table)});
}

// Table of both hands' demands on a motor, side by side.
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
  add("force, nominal", "N", &MotorDemand::force_N);
  table.add({"force, in 95 % of the draws", "N", short_text(details.before.hand->drawn->p95_N),
             short_text(details.sized.hand->drawn->p95_N)});
  add_motion("stroke", "mm", &MotorDemand::stroke_mm);
  add_motion("speed", "mm/s", &MotorDemand::speed_mm_s);
  add("power, at most", "W", &MotorDemand::power_W);
  if (sized.torque_Nm) {
    table.add({"torque at the spool", "N m", short_text(*before.torque_Nm),
               short_text(*sized.torque_Nm)});
    table.add(
        {"speed of the spool", "rpm", short_text(*before.spool_rpm), short_text(*sized.spool_rpm)});
  }
  return html({"motor-table", "The motor, at the nominal coefficients except for the quantile",
               std::move(table)});
}

// Without a hand there is nothing to fill in.
void add_hand_values(const SizingDetails& details, Json& values) {
  values["hand"] = false;
  values["motor"] = Json::array();
  if (!details.before.hand || !details.sized.hand) return;
  const HandParts parts = hand_parts(*details.sized.hand);
  values["motor"] = parts.lines;
  values["hand"] = {{"tables", motor_html(details) + parts.tables}};
}

std::string axis_title(const SizeVariable& about) {
  return *about.unit == '\0' ? about.name : fmt::format("{}, {}", about.name, about.unit);
}

// An unlimited tolerance reaches to the end of the profile.
chart::PanelBands tolerance_band(const SizedVariable& sized, const GoalProfile& profile) {
  const Sensitivity& alone = sized.sensitivity;
  const double low = alone.less ? sized.value - *alone.less : profile.values.front();
  const double high = alone.more ? sized.value + *alone.more : profile.values.back();
  return {{{0, std::max(low, profile.values.front()), std::min(high, profile.values.back()),
            fmt::format("alone: {:.4g} to {:.4g}", low, high)}},
          chart::Along::x};
}

chart::PanelBands together_band(double at, const JointTolerance::Ways& ways,
                                const GoalProfile& profile) {
  const double low = std::max(at - ways.less, profile.values.front());
  const double high = std::min(at + ways.more, profile.values.back());
  return {{{0, low, high, fmt::format("all at once: {:.4g} to {:.4g}", low, high)}},
          chart::Along::x};
}

chart::Paths line(const GoalProfile& profile, const std::string& title) {
  chart::Polyline line{{}, title};
  for (std::size_t k = 0; k < profile.values.size(); ++k) {
    line.through.push_back({profile.values[k], profile.goals[k]});
  }
  return {{line}, false};
}

// A product's name is longer than the axis.
std::string goal_title(const Goal& goal) {
  if (goal.is_target()) return "miss of the target";
  return goal.factors.size() == 1 ? to_text(goal) : "goal";
}

chart::Panel profile_panel(const Goal& goal, const SizedDesign& design, std::size_t i,
                           const GoalProfile& profile) {
  const SizedVariable& sized = design.variables[i];
  chart::Panel panel;
  panel.title = sized.variable.name;
  panel.x.title = axis_title(sized.variable);
  panel.y.title = goal_title(goal);
  chart::Style band{chart::Colour::sky};
  band.fill = 0.25;
  panel.layers.push_back({"tolerance alone", band, tolerance_band(sized, profile)});
  if (design.together && design.variables.size() > 1) {
    chart::Style inner{chart::Colour::green};
    inner.fill = 0.35;
    panel.layers.push_back(
        {"all at once", inner, together_band(sized.value, design.together->ways[i], profile)});
  }
  panel.layers.push_back({"goal, the other dimensions as sized",
                          {chart::Colour::blue},
                          line(profile, sized.variable.name)});
  chart::Style before{chart::Colour::grey};
  before.dash = chart::Dash::dashed;
  const double nominal = sized.variable.nominal;
  if (nominal >= profile.values.front() && nominal <= profile.values.back()) {
    panel.layers.push_back(
        {"before", before,
         chart::Rules{{{nominal, fmt::format("before: {:.4g}", nominal), ""}}, chart::Along::x}});
  }
  panel.layers.push_back(
      {"sized",
       {chart::Colour::orange, chart::Symbol::diamond, 5},
       chart::Points{
           {{sized.value, design.after.goal,
             fmt::format("sized: {:.4g}, goal {:.4g}", sized.value, design.after.goal), ""}}}});
  return panel;
}

// The goal against each dimension about the optimum, the others staying: a panel for each.
Figure profile_figure(const SizingReport& report) {
  constexpr std::size_t most_in_a_row = 3;
  const SizedRouting& best = report.designs.front();
  const std::vector<GoalProfile>& profiles = report.details->profiles;
  chart::Chart chart;
  chart.width = 240;
  chart.height = 170;
  chart.shared_y = true;
  chart.columns = std::min(profiles.size(), most_in_a_row);
  chart.alt = fmt::format("Lines of {} against each dimension of {}.", goal_text(report.options),
                          title_of(best));
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    if (profiles[i].values.empty()) continue;
    chart.panels.push_back(profile_panel(report.options.goal, best.design, i, profiles[i]));
  }
  return {"profiles", "The goal about the sized dimensions.",
          fmt::format("Drawn is {}, as one dimension changes and the others stay.",
                      goal_text(report.options)),
          chart_svg(chart)};
}

class SizingPageBuilder {
 public:
  SizingPageBuilder(const SizingReport& report, const std::string& command)
      : report_(report),
        details_(*report.details),
        command_(command),
        stems_(file_stems(
            {{details_.sized.name, details_.sized.word}, {"", details_.sized.word + "-before"}})) {}

  PageFiles build() {
    const SizedRouting& best = report_.designs.front();
    const SizingSections sections = sizing_sections(report_);
    std::string others;
    for (std::size_t g = 1; g < details_.sized.grasps.size(); ++g) {
      others += drawing(details_.sized, g, "sized", stems_[0]);
    }
    Json values{
        {"title", "Dimensions of " + title_of(best)},
        {"lead", fmt::format("{} is sized for {}: {}.", title_of(best), goal_text(report_.options),
                             gain_text(report_.options, best.design))},
        {"opening", line_values(sections.opening)},
        {"demand", line_values(sections.objectives.lines)},
        {"summary", summary_html(sections.best)},
        {"lines", line_values(sections.best.lines)},
        {"before", drawing(details_.before, 0, "before", stems_[1])},
        {"sized", drawing(details_.sized, 0, "sized", stems_[0])},
        {"others", others},
        {"first_grasp", grasp_words(details_.before.grasps.front().grasp)},
        {"dimensions",
         table_html("dimensions-table",
                    {"Sized dimensions and their tolerances", sections.best.table, {}})},
        {"ranking", table_html("ranking-table", sections.ranking)},
        {"shares", table_html("shares-table", sections.shares)},
        {"objectives", table_html("objectives-table", sections.objectives)}};
    values["slopes"] = best.design.together ? slope_html(best.design) : "";
    values["profiles"] = profiles();
    add_hand_values(details_, values);
    Model sized = report_.options.nominal;
    sized.hardware = best.design.hardware;
    values["settings"] =
        settings_html(sized, report_.unconverged, report_.options.grasps, command_);
    page_.html = page_html({values["title"].get<std::string>(), render("sizing.mustache", values),
                            "", Json::object()});
    return std::move(page_);
  }

 private:
  std::string drawing(const ShownRouting& shown, std::size_t grasp, const std::string& words,
                      const std::string& stem) {
    const ShownGrasp& in = shown.grasps[grasp];
    const std::string id = fmt::format("schematic-{}-{}", words, grasp_id(in.grasp));
    const std::string file = schematic_name(stem, in.grasp);
    page_.figures.push_back(schematic_file(file, shown, in));
    return schematic_html(id, shown, in, file);
  }

  std::string profiles() {
    if (details_.profiles.empty()) return "";
    const Figure figure = profile_figure(report_);
    Model sized = report_.options.nominal;
    sized.hardware = report_.designs.front().design.hardware;
    page_.figures.push_back(captioned(figure, sized));
    return figure_html(figure);
  }

  const SizingReport& report_;
  const SizingDetails& details_;
  const std::string& command_;
  std::vector<std::string> stems_;
  PageFiles page_;
};

}  // namespace

PageFiles sizing_page(const SizingReport& report, const std::string& command) {
  return SizingPageBuilder(report, command).build();
}

}  // namespace reeve::pages
