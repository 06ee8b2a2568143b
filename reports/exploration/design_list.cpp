#include "reports/exploration/design_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "core/text.hpp"
#include "reports/exploration/band_report.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/jam_words.hpp"
#include "reports/output/csv_field.hpp"
#include "reports/shown_value.hpp"
#include "search/uncertainty/sweep.hpp"

namespace reeve::reports {
namespace {

// A column of drawn results of listed designs. It has the same name in the CSV, and can be chosen
// for a table.
struct DrawnColumn {
  TableColumn column;                                    // its key is the name
  std::function<std::string(const ListedDesign&)> cell;  // "-" where nothing was drawn
};

DrawnColumn named_column(const std::string& key, const std::string& heading,
                         const std::string& unit,
                         std::function<std::string(const ListedDesign&)> cell) {
  DrawnColumn made{number_column(heading, unit), std::move(cell)};
  made.column.key = key;
  return made;
}

DrawnColumn place_column(const std::string& key, const std::string& heading,
                         double RankDistribution::*part, bool is_share) {
  return named_column(key, heading, "",
                      [part, is_share](const ListedDesign& design) -> std::string {
                        if (!design.distribution) return "-";
                        const double number = (*design.distribution).*part;
                        return is_share ? share_text(number) : fixed(number, 0);
                      });
}

DrawnColumn band_column(const ObjectiveRow& row, const std::string& key, const std::string& heading,
                        double Band::*part) {
  const std::string whose =
      *row.part == '\0' ? row.heading : std::string(row.heading) + ", " + row.part;
  const auto cell = [&row, part](const ListedDesign& design) -> std::string {
    const Band* band = find_band(design.bands, row.objective);
    return band == nullptr ? "-" : fixed((*band).*part, row.decimals);
  };
  return named_column(std::string(row.name) + "_" + key, whose + ", " + heading,
                      objective_unit(row.objective), cell);
}

// Place, constraints, and a median and two quantiles of each objective that friction moves.
std::vector<DrawnColumn> drawn_columns(bool with_hand, bool with_constraints) {
  std::vector<DrawnColumn> columns{
      place_column("first_share", "first", &RankDistribution::first, true),
      place_column("first_shared", "first, shared", &RankDistribution::first_shared, true),
      place_column("rank_median", "median place", &RankDistribution::median, false),
      place_column("rank_p5", "place, 5 %", &RankDistribution::low, false),
      place_column("rank_p95", "place, 95 %", &RankDistribution::high, false)};
  if (with_constraints) {
    columns.push_back(
        named_column("constraints_met", "meets all", "", [](const ListedDesign& design) {
          return design.constraints_met ? share_text(*design.constraints_met) : std::string("-");
        }));
  }
  for (const Objective objective : friction_objectives(with_hand)) {
    const ObjectiveRow& about = row(objective);
    columns.push_back(band_column(about, "median", "median", &Band::median));
    columns.push_back(band_column(about, "p5", "5 %", &Band::low));
    columns.push_back(band_column(about, "p95", "95 %", &Band::high));
  }
  return columns;
}

bool with_distributions(const std::vector<ListedDesign>& designs) {
  return std::ranges::any_of(
      designs, [](const ListedDesign& design) { return design.distribution.has_value(); });
}

// An objective in a column, with as many decimals as the column's cells take.
struct ColumnRow {
  const ObjectiveRow* row;
  int decimals;
};
// Objectives that make one column: the parts of one family.
using ColumnRows = std::vector<ColumnRow>;

bool has_blocks(const std::vector<ListedDesign>& designs) {
  return std::ranges::any_of(designs, [](const ListedDesign& design) {
    return value(design.ranked.design.values, Objective::blocks) > 0;
  });
}

bool has_alike(const std::vector<ListedDesign>& designs) {
  return std::ranges::any_of(designs,
                             [](const ListedDesign& design) { return !design.equivalent.empty(); });
}

bool has_cost(const std::vector<ListedDesign>& designs) {
  return !designs.empty() &&
         std::isfinite(value(designs.front().ranked.design.values, Objective::cost));
}

ColumnRow column_row(const ObjectiveRow& row, const std::vector<ListedDesign>& designs) {
  return {&row, shown_decimals(row.objective, designs)};
}

std::vector<ColumnRows> all_columns(const std::vector<ListedDesign>& designs) {
  std::vector<ColumnRows> columns;
  for (const ObjectiveRow& row : objective_table()) columns.push_back({column_row(row, designs)});
  return columns;
}

std::vector<ColumnRows> objective_columns(const std::vector<ListedDesign>& designs,
                                          std::vector<Objective> shown, const ListColumns& wanted) {
  if (!wanted.chosen.empty()) return all_columns(designs);
  const bool told = std::ranges::find(shown, Objective::blocks) != shown.end();
  if (!told && has_blocks(designs)) shown.push_back(Objective::blocks);
  const bool priced = std::ranges::find(shown, Objective::cost) != shown.end();
  if (!priced && has_cost(designs)) shown.push_back(Objective::cost);
  std::vector<ColumnRows> columns;
  for (const Objective objective : shown) {
    const ObjectiveRow& about = row(objective);
    const bool joins = !wanted.apart && !columns.empty() &&
                       std::string_view(columns.back().front().row->family) == about.family;
    if (!joins) columns.emplace_back();
    columns.back().push_back(column_row(about, designs));
  }
  return columns;
}

TableColumn objective_column(const ColumnRows& rows, bool apart, const std::string& cost_unit) {
  const ObjectiveRow& row = *rows.front().row;
  const std::string part = apart && *row.part != '\0' ? std::string(", ") + row.part : "";
  TableColumn column =
      number_column(row.heading + part, objective_unit(row.objective, cost_unit), row.dispensable);
  column.key = row.name;
  return column;
}

std::string objective_cell(const ColumnRows& rows, const ObjectiveValues& values) {
  return joined(rows, "/", [&](const ColumnRow& of) {
    return fixed(value(values, of.row->objective), of.decimals);
  });
}

std::vector<TableColumn> columns(const std::vector<ColumnRows>& objectives, bool equivalent,
                                 bool apart, const std::string& cost_unit) {
  std::vector<TableColumn> columns{number_column("rank"), number_column("front", "", 2),
                                   text_column("name"), text_column("routing")};
  if (equivalent) columns.push_back(number_column("alike", "", 1));
  for (const ColumnRows& rows : objectives) {
    columns.push_back(objective_column(rows, apart, cost_unit));
  }
  return columns;
}

// To choose from: of what was not asked for the names are refused.
void add_places_and_draws(const std::vector<ListedDesign>& designs, Table& table) {
  const std::vector<DrawnColumn> columns = drawn_columns(true, true);
  table.columns.push_back(number_column("place"));
  for (const DrawnColumn& drawn : columns) table.columns.push_back(drawn.column);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    std::vector<std::string>& cells = table.rows[i].cells;
    cells.push_back(std::to_string(designs[i].place));
    for (const DrawnColumn& drawn : columns) cells.push_back(drawn.cell(designs[i]));
  }
}

// Without a stretch that is not known, a stroke looks shorter than those of other designs.
std::vector<DocumentLine> spring_lines(const std::vector<ListedDesign>& shown,
                                       const TendonParts& tendons) {
  const bool has_springs = std::ranges::any_of(
      tendons.own, [](const TendonHardware& own) { return own.stiffness_N_mm.has_value(); });
  const bool has_hands = std::ranges::any_of(
      shown, [](const ListedDesign& design) { return has_hand(design.ranked.design.values); });
  if (!has_springs || !has_hands) return {};
  return {{"Strokes leave out the stretch of springs in series where reeve show says so"}};
}

}  // namespace

