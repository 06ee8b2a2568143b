#include "reports/exploration/ladder_report.hpp"

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
double gain(Objective objective, const Rung& rung, const Rung& before) {
  const double more = value(rung.design.values, objective) - value(before.design.values, objective);
  return on_grid(row(objective).better == Better::higher ? more : -more);
}

std::string gain_cell(const ListedLadder& ladder, std::size_t i, Objective objective) {
  if (i == 0) return "";
  const std::vector<Rung>& rungs = ladder.ladder.rungs;
  const double before = std::abs(value(rungs[i - 1].design.values, objective));
  const double more = gain(objective, rungs[i], rungs[i - 1]);
  const bool is_part = std::isfinite(before) && std::isfinite(more) && (before != 0 || more == 0);
  return !is_part ? "-" : signed_percent(before == 0 ? 0 : more / before);
}

std::string marks(const ListedLadder& ladder, std::size_t i) {
  const Ladder& all = ladder.ladder;
  const std::string& word = all.rungs[i].design.word;
  std::string text;
  const auto add = [&](const std::string& mark) { text += (text.empty() ? "" : ", ") + mark; };
  if (all.knee == i) add("knee");
  if (all.affordable && all.affordable->word == word) add(within_text(all.options));
  if (all.first.word == word) add("best");
  return text;
}

// Returns the decimals of the ladder's first column.
int by_decimals(const Ladder& ladder) {
  int decimals = row(ladder.options.by).decimals;
  for (const Rung& rung : ladder.rungs) {
    decimals = std::max(decimals, shown_decimals(ladder.options.by, rung.at_most));
  }
  return decimals;
}

std::vector<TableColumn> columns(const Ladder& ladder, const std::string& cost_unit) {
  std::vector<TableColumn> columns{
      number_column(row(ladder.options.by).heading, objective_unit(ladder.options.by, cost_unit)),
      text_column("name"), text_column("routing")};
  for (const Objective objective : ladder.objectives) {
    if (objective == ladder.options.by) continue;
    columns.push_back(
        number_column(objective_heading(objective), objective_unit(objective, cost_unit)));
    columns.push_back(number_column("gain", "", 1));
  }
  columns.push_back(number_column("kept", "", 2));
  columns.push_back(text_column(""));
  return columns;
}

Json by_objective(const Ladder& ladder, const auto& number_of) {
  Json json = Json::object();
  for (const Objective objective : ladder.objectives) {
    json[row(objective).name] = number(number_of(objective));
  }
  return json;
}

Json losses_json(const Ladder& ladder, const ObjectiveValues& values) {
  return by_objective(
      ladder, [&](Objective objective) { return loss(objective, values, ladder.first.values); });
}

// A design that the answer names beside the first.
Json chosen_json(const Ladder& ladder, const ListedDesign& design) {
  const RankedDesign& ranked = design.ranked;
  Json entry{{"routing", ranked.design.word},
             {"name", text_or_null(design.name)},
             {"rank", ranked.rank > 0 ? Json(ranked.rank) : Json(nullptr)}};
  entry["losses"] = losses_json(ladder, ranked.design.values);
  add_objectives(entry, ranked.design.values);
  return entry;
}

// Adds to a chosen design the parts that the wearer carries at the hand.
Json wearer_json(const Ladder& ladder, const ListedDesign& design) {
  Json entry = chosen_json(ladder, design);
  const WearerParts parts = wearer_parts(design.routing);
  entry["moving_parts"] = parts.moving_parts;
  entry["strands"] = parts.strands;
  return entry;
}

Json rung_json(const ListedLadder& listed, std::size_t i) {
  const Ladder& ladder = listed.ladder;
  const Rung& rung = ladder.rungs[i];
  const RankedDesign& ranked = listed.rungs[i].ranked;
  Json json{{"at_most", number(rung.at_most)},
            {"routing", rung.design.word},
            {"name", text_or_null(listed.rungs[i].name)},
            {"rank", ranked.rank > 0 ? Json(ranked.rank) : Json(nullptr)},
            {"kept", rung.kept}};
  json["gains"] = i == 0 ? Json(nullptr) : by_objective(ladder, [&](Objective objective) {
    return gain(objective, rung, ladder.rungs[i - 1]);
  });
  json["losses"] = losses_json(ladder, rung.design.values);
  add_objectives(json, rung.design.values);
  return json;
}

