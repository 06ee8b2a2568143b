#include "reports/sizing/sizing_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "catalog/rig/hardware_tables.hpp"
#include "core/version.hpp"
#include "reports/results/model_text.hpp"
#include "reports/sizing/sizing_words.hpp"
#include "search/judge/shown_objectives.hpp"

namespace reeve::reports {
namespace {

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

std::vector<SheetLine> opening_lines(const SizingReport& report) {
  const SizingOptions& options = report.options;
  std::vector<SheetLine> lines;
  if (report.partial) {
    lines.push_back({"PARTIAL: stopped; the best so far, without sensitivities", true});
  }
  for (const std::string& note : report.notes) lines.push_back({"Note: " + note, true});
  for (const SheetLine& line : model_lines(options.nominal, report.unconverged)) {
    lines.push_back(line);
  }
  lines.push_back(
      {"Sized for " + goal_text(options) + ", over the grasps " + to_text(options.grasps)});
  return lines;
}

Section ranking_section(const SizingReport& report) {
  if (report.designs.size() < 2) return {};
  Table table{{number_column("rank"), number_column("before"), text_column("name"),
               text_column("routing"), number_column("goal before"), number_column("goal sized"),
               number_column("sheaths", "", 1), number_column("pulleys", "", 2)},
              {}};
  for (const SizedRouting& routing : report.designs) {
    const ObjectiveValues& values = routing.design.after.values;
    table.add({std::to_string(routing.rank_after), std::to_string(routing.rank_before),
               routing.name.empty() ? "-" : routing.name, routing.word,
               short_number(routing.design.before.goal), short_number(routing.design.after.goal),
               fixed(value(values, Objective::sheaths), 0),
               fixed(value(values, Objective::pulleys), 0)});
  }
  return {"Ranked by the goal, sized and before", table, {}};
}

std::string off(const std::optional<double>& way) { return way ? short_number(*way) : "any"; }

std::string stands(const SizedVariable& variable) {
  switch (variable.at) {
    case AtBound::low:
      return "at its lower bound";
    case AtBound::high:
      return "at its upper bound";
    case AtBound::no:
      break;
  }
  return "between";
}

Table variable_table(const SizedDesign& design) {
  Table table{{text_column("dimension"), text_column("unit"), number_column("least"),
               number_column("greatest"), number_column("before"), number_column("sized"),
               number_column("may be less by"), number_column("more by")},
              {}};
  const bool together = design.together && design.variables.size() > 1;
  if (together) {
    table.columns.push_back(number_column("all at once less by"));
    table.columns.push_back(number_column("more by"));
  }
  table.columns.push_back(text_column("stands"));
  table.columns.back().dispensable = 1;
  for (std::size_t i = 0; i < design.variables.size(); ++i) {
    const SizedVariable& sized = design.variables[i];
    const SizeVariable& about = sized.variable;
    table.add({about.name, *about.unit == '\0' ? "1" : about.unit, short_number(about.bounds.low),
               short_number(about.bounds.high), short_number(about.nominal),
               short_number(sized.value), off(sized.sensitivity.less), off(sized.sensitivity.more)});
    std::vector<std::string>& cells = table.rows.back().cells;
    if (together) {
      const JointTolerance::Ways& ways = design.together->ways[i];
      cells.push_back(short_number(ways.less));
      cells.push_back(short_number(ways.more));
    }
    cells.push_back(stands(sized));
  }
  return table;
}

std::string flat_text(const SizedDesign& design, const FlatDirection& flat) {
  return fmt::format("Flat: moving {}, or back, costs {}", moves_text(design, flat.moves),
                     flat.loss < 1e-6 ? "nothing" : fmt::format("{:.2g}", flat.loss));
}

std::size_t worst_finger(const std::vector<double>& target, const std::vector<double>& shares) {
  std::size_t worst = 0;
  for (std::size_t f = 0; f < target.size(); ++f) {
    const auto miss = [&](std::size_t finger) { return std::abs(shares[finger] - target[finger]); };
    if (miss(f) > miss(worst)) worst = f;
  }
  return worst;
}

// Of a target: what is possible at the nominal coefficients.
SheetLine target_line(const SizingOptions& options, const SizedDesign& design) {
  const std::vector<double>& target = options.goal.target;
  const std::size_t worst = worst_finger(target, design.nearest_shares);
  const std::string at_best = fmt::format(
      "at the nominal coefficients shares miss it by {:.4g} at best, where finger {} has "
      "{:.4g} of all pull instead of {:.4g}",
      on_grid(*design.least_miss), worst + 1, design.nearest_shares[worst], target[worst]);
  if (!is_met(design)) {
    return {"The target is out of reach within the bounds: " + at_best, true};
  }
  if (on_grid(*design.least_miss) == 0 && !options.robust) return {"The target is met"};
  const std::string here = options.robust
                               ? fmt::format("; sized for all coefficients, by {:.4g} there",
                                             on_grid(design.after.nominal))
                               : "";
  return {"The target is within reach: " + at_best + here};
}

Section best_section(const SizingReport& report) {
  const SizedRouting& best = report.designs.front();
  const SizedDesign& design = best.design;
  Section section{title_of(best) + ": " + gain_text(report.options, design), std::nullopt, {}};
  if (design.variables.empty()) {
    section.lines.push_back({"It has none of the dimensions that are varied"});
  } else {
    section.table = variable_table(design);
  }
  if (design.least_miss) section.lines.push_back(target_line(report.options, design));
  if (!report.partial && !design.variables.empty()) {
    section.lines.push_back(
        {"A dimension may be off by so much, alone, " + tolerance_text(report.options)});
    const std::string together = together_text(report.options, design);
    if (!together.empty()) section.lines.push_back({together});
  }
  for (const FlatDirection& flat : design.flat) section.lines.push_back({flat_text(design, flat)});
  return section;
}

Section shares_section(const SizingReport& report) {
  const Goal& goal = report.options.goal;
  if (!goal.is_target()) return {};
  Table table{{number_column("finger"), number_column("target"), number_column("before"),
               number_column("sized")},
              {}};
  const SizedDesign& design = report.designs.front().design;
  for (std::size_t f = 0; f < goal.target.size(); ++f) {
    table.add({std::to_string(f + 1), fixed(goal.target[f], 4), fixed(design.before.shares[f], 4),
               fixed(design.after.shares[f], 4)});
  }
  return {"Shares of the fingers in all pull, at the nominal coefficients", table, {}};
}

Section objective_section(const SizingReport& report) {
  Table table{{text_column("objective"), number_column("before"), number_column("sized")}, {}};
  const SizedDesign& design = report.designs.front().design;
  for (const Objective objective :
       shown_objectives(Order(report.options.goal.factors), report.options.score)) {
    const ObjectiveRow& about = row(objective);
    if (about.is_count()) continue;
    table.add({about.name, fixed(value(design.before.values, objective), about.decimals),
               fixed(value(design.after.values, objective), about.decimals)});
  }
  return {"At the nominal coefficients", table, {}};
}

}  // namespace

SizingSections sizing_sections(const SizingReport& report) {
  return {opening_lines(report), ranking_section(report), best_section(report),
          shares_section(report), objective_section(report)};
}

Sheet sizing_sheet(const SizingReport& report) {
  SizingSections sections = sizing_sections(report);
  Sheet sheet{{{"", std::nullopt, std::move(sections.opening)}}};
  for (Section* section :
       {&sections.ranking, &sections.best, &sections.shares, &sections.objectives}) {
    sheet.add(std::move(*section));
  }
  return sheet;
}

std::string sized_hardware_toml(const SizingReport& report, const VaryTable& vary) {
  const SizedRouting& best = report.designs.front();
  std::string text =
      toml_comment(fmt::format("Sized by reeve {} for {}", version().number, title_of(best))) +
      toml_comment(goal_text(report.options) + ": " + gain_text(report.options, best.design));
  if (report.partial) text += toml_comment("The search was stopped: the best so far");
  if (!report.options.nominal.effects.empty()) {
    text += toml_comment("The effects of the model that it was sized with are not in it");
  }
  return text + "\n" + hardware_toml(best.design.hardware, report.options.ranges, vary);
}

}  // namespace reeve::reports
