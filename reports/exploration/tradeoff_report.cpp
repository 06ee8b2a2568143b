#include "reports/exploration/tradeoff_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "core/wearer_parts.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/exploration/design_list.hpp"
#include "reports/output/csv_field.hpp"
#include "reports/shown_value.hpp"

namespace reeve::reports {
namespace {

// Better is positive, in the objective's own unit.
double gain(Objective objective, const TradeoffStep& step, const TradeoffStep& before) {
  const double more = value(step.design.values, objective) - value(before.design.values, objective);
  return on_grid(row(objective).better == Better::higher ? more : -more);
}

std::string gain_cell(const ListedTradeoff& tradeoff, std::size_t i, Objective objective) {
  if (i == 0) return "";
  const std::vector<TradeoffStep>& steps = tradeoff.tradeoff.steps;
  const double before = std::abs(value(steps[i - 1].design.values, objective));
  const double more = gain(objective, steps[i], steps[i - 1]);
  const bool is_part = std::isfinite(before) && std::isfinite(more) && (before != 0 || more == 0);
  return !is_part ? "-" : signed_percent(before == 0 ? 0 : more / before);
}

std::string marks(const ListedTradeoff& tradeoff, std::size_t i) {
  const Tradeoff& all = tradeoff.tradeoff;
  const std::string& word = all.steps[i].design.word;
  std::string text;
  const auto add = [&](const std::string& mark) { text += (text.empty() ? "" : ", ") + mark; };
  if (all.knee == i) add("knee");
  if (all.affordable && all.affordable->word == word) add(within_text(all.options));
  if (all.first.word == word) add("best");
  return text;
}

// Returns the decimals of the trade-off's first column.
int by_decimals(const Tradeoff& tradeoff) {
  int decimals = row(tradeoff.options.by).decimals;
  for (const TradeoffStep& step : tradeoff.steps) {
    decimals = std::max(decimals, shown_decimals(tradeoff.options.by, step.at_most));
  }
  return decimals;
}

std::vector<TableColumn> columns(const Tradeoff& tradeoff, const std::string& cost_unit) {
  std::vector<TableColumn> columns{number_column(row(tradeoff.options.by).heading,
                                                 objective_unit(tradeoff.options.by, cost_unit)),
                                   text_column("name"), text_column("routing")};
  for (const Objective objective : tradeoff.objectives) {
    if (objective == tradeoff.options.by) continue;
    columns.push_back(
        number_column(objective_heading(objective), objective_unit(objective, cost_unit)));
    columns.push_back(number_column("gain", "", 1));
  }
  columns.push_back(number_column("kept", "", 2));
  columns.push_back(text_column(""));
  return columns;
}

Json by_objective(const Tradeoff& tradeoff, const auto& number_of) {
  Json json = Json::object();
  for (const Objective objective : tradeoff.objectives) {
    json[row(objective).name] = number(number_of(objective));
  }
  return json;
}

Json losses_json(const Tradeoff& tradeoff, const ObjectiveValues& values) {
  return by_objective(tradeoff, [&](Objective objective) {
    return loss(objective, values, tradeoff.first.values);
  });
}

// A design that the answer names beside the first.
Json chosen_json(const Tradeoff& tradeoff, const ListedDesign& design) {
  const RankedDesign& ranked = design.ranked;
  Json entry{{"routing", ranked.design.word},
             {"name", text_or_null(design.name)},
             {"rank", ranked.rank > 0 ? Json(ranked.rank) : Json(nullptr)}};
  entry["losses"] = losses_json(tradeoff, ranked.design.values);
  add_objectives(entry, ranked.design.values);
  return entry;
}

// Adds to a chosen design the parts that the wearer carries at the hand.
Json wearer_json(const Tradeoff& tradeoff, const ListedDesign& design) {
  Json entry = chosen_json(tradeoff, design);
  const WearerParts parts = wearer_parts(design.routing);
  entry["moving_parts"] = parts.moving_parts;
  entry["strands"] = parts.strands;
  return entry;
}

Json step_json(const ListedTradeoff& listed, std::size_t i) {
  const Tradeoff& tradeoff = listed.tradeoff;
  const TradeoffStep& step = tradeoff.steps[i];
  const RankedDesign& ranked = listed.steps[i].ranked;
  Json json{{"at_most", number(step.at_most)},
            {"routing", step.design.word},
            {"name", text_or_null(listed.steps[i].name)},
            {"rank", ranked.rank > 0 ? Json(ranked.rank) : Json(nullptr)},
            {"kept", step.kept}};
  json["gains"] = i == 0 ? Json(nullptr) : by_objective(tradeoff, [&](Objective objective) {
    return gain(objective, step, tradeoff.steps[i - 1]);
  });
  json["losses"] = losses_json(tradeoff, step.design.values);
  add_objectives(json, step.design.values);
  return json;
}

std::string csv_row(const ListedTradeoff& listed, std::size_t i) {
  const Tradeoff& tradeoff = listed.tradeoff;
  const TradeoffStep& step = tradeoff.steps[i];
  const std::size_t rank = listed.steps[i].ranked.rank;
  std::string line =
      fmt::format("{},{},{},{},{},{},{}", row(tradeoff.options.by).name, step.at_most,
                  step.design.word, csv_field(listed.steps[i].name),
                  rank > 0 ? std::to_string(rank) : "", step.kept, csv_field(marks(listed, i)));
  append_objective_cells(line, step.design.values);
  for (const Objective objective : tradeoff.objectives) {
    line += i == 0 ? "," : "," + csv_number(gain(objective, step, tradeoff.steps[i - 1]));
  }
  for (const Objective objective : tradeoff.objectives) {
    line += "," + csv_number(loss(objective, step.design.values, tradeoff.first.values));
  }
  return line + '\n';
}

}  // namespace

ListedTradeoff shortest_tradeoff(const ListedDesign& line, const Order& order,
                                 const TradeoffOptions& options) {
  ListedTradeoff tradeoff;
  tradeoff.tradeoff.options = options;
  tradeoff.tradeoff.objectives = ranked_by(order);
  tradeoff.tradeoff.first = line.ranked.design;
  TradeoffStep step;
  step.design = line.ranked.design;
  tradeoff.tradeoff.steps = {step, step};
  tradeoff.steps = {line, line};
  return tradeoff;
}

Section tradeoff_section(const ListedTradeoff& tradeoff) {
  const Tradeoff& all = tradeoff.tradeoff;
  if (all.steps.size() < 2) return {};
  Table table{columns(all, tradeoff.cost_unit), {}};
  const int decimals = by_decimals(all);
  for (std::size_t i = 0; i < all.steps.size(); ++i) {
    const ListedDesign& design = tradeoff.steps[i];
    std::vector<std::string> cells{fixed(all.steps[i].at_most, decimals),
                                   design.name.empty() ? "-" : design.name,
                                   design.ranked.design.word};
    for (const Objective objective : all.objectives) {
      if (objective == all.options.by) continue;
      cells.push_back(fixed(value(design.ranked.design.values, objective),
                            shown_decimals(objective, tradeoff.steps)));
      cells.push_back(gain_cell(tradeoff, i, objective));
    }
    cells.push_back(percent(all.steps[i].kept));
    cells.push_back(marks(tradeoff, i));
    table.add(std::move(cells));
  }
  return {tradeoff_title(all), table, {}};
}

std::string tradeoff_csv(const ListedTradeoff& tradeoff, const std::string& note) {
  std::string csv = note.empty() ? "" : "# " + note + "\n";
  csv += "tradeoff,at_most,routing,name,rank,kept,marks";
  csv += objective_headings(tradeoff.tradeoff.first.values);
  for (const char* start : {"gain_", "loss_"}) {
    for (const Objective objective : tradeoff.tradeoff.objectives) {
      csv += fmt::format(",{}{}", start, row(objective).name);
    }
  }
  csv += '\n';
  for (std::size_t i = 0; i < tradeoff.steps.size(); ++i) csv += csv_row(tradeoff, i);
  return csv;
}

Json tradeoff_json(const ListedTradeoff& tradeoff) {
  const Tradeoff& all = tradeoff.tradeoff;
  Json json{{"by", row(all.options.by).name}, {"within", all.options.within}};
  const auto entry = [&](const ListedDesign& design) { return chosen_json(all, design); };
  json["affordable"] = value_or_null(tradeoff.affordable, entry);
  json["floating_blocks"] = value_or_null(tradeoff.choice, [&](const auto& choice) {
    return Json{{"without", wearer_json(all, choice.without)},
                {"with", wearer_json(all, choice.with)},
                {"with_bars", value_or_null(tradeoff.with_bars, [&](const ListedDesign& barred) {
                   return wearer_json(all, barred);
                 })}};
  });
  json["knee"] =
      value_or_null(all.knee, [&](std::size_t step) { return number(all.steps[step].at_most); });
  json["steps"] = Json::array();
  for (std::size_t i = 0; i < all.steps.size(); ++i)
    json["steps"].push_back(step_json(tradeoff, i));
  return json;
}

void add_tradeoff_settings(Json& settings, const TradeoffOptions& options,
                           const std::optional<PartPrices>& prices) {
  settings["tradeoff"] = {{"by", row(options.by).name}, {"within", options.within}};
  settings["prices"] =
      value_or_null(prices, [](const PartPrices& given) { return to_json(given); });
}

}  // namespace reeve::reports