std::string csv_row(const ListedLadder& listed, std::size_t i) {
  const Ladder& ladder = listed.ladder;
  const Rung& rung = ladder.rungs[i];
  const std::size_t rank = listed.rungs[i].ranked.rank;
  std::string line =
      fmt::format("{},{},{},{},{},{},{}", row(ladder.options.by).name, rung.at_most,
                  rung.design.word, csv_field(listed.rungs[i].name),
                  rank > 0 ? std::to_string(rank) : "", rung.kept, csv_field(marks(listed, i)));
  append_objective_cells(line, rung.design.values);
  for (const Objective objective : ladder.objectives) {
    line += i == 0 ? "," : "," + csv_number(gain(objective, rung, ladder.rungs[i - 1]));
  }
  for (const Objective objective : ladder.objectives) {
    line += "," + csv_number(loss(objective, rung.design.values, ladder.first.values));
  }
  return line + '\n';
}

}  // namespace

ListedLadder shortest_ladder(const ListedDesign& line, const Order& order,
                             const LadderOptions& options) {
  ListedLadder ladder;
  ladder.ladder.options = options;
  ladder.ladder.objectives = ranked_by(order);
  ladder.ladder.first = line.ranked.design;
  Rung rung;
  rung.design = line.ranked.design;
  ladder.ladder.rungs = {rung, rung};
  ladder.rungs = {line, line};
  return ladder;
}

Section ladder_section(const ListedLadder& ladder) {
  const Ladder& all = ladder.ladder;
  if (all.rungs.size() < 2) return {};
  Table table{columns(all, ladder.cost_unit), {}};
  const int decimals = by_decimals(all);
  for (std::size_t i = 0; i < all.rungs.size(); ++i) {
    const ListedDesign& design = ladder.rungs[i];
    std::vector<std::string> cells{fixed(all.rungs[i].at_most, decimals),
                                   design.name.empty() ? "-" : design.name,
                                   design.ranked.design.word};
    for (const Objective objective : all.objectives) {
      if (objective == all.options.by) continue;
      cells.push_back(fixed(value(design.ranked.design.values, objective),
                            shown_decimals(objective, ladder.rungs)));
      cells.push_back(gain_cell(ladder, i, objective));
    }
    cells.push_back(percent(all.rungs[i].kept));
    cells.push_back(marks(ladder, i));
    table.add(std::move(cells));
  }
  return {ladder_title(all), table, {}};
}

std::string ladder_csv(const ListedLadder& ladder, const std::string& note) {
  std::string csv = note.empty() ? "" : "# " + note + "\n";
  csv += "ladder,at_most,routing,name,rank,kept,marks";
  csv += objective_headings(ladder.ladder.first.values);
  for (const char* start : {"gain_", "loss_"}) {
    for (const Objective objective : ladder.ladder.objectives) {
      csv += fmt::format(",{}{}", start, row(objective).name);
    }
  }
  csv += '\n';
  for (std::size_t i = 0; i < ladder.rungs.size(); ++i) csv += csv_row(ladder, i);
  return csv;
}

Json ladder_json(const ListedLadder& ladder) {
  const Ladder& all = ladder.ladder;
  Json json{{"by", row(all.options.by).name}, {"within", all.options.within}};
  const auto entry = [&](const ListedDesign& design) { return chosen_json(all, design); };
  json["affordable"] = value_or_null(ladder.affordable, entry);
  json["floating_blocks"] = value_or_null(ladder.choice, [&](const auto& choice) {
    return Json{{"without", wearer_json(all, choice.without)},
                {"with", wearer_json(all, choice.with)},
                {"with_bars", value_or_null(ladder.with_bars, [&](const ListedDesign& barred) {
                   return wearer_json(all, barred);
                 })}};
  });
  json["knee"] =
      value_or_null(all.knee, [&](std::size_t rung) { return number(all.rungs[rung].at_most); });
  json["rungs"] = Json::array();
  for (std::size_t i = 0; i < all.rungs.size(); ++i) json["rungs"].push_back(rung_json(ladder, i));
  return json;
}

void add_ladder_settings(Json& settings, const LadderOptions& options,
                         const std::optional<PartPrices>& prices) {
  settings["ladder"] = {{"by", row(options.by).name}, {"within", options.within}};
  settings["prices"] =
      value_or_null(prices, [](const PartPrices& given) { return to_json(given); });
}

}  // namespace reeve::reports
