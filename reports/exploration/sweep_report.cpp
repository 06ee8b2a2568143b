#include "reports/exploration/sweep_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "drawing/chart/chart_axis.hpp"
#include "reports/exploration/band_report.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/model_text.hpp"
#include "reports/output/csv_field.hpp"
#include "reports/shown_value.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t columns_at_most = 8;
constexpr std::size_t rows_between = 4;
constexpr std::size_t leaders_named = 4;

// "TR3 and TR6, which are equal, come first"
std::string leaders_text(const SweptDesigns& swept, const SweepLead& lead) {
  std::vector<std::string> names;
  for (const std::size_t i : lead.first) names.push_back(short_name(swept.designs[i]));
  return enumerated(names, " and ", leaders_named) +
         (lead.first.size() == 1 ? " comes first" : ", which are equal, come first");
}

std::string coefficient_text(double value, int digits) {
  return fmt::format("{:.{}g}", value, digits);
}

// So that each coefficient and each end of a lead differs from its neighbours.
int digits_of(const Sweep& sweep) {
  std::vector<double> values = sweep.at;
  for (const SweepLead& lead : sweep.leads) values.push_back(lead.to);
  return telling_digits(std::move(values));
}

// So that the design that changes most changes from row to row.
int decimals_of(const SweptDesigns& swept, std::size_t objective, std::size_t rows) {
  double most = 0;
  for (const std::vector<SweepCurve>& curves : swept.sweep.designs) {
    chart::Extent extent;
    for (const double value : curves[objective].values) extent.add(value);
    if (!extent.empty()) most = std::max(most, extent.high - extent.low);
  }
  const Objective of = swept.sweep.designs.front()[objective].objective;
  return telling_decimals(on_grid(most), rows, row(of).decimals);
}

std::string sweep_cell(const SweepCurve& curve, std::size_t k, int decimals) {
  std::string nominal = fixed(curve.values[k], decimals);
  if (curve.bands.empty()) return nominal;
  const std::string range = range_text(curve.bands[k], decimals);
  return range.empty() ? nominal : fmt::format("{} ({})", nominal, range);
}

Table sweep_table(const SweptDesigns& swept, std::size_t objective) {
  const Sweep& sweep = swept.sweep;
  const std::size_t shown = std::min(swept.designs.size(), columns_at_most);
  Table table{{number_column(row(sweep.over.coefficient).name, row(sweep.over.coefficient).unit)},
              {}};
  for (std::size_t i = 0; i < shown; ++i) {
    table.columns.push_back(number_column(short_name(swept.designs[i])));
  }
  const int digits = digits_of(sweep);
  const int decimals =
      decimals_of(swept, objective, (sweep.at.size() + rows_between - 1) / rows_between);
  for (std::size_t k = 0; k < sweep.at.size(); k += rows_between) {
    std::vector<std::string> cells{coefficient_text(sweep.at[k], digits)};
    for (std::size_t i = 0; i < shown; ++i) {
      cells.push_back(sweep_cell(sweep.designs[i][objective], k, decimals));
    }
    table.add(std::move(cells));
  }
  return table;
}

Section objective_section(const SweptDesigns& swept, std::size_t objective) {
  const SweepCurve& curve = swept.sweep.designs.front()[objective];
  std::string title = fmt::format("{} over {}", objective_heading(curve.objective),
                                  row(swept.sweep.over.coefficient).name);
  title += curve.bands.empty() ? "" : " (5–95 % of the draws of all other coefficients)";
  if (swept.designs.size() > columns_at_most) {
    title += fmt::format("; the first {} of {} designs", columns_at_most, swept.designs.size());
  }
  return {title, sweep_table(swept, objective), {}};
}

Json band_numbers(const std::vector<Band>& bands, double Band::*part) {
  if (bands.empty()) return nullptr;
  return list_json(bands, [&](const Band& band) { return number(band.*part); });
}

Json curves_json(const std::vector<SweepCurve>& curves) {
  Json json = Json::object();
  for (const SweepCurve& curve : curves) {
    json[row(curve.objective).name] = {{"nominal", list_json(curve.values, number)},
                                       {"median", band_numbers(curve.bands, &Band::median)},
                                       {"p5", band_numbers(curve.bands, &Band::low)},
                                       {"p95", band_numbers(curve.bands, &Band::high)}};
  }
  return json;
}