std::vector<std::string> list_column_names(const ListedWith& with) {
  std::vector<std::string> names{"rank", "front", "name", "routing", "alike"};
  for (const ObjectiveRow& row : objective_table()) {
    if (row.of_hand && !with.hand) continue;
    if (row.objective == Objective::cost && !with.prices) continue;
    names.emplace_back(row.name);
  }
  names.emplace_back("place");
  if (!with.draws) return names;
  for (const DrawnColumn& drawn : drawn_columns(with.hand, with.constraints)) {
    names.push_back(drawn.column.key);
  }
  return names;
}

std::vector<MissingColumns> missing_columns(const ListedWith& with) {
  ListedWith drawn = with;
  drawn.draws = true;
  ListedWith evaluated = drawn;
  evaluated.constraints = true;
  ListedWith priced = with;
  priced.prices = true;
  ListedWith handed = drawn;
  handed.hand = true;
  return {{list_column_names(drawn), "--uncertainty"},
          {list_column_names(evaluated), "--constraint and --uncertainty of explore"},
          {list_column_names(priced), "--cost"},
          {list_column_names(handed), with.draws ? "a hand in the hardware file"
                                                 : "a hand in the hardware file, for bands also "
                                                   "--uncertainty"}};
}

Table design_table(const std::vector<ListedDesign>& designs, std::vector<Objective> shown,
                   const ListColumns& wanted) {
  const bool all = !wanted.chosen.empty();
  const std::vector<ColumnRows> objectives = objective_columns(designs, std::move(shown), wanted);
  const bool equivalent = all || has_alike(designs);
  Table table{columns(objectives, equivalent, all || wanted.apart, wanted.cost_unit), {}};
  for (const ListedDesign& design : designs) {
    std::vector<std::string> cells{
        std::to_string(design.ranked.rank), std::to_string(design.ranked.front),
        design.name.empty() ? "-" : design.name, design.ranked.design.word};
    if (equivalent)
      cells.push_back(design.equivalent.empty() ? ""
                                                : fmt::format("+{}", design.equivalent.size()));
    for (const ColumnRows& rows : objectives) {
      cells.push_back(objective_cell(rows, design.ranked.design.values));
    }
    table.add(std::move(cells));
  }
  if (!all) return table;
  add_places_and_draws(designs, table);
  return with_columns(table, wanted.chosen);
}

