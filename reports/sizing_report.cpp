#include "reports/sizing_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "catalog/hardware_tables.hpp"
#include "core/hand.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "reports/assumed_words.hpp"
#include "reports/document/chosen_columns.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/model_text.hpp"
#include "reports/motor_words.hpp"
#include "reports/output/json.hpp"
#include "reports/shown_value.hpp"
#include "search/evaluate/shown_objectives.hpp"

namespace reeve::reports {
namespace {

// Returns the objectives of the goal and those always shown. With a hand, these include the motor's
// demand, whatever it was sized for.
std::vector<Objective> objectives_of(const SizingReport& report) {
  std::vector<Objective> goal = report.options.goal.factors;
  if (hand(report.options.nominal.hardware)) {
    for (const Objective objective :
         {Objective::motor_force, Objective::stroke, Objective::closure}) {
      if (std::ranges::find(goal, objective) == goal.end()) goal.push_back(objective);
    }
  }
  return shown_objectives(Order(goal), report.options.score);
}

// Dimensions that suit the goal may ask more of the motor than it has.
std::vector<DocumentLine> demand_lines(const SizingReport& report) {
  const MotorParts& motor = report.options.nominal.hardware.motor;
  const SizedGoal& sized = report.designs.front().design.after;
  return motor_lines(sized.motor, motor);
}

// Objectives of the best design, at the nominal coefficients.
Section objective_section(const SizingReport& report) {
  Table table{{text_column("objective"), text_column("unit"), number_column("before"),
               number_column("sized")},
              {}};
  const SizedDesign& design = report.designs.front().design;
  for (const Objective objective : objectives_of(report)) {
    const ObjectiveRow& about = row(objective);
    if (about.is_count()) continue;
    table.add({about.name, about.unit,
               fixed(value(design.before.values, objective), about.decimals),
               fixed(value(design.after.values, objective), about.decimals)});
  }
  return {"At the nominal coefficients", table, demand_lines(report)};
}

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

std::vector<DocumentLine> opening_lines(const SizingReport& report) {
  const SizingOptions& options = report.options;
  std::vector<DocumentLine> lines;
  if (report.partial) {
    lines.push_back({"PARTIAL: stopped; the best so far, without sensitivities", true});
  }
  lines.push_back({assumed_text(options.nominal)});
  append(lines, note_lines(report.notes));
  append(lines, model_lines(options.nominal, report.unconverged));
  const bool few = options.robust && options.draws < told_draws(options);
  lines.push_back({"Sized for " + goal_text(options) + ", over the grasps " +
                   to_text(goal_grasps(options)) +
                   (few ? fmt::format("; searched with the first {} draws", options.draws) : "")});
  return lines;
}

// The ranking; if columns are chosen, with all objectives of the sized designs.
Table sized_table(const SizingReport& report, bool all) {
  Table table{{number_column("rank"), number_column("before"), text_column("name"),
               text_column("routing"), number_column("goal before"), number_column("goal sized")},
              {}};
  const std::array keys{"rank", "rank_before", "name", "routing", "goal_before", "goal_sized"};
  for (std::size_t i = 0; i < keys.size(); ++i) table.columns[i].key = keys.at(i);
  std::vector<Objective> objectives{Objective::sheaths, Objective::pulleys};
  if (all) {
    objectives.clear();
    for (const ObjectiveRow& row : objective_table()) objectives.push_back(row.objective);
  }
  for (std::size_t i = 0; i < objectives.size(); ++i) {
    const ObjectiveRow& about = row(objectives[i]);
    const std::string part = *about.part == '\0' ? "" : std::string(", ") + about.part;
    table.columns.push_back(number_column(about.heading + part, objective_unit(about.objective),
                                          static_cast<unsigned>(i) + 1));
    table.columns.back().key = about.name;
  }
  for (const SizedRouting& routing : report.designs) {
    table.add({std::to_string(routing.rank_after), std::to_string(routing.rank_before),
               routing.name.empty() ? "-" : routing.name, routing.word,
               short_number(routing.design.before.goal), short_number(routing.design.after.goal)});
    for (const Objective objective : objectives) {
      table.rows.back().cells.push_back(
          fixed(value(routing.design.after.values, objective), row(objective).decimals));
    }
  }
  return table;
}

Section ranking_section(const SizingReport& report) {
  if (report.designs.size() < 2) return {};
  return {"Ranked by the goal, sized and before", sized_table(report, false), {}};
}

// A search that was stopped has looked for no tolerance.
std::string off(const SizedDesign& design, const std::optional<double>& way) {
  if (way) return short_number(*way);
  return design.together ? "any" : "-";
}

// If no limit was found for the dimension alone, the end of the trial is a lower bound (≥).
std::string off_together(double way, const std::optional<double>& alone) {
  return alone ? short_number(way) : "≥ " + short_number(way);
}

// As far as it was looked at nothing depends on it, wherever it stands.
bool is_free(const SizedDesign& design, const Sensitivity& of) {
  return design.together && !of.less && !of.more && of.slope_less == 0 && of.slope_more == 0;
}

std::string stands(const SizedDesign& design, const SizedVariable& variable) {
  if (is_free(design, variable.sensitivity)) return "free";
  if (variable.at == AtBound::no) return "between";
  return variable.at == AtBound::low ? "at its lower bound" : "at its upper bound";
}

struct VariableColumn {
  const char* key;
  const char* heading;
  bool is_text;
  bool usual;  // in the table where no columns are chosen
  unsigned dispensable;
};

constexpr std::array variable_columns{
    VariableColumn{"dimension", "dimension", true, true, 0},
    VariableColumn{"unit", "unit", true, true, 0},
    VariableColumn{"least", "least", false, true, 0},
    VariableColumn{"greatest", "greatest", false, true, 0},
    VariableColumn{"before", "before", false, true, 0},
    VariableColumn{"sized", "sized", false, true, 0},
    VariableColumn{"less", "tolerance -", false, true, 0},
    VariableColumn{"more", "tolerance +", false, true, 0},
    VariableColumn{"together_less", "all at once -", false, true, 0},
    VariableColumn{"together_more", "all at once +", false, true, 0},
    VariableColumn{"stands", "position", true, true, 1},
    VariableColumn{"slope_less", "slope, less", false, false, 0},
    VariableColumn{"slope_more", "slope, more", false, false, 0}};

// In the order of the columns.
std::array<std::string, variable_columns.size()> variable_cells(const SizedDesign& design,
                                                                std::size_t i) {
  const SizedVariable& sized = design.variables[i];
  const SizeVariable& about = sized.variable;
  const Sensitivity& of = sized.sensitivity;
  const auto* ways = design.together ? &design.together->ways[i] : nullptr;
  return {about.name,
          *about.unit == '\0' ? "1" : about.unit,
          short_number(about.bounds.low),
          short_number(about.bounds.high),
          short_number(about.nominal),
          short_number(sized.value),
          off(design, of.less),
          off(design, of.more),
          ways != nullptr ? off_together(ways->less, of.less) : "-",
          ways != nullptr ? off_together(ways->more, of.more) : "-",
          stands(design, sized),
          short_number(of.slope_less),
          short_number(of.slope_more)};
}

// If there is one dimension only, the columns for all at once are left out.
Table variable_table(const SizedDesign& design, bool all) {
  const bool together = design.together && design.variables.size() > 1;
  const auto is_shown = [&](const VariableColumn& column) {
    if (all) return true;
    return column.usual && (together || !std::string_view(column.key).starts_with("together"));
  };
  Table table;
  for (const VariableColumn& column : variable_columns) {
    if (!is_shown(column)) continue;
    table.columns.push_back({column.heading, "", column.is_text, column.dispensable, column.key});
  }
  for (std::size_t i = 0; i < design.variables.size(); ++i) {
    const auto cells = variable_cells(design, i);
    std::vector<std::string> shown;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (is_shown(variable_columns.at(k))) shown.push_back(cells.at(k));
    }
    table.add(std::move(shown));
  }
  return table;
}

std::string flat_text(const SizedDesign& design, const FlatDirection& flat) {
  return fmt::format("Flat direction: {} (or back) costs {}", moves_text(design, flat.moves),
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

// Returns the possible shares of a target at the nominal coefficients.
DocumentLine target_line(const SizingOptions& options, const SizedDesign& design) {
  const std::vector<double>& target = options.goal.target;
  const std::size_t worst = worst_finger(target, design.nearest_shares);
  const double share = on_grid(design.nearest_shares[worst]);
  const double wanted = on_grid(target[worst]);
  const int digits = telling_digits({share, wanted});
  const std::string at_best =
      share == wanted
          ? std::string("at the nominal coefficients there are dimensions that meet it")
          : fmt::format(
                "at the nominal coefficients shares miss it by {:.4g} at best, where finger "
                "{} has {:.{}g} of all pull instead of {:.{}g}",
                on_grid(*design.least_miss), worst + 1, share, digits, wanted, digits);
  if (!is_met(design)) {
    return {"The target is out of reach within the bounds: " + at_best, true};
  }
  if (on_grid(*design.least_miss) == 0 && !options.robust) return {"The target is met"};
  const std::string here =
      options.robust ? fmt::format(
                           "; those above, sized for the quantile over the draws, miss it "
                           "by {:.4g} there",
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
    section.table = variable_table(design, false);
  }
  if (design.least_miss) section.lines.push_back(target_line(report.options, design));
  if (!report.partial && !design.variables.empty()) {
    section.lines.push_back(
        {"Tolerance: change of one dimension alone that costs " + tolerance_text(report.options)});
    const std::string together = together_text(report.options, design);
    if (!together.empty()) section.lines.push_back({together});
    const std::string any = any_text(design);
    if (!any.empty()) section.lines.push_back({any});
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
  return {
      "Shares of the fingers in the sum of their pulls, at the nominal coefficients", table, {}};
}

}  // namespace

std::string differing_settings(const std::string& summary, const Model& model,
                               const GraspSet& grasps) {
  const Json explored = Json::parse(summary, nullptr, false);
  if (!explored.is_object() || !explored.contains("settings")) return "";
  const Json now = settings_json({}, authors_score(), grasps, model, 0);
  std::string differing;
  for (const char* key : {"hardware", "model", "grasps"}) {
    Json there = explored["settings"].value(key, Json(nullptr));
    if (there.is_object()) there.erase("unconverged");
    Json here = now[key];
    if (here.is_object()) here.erase("unconverged");
    if (there != here) differing += (differing.empty() ? "" : ", ") + std::string(key);
  }
  return differing;
}

SizingSections sizing_sections(const SizingReport& report) {
  return {opening_lines(report), ranking_section(report), best_section(report),
          shares_section(report), objective_section(report)};
}

Document sizing_document(const SizingReport& report, const std::vector<std::string>& columns) {
  SizingSections sections = sizing_sections(report);
  Document document{{{"", std::nullopt, std::move(sections.opening)}}};
  if (!columns.empty()) {
    const std::vector<std::string> of_dimensions = dimension_column_names();
    const bool dimensions =
        std::ranges::find(of_dimensions, columns.front()) != of_dimensions.end();
    Section& section = dimensions ? sections.best : sections.ranking;
    section.table = with_columns(dimensions ? variable_table(report.designs.front().design, true)
                                            : sized_table(report, true),
                                 columns);
    document.add(std::move(section));
    return document;
  }
  for (Section* section :
       {&sections.ranking, &sections.best, &sections.shares, &sections.objectives}) {
    document.add(std::move(*section));
  }
  return document;
}

std::vector<std::string> dimension_column_names() {
  std::vector<std::string> names;
  for (const VariableColumn& column : variable_columns) names.emplace_back(column.key);
  return names;
}

std::vector<std::string> sized_column_names(const Hardware& hardware) {
  std::vector<std::string> names{"rank",    "rank_before", "name",
                                 "routing", "goal_before", "goal_sized"};
  for (const ObjectiveRow& row : objective_table()) {
    const bool there = !row.of_hand || hand(hardware);
    if (there && row.objective != Objective::cost) names.emplace_back(row.name);
  }
  return names;
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
