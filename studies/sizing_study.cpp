#include "studies/sizing_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "core/notation.hpp"
#include "readings/csv.hpp"
#include "search/rank/ranking.hpp"
#include "sizing/size_space.hpp"

namespace reeve::studies {
namespace {

using GoalOf = SizedGoal SizedDesign::*;

// On the grid, so that equal goals tie.
auto key(const SizedRouting& routing, GoalOf of, Better better) {
  const SizedGoal& goal = routing.design.*of;
  const double loss = on_grid(better == Better::higher ? -goal.goal : goal.goal);
  return std::make_tuple(loss, part_total(goal.values), std::string_view(routing.word));
}

void sort(std::vector<SizedRouting>& designs, GoalOf of, Better better) {
  std::ranges::sort(designs, {},
                    [&](const SizedRouting& routing) { return key(routing, of, better); });
}

}  // namespace

std::vector<Routing> explored_designs(const std::filesystem::path& folder, std::size_t count) {
  CsvReader csv = CsvReader::open(folder / "designs.csv");
  const std::vector<std::string>& columns = csv.header().fields;
  const auto column = std::ranges::find(columns, "routing");
  if (column == columns.end()) {
    throw InputError({.where = csv.name(),
                      .what = "no column 'routing'",
                      .expected = "the designs.csv of an exploration",
                      .form = InputForm::unknown});
  }
  std::vector<Routing> routings;
  for (CsvRow row; routings.size() < count && csv.next(row);) {
    if (row.ragged) throw InputError(*row.ragged);
    const std::string& word = row.fields[static_cast<std::size_t>(column - columns.begin())];
    try {
      routings.push_back(parse_routing(word));
    } catch (const InputError& error) {
      throw error.at(fmt::format("{}:{}", csv.name(), row.line));
    }
  }
  if (routings.empty()) {
    throw InputError(
        {.where = csv.name(), .what = "it holds no design", .form = InputForm::unknown});
  }
  return routings;
}

bool best_meets_target(const SizingReport& report) { return is_met(report.designs.front().design); }

SizingReport planned_sizing(const std::vector<Routing>& routings, const SizingOptions& options,
                            const Catalogue& catalogue) {
  SizingReport report;
  report.options = options;
  report.partial = true;
  for (const Routing& routing : routings) {
    SizedRouting planned;
    planned.word = to_word(routing);
    planned.name = name_of(catalogue, routing);
    planned.design.routing = routing;
    const std::vector<double>& target = options.goal.target;
    planned.design.before.shares = planned.design.after.shares = target;
    const SizeSpace space =
        size_space(expand(routing), options.nominal.hardware, options.varied, options.equal);
    for (const SizeVariable& variable : space.variables) {
      SizedVariable as_it_is;
      as_it_is.variable = variable;
      as_it_is.value = variable.nominal;
      planned.design.variables.push_back(std::move(as_it_is));
    }
    report.designs.push_back(std::move(planned));
  }
  return report;
}

SizingReport sizing_study(const std::vector<Routing>& routings, const SizingOptions& options,
                          const Catalogue& catalogue, const StudySupervision& supervision) {
  SizingResult result = size(routings, options, supervision.during("sizing"));
  SizingReport report{options, {}, result.partial, result.unconverged};
  for (SizedDesign& design : result.designs) {
    const std::string word = to_word(design.routing);
    const std::string name = name_of(catalogue, design.routing);
    report.designs.push_back({std::move(design), word, name, 0, 0});
  }
  const Better better = options.goal.better();
  std::vector<SizedRouting>& designs = report.designs;
  sort(designs, &SizedDesign::before, better);
  for (std::size_t i = 0; i < designs.size(); ++i) designs[i].rank_before = i + 1;
  sort(designs, &SizedDesign::after, better);
  for (std::size_t i = 0; i < designs.size(); ++i) designs[i].rank_after = i + 1;
  return report;
}

SizingDetails sizing_details(const SizingReport& report, const Catalogue& catalogue) {
  const SizingOptions& options = report.options;
  const SizedDesign& best = report.designs.front().design;
  Model sized = options.nominal;
  sized.hardware = best.hardware;
  const auto shown = [&](const Model& model) {
    return shown_routing(best.routing, model, options.grasps, Direction::pull, catalogue);
  };
  SizingDetails details{shown(options.nominal), shown(sized), {}};
  if (details.before.hand) details.before.hand->drawn = best.before.motor;
  if (details.sized.hand) details.sized.hand->drawn = best.after.motor;
  if (report.partial) return details;
  std::vector<double> point;
  std::vector<Interval> spans;
  for (std::size_t i = 0; i < best.variables.size(); ++i) {
    const SizedVariable& variable = best.variables[i];
    const Sensitivity& alone = variable.sensitivity;
    const Interval& bounds = variable.variable.bounds;
    point.push_back(variable.value);
    spans.push_back({std::min(bounds.low, variable.value - alone.less.value_or(0)),
                     std::max(bounds.high, variable.value + alone.more.value_or(0))});
  }
  details.profiles = goal_profiles(SizingProblem(best.routing, options), point, spans);
  return details;
}

}  // namespace reeve::studies