ListedDesign shortest_line(const std::string& word, const Order& order, const ListedWith& with) {
  ListedDesign line{};
  line.ranked.design.word = word;
  if (!with.prices) {
    line.ranked.design.values[static_cast<std::size_t>(Objective::cost)] =
        std::numeric_limits<double>::infinity();
  }
  if (!with.draws) return line;
  line.distribution = RankDistribution{};
  if (with.constraints) line.constraints_met = 0;
  for (const Objective objective : swept_objectives(order)) {
    line.bands.push_back({objective, {0, 0, 1}});
  }
  return line;
}

ListColumns priced(ListColumns wanted, const std::optional<PartPrices>& prices) {
  wanted.cost_unit = cost_unit(prices);
  return wanted;
}

std::vector<ListedDesign> one_of_each(const std::vector<ListedDesign>& designs, std::size_t most) {
  std::vector<ListedDesign> firsts;
  for (const ListedDesign& design : designs) {
    if (firsts.size() == most) break;
    if (design.same_as.empty()) firsts.push_back(design);
  }
  return firsts;
}

std::vector<DocumentLine> list_notes(const std::vector<ListedDesign>& shown,
                                     const TendonParts& tendons) {
  std::vector<DocumentLine> lines = equivalent_lines(shown);
  append(lines, shared_carriage_lines(shown, tendons));
  append(lines, spring_lines(shown, tendons));
  return lines;
}

std::string objective_headings(const ObjectiveValues& values) {
  std::string text;
  for (const ObjectiveRow& row : objective_table()) {
    if (is_there(row, values)) text += std::string(",") + row.name;
  }
  return text;
}

void append_objective_cells(std::string& csv, const ObjectiveValues& values) {
  for (const ObjectiveRow& row : objective_table()) {
    if (!is_there(row, values)) continue;
    csv += ',';
    csv += csv_number(value(values, row.objective));
  }
}

