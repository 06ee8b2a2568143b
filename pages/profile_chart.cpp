#include "pages/profile_chart.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drawing/chart/chart.hpp"
#include "reports/sizing_words.hpp"

namespace reeve::pages {
namespace {

std::string axis_title(const SizeVariable& about) {
  return *about.unit == '\0' ? about.name : fmt::format("{}, {}", about.name, about.unit);
}

// What a tolerance of nothing reaches to: the end of the profile.
chart::Bands tolerance_band(const SizedVariable& sized, const GoalProfile& profile) {
  const Sensitivity& alone = sized.sensitivity;
  const double low = alone.less ? sized.value - *alone.less : profile.values.front();
  const double high = alone.more ? sized.value + *alone.more : profile.values.back();
  return {{{0, std::max(low, profile.values.front()), std::min(high, profile.values.back()),
            fmt::format("alone: {:.4g} to {:.4g}", low, high)}},
          chart::Along::x};
}

chart::Bands together_band(double at, const JointTolerance::Ways& ways,
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
  panel.layers.push_back({"may be off so far alone", band, tolerance_band(sized, profile)});
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

}  // namespace

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

}  // namespace reeve::pages