Json leads_json(const SweptDesigns& swept) {
  const auto word = [&](std::size_t i) { return swept.designs[i].ranked.design.word; };
  return list_json(swept.sweep.leads, [&](const SweepLead& lead) {
    return Json{{"from", lead.from}, {"to", lead.to}, {"first", list_json(lead.first, word)}};
  });
}

std::string sweep_row(const SweptDesigns& swept, std::size_t i, std::size_t k) {
  const Sweep& sweep = swept.sweep;
  std::string line = fmt::format("{},{},{},{},{}", row(sweep.over.coefficient).name, sweep.at[k],
                                 swept.designs[i].ranked.design.word,
                                 csv_field(swept.designs[i].name), sweep.places[i][k]);
  for (const SweepCurve& curve : sweep.designs[i]) {
    line += "," + csv_number(curve.values[k]);
    if (!curve.bands.empty()) line += band_cells({{curve.objective, curve.bands[k]}});
  }
  return line + '\n';
}

}  // namespace

std::string coefficient_title(Coefficient coefficient) {
  const CoefficientRow& about = row(coefficient);
  return *about.unit == '\0' ? about.title : fmt::format("{}, {}", about.title, about.unit);
}

std::vector<std::string> lead_sentences(const SweptDesigns& swept) {
  const int digits = digits_of(swept.sweep);
  std::vector<std::string> sentences;
  for (const SweepLead& lead : swept.sweep.leads) {
    sentences.push_back(fmt::format("{} from {} to {}", leaders_text(swept, lead),
                                    coefficient_text(lead.from, digits),
                                    coefficient_text(lead.to, digits)));
  }
  return sentences;
}

std::vector<Section> sweep_sections(const SweptDesigns& swept) {
  if (swept.designs.empty()) return {};
  const CoefficientRange& over = swept.sweep.over;
  const int digits = digits_of(swept.sweep);
  Section leads{fmt::format("Over the {}, from {} to {}", coefficient_title(over.coefficient),
                            coefficient_text(over.range.low, digits),
                            coefficient_text(over.range.high, digits)),
                std::nullopt,
                {}};
  for (const std::string& sentence : lead_sentences(swept)) leads.lines.push_back({sentence});
  if (!swept.note.empty()) append(leads.lines, note_lines({swept.note}));
  std::vector<Section> sections{leads};
  for (std::size_t o = 0; o < swept.sweep.designs.front().size(); ++o) {
    sections.push_back(objective_section(swept, o));
  }
  return sections;
}

std::string sweep_csv(const SweptDesigns& swept, const std::string& note) {
  std::string csv = note.empty() ? "" : "# " + note + "\n";
  csv += "coefficient,at,routing,name,place";
  if (!swept.designs.empty()) {
    for (const SweepCurve& curve : swept.sweep.designs.front()) {
      csv += std::string(",") + row(curve.objective).name;
      if (!curve.bands.empty()) csv += band_headings({{curve.objective, {}}});
    }
  }
  csv += '\n';
  for (std::size_t i = 0; i < swept.designs.size(); ++i) {
    for (std::size_t k = 0; k < swept.sweep.at.size(); ++k) csv += sweep_row(swept, i, k);
  }
  return csv;
}

Json sweep_json(const SweptDesigns& swept) {
  const Sweep& sweep = swept.sweep;
  Json json{
      {"coefficient", row(sweep.over.coefficient).name},
      {"unit", *row(sweep.over.coefficient).unit == '\0' ? "1" : row(sweep.over.coefficient).unit},
      {"at", list_json(sweep.at, number)}};
  json["leads"] = leads_json(swept);
  json["designs"] = Json::array();
  for (std::size_t i = 0; i < swept.designs.size(); ++i) {
    json["designs"].push_back({{"routing", swept.designs[i].ranked.design.word},
                               {"name", text_or_null(swept.designs[i].name)},
                               {"place", sweep.places[i]},
                               {"objectives", curves_json(sweep.designs[i])}});
  }
  return json;
}

Json sweep_settings(const std::optional<CoefficientRange>& over) {
  return value_or_null(over, [](const CoefficientRange& range) {
    return Json{{"coefficient", row(range.coefficient).name},
                {"from", range.range.low},
                {"to", range.range.high}};
  });
}

}  // namespace reeve::reports