std::string sample_csv(const std::vector<Design>& designs, const std::string& note) {
  std::string csv = note.empty() ? "" : "# " + note + "\n";
  csv +=
      "routing" + objective_headings(designs.empty() ? ObjectiveValues{} : designs.front().values);
  csv += '\n';
  for (const Design& design : designs) {
    csv += design.word;
    append_objective_cells(csv, design.values);
    csv += '\n';
  }
  return csv;
}

std::string design_csv(const std::vector<ListedDesign>& designs, const std::string& note) {
  const bool uncertain = with_distributions(designs);
  const bool constrained = !designs.empty() && designs.front().constraints_met.has_value();
  std::string csv = note.empty() ? "" : "# " + note + "\n";
  csv += "rank,front,routing,name";
  csv += objective_headings(designs.empty() ? ObjectiveValues{}
                                            : designs.front().ranked.design.values);
  const Bands& bands = designs.empty() ? Bands{} : designs.front().bands;
  csv += uncertain ? ",first_share,rank_median,rank_p5,rank_p95" : "";
  csv += ",smallest_jams,same_as,place";
  csv += (uncertain ? ",first_shared" : "") + band_headings(bands);
  csv += constrained ? ",constraints_met\n" : "\n";
  for (const ListedDesign& design : designs) {
    csv += fmt::format_int(design.ranked.rank).c_str();
    csv += ',';
    csv += fmt::format_int(design.ranked.front).c_str();
    csv += ',' + design.ranked.design.word + ',' + csv_field(design.name);
    append_objective_cells(csv, design.ranked.design.values);
    if (design.distribution) {
      const RankDistribution& d = *design.distribution;
      fmt::format_to(std::back_inserter(csv), ",{},{},{},{}", d.first, d.median, d.low, d.high);
    } else if (uncertain) {
      csv += ",,,,";
    }
    csv += ',' + jams_field(design.smallest_jams) + ',' + design.same_as + ',';
    csv += fmt::format_int(design.place).c_str();
    if (uncertain) {
      csv += design.distribution ? fmt::format(",{}", design.distribution->first_shared) : ",";
      csv += design.bands.empty() ? std::string(3 * bands.size(), ',') : band_cells(design.bands);
    }
    if (constrained)
      csv += "," + (design.constraints_met ? csv_number(*design.constraints_met) : "");
    csv += '\n';
  }
  return csv;
}

Json to_json(const ListedDesign& design) {
  Json json{{"rank", design.ranked.rank},
            {"front", design.ranked.front},
            {"routing", design.ranked.design.word},
            {"name", text_or_null(design.name)}};
  add_objectives(json, design.ranked.design.values);
  json["smallest_jams"] = grasps_json(design.smallest_jams);
  json["alike"] = design.equivalent;
  json["same_as"] = text_or_null(design.same_as);
  json["place"] = design.place;
  if (design.distribution) {
    json["rank_distribution"] = {{"first_share", design.distribution->first},
                                 {"median", design.distribution->median},
                                 {"p5", design.distribution->low},
                                 {"p95", design.distribution->high},
                                 {"first_shared", design.distribution->first_shared}};
    json["bands"] = bands_json(design.bands);
  }
  if (design.constraints_met) json["constraints_met"] = *design.constraints_met;
  return json;
}

Json to_json(const std::vector<ListedDesign>& designs) {
  return list_json(designs, [](const ListedDesign& design) { return to_json(design); });
}

Json never_jams_json(const ListedTradeoff& tradeoff) {
  return value_or_null(tradeoff.never_jams,
                       [](const ListedDesign& design) { return to_json(design); });
}

Json to_json(const std::vector<BestDesigns>& best) {
  return list_json(best, [](const BestDesigns& one) {
    return Json{{"objective", row(one.objective).name},
                {"value", number(one.value)},
                {"count", one.count},
                {"routings", one.words}};
  });
}

}  // namespace reeve::reports
