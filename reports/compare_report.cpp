#include "reports/compare_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "readings/csv.hpp"
#include "reports/assumed_words.hpp"
#include "reports/data_text.hpp"
#include "reports/model_text.hpp"
#include "reports/output/csv_field.hpp"
#include "reports/output/json.hpp"
#include "reports/output/stamp.hpp"

namespace reeve::reports {
namespace {

struct Grouping {
  const char* name;
  std::vector<ResidualSummary> QuantitySummary::*summaries;
};
constexpr Grouping groupings[] = {
    {"routing", &QuantitySummary::by_routing}, {"channel", &QuantitySummary::by_channel},
    {"grasp", &QuantitySummary::by_grasp},     {"direction", &QuantitySummary::by_direction},
    {"run", &QuantitySummary::by_run},         {"group", &QuantitySummary::by_group},
};

// Residuals of shares cancel but for rounding.
std::string figure(double value) {
  if (!std::isfinite(value)) return "-";
  return fmt::format("{:.4g}", std::abs(value) < 1e-12 ? 0.0 : value);
}

void add_row(Table& table, const std::string& by, const ResidualSummary& summary) {
  table.add({by, for_message(summary.group), std::to_string(summary.count),
             figure(summary.mean_measured), figure(summary.mean_residual), figure(summary.rms),
             percent(summary.relative_rms)});
}

// The first groups of a kind; the JSON has all.
Section summary_section(const QuantitySummary& summary, const std::string& title,
                        const std::string& unit) {
  constexpr std::size_t most = 20;
  if (summary.all.count == 0) return {};
  Table table{{text_column("by"), text_column("group"), number_column("values", "", 2),
               number_column("mean measured", unit, 1), number_column("mean residual", unit),
               number_column("rms", unit), number_column("rms/mean")},
              {}};
  add_row(table, "all", summary.all);
  for (const Grouping& grouping : groupings) {
    const std::vector<ResidualSummary>& groups = summary.*grouping.summaries;
    for (std::size_t i = 0; i < groups.size() && i < most; ++i) {
      add_row(table, grouping.name, groups[i]);
    }
    if (groups.size() > most) {
      table.add(
          {grouping.name, fmt::format("… {} more", groups.size() - most), "", "", "", "", ""});
    }
  }
  return {title, table, {}};
}

Json residuals_json(const ResidualSummary& summary) {
  return {{"group", summary.group},
          {"count", summary.count},
          {"mean_measured", number(summary.mean_measured)},
          {"mean_residual", number(summary.mean_residual)},
          {"rms", number(summary.rms)},
          {"relative_rms", number(summary.relative_rms)}};
}

Json quantity_json(const QuantitySummary& summary) {
  if (summary.all.count == 0) return nullptr;
  Json json{{"all", residuals_json(summary.all)}};
  for (const Grouping& grouping : groupings) {
    json[std::string("by_") + grouping.name] =
        list_json(summary.*grouping.summaries, residuals_json);
  }
  return json;
}

Json data_json(const CompareReport& report) {
  const MeasuredData& data = report.data;
  Json json{{"file", data.file},
            {"simulated", data.simulated},
            {"readings", data.readings.size()},
            {"runs", data.runs.size()}};
  json["routings"] = Json::array();
  for (std::size_t i = 0; i < data.routings.size(); ++i) {
    const std::string& name = report.names[i];
    json["routings"].push_back({{"routing", data.routings[i].word}, {"name", text_or_null(name)}});
  }
  json["channels"] = list_json(data.channels, [](const Channel& channel) { return channel.name; });
  json["covariates"] = data.covariates;
  return json;
}

// On the data, then on the comparison.
std::vector<DataNote> all_notes(const CompareReport& report) {
  std::vector<DataNote> notes = report.data.notes;
  append(notes, report.comparison.notes);
  return notes;
}

}  // namespace

Document compare_sheet(const CompareReport& report) {
  const MeasuredData& data = report.data;
  Section opening;
  opening.lines.push_back(
      {fmt::format("{}: {} in {}", data.file, plural(data.readings.size(), "reading"),
                   plural(data.runs.size(), "run"))});
  if (data.simulated) opening.lines.push_back(simulated_line());
  opening.lines.push_back({"Nothing is fitted. " + assumed_text(report.model)});
  Document document{{opening}};
  document.add(
      summary_section(report.comparison.tension, "Tensions in N, measured - predicted", "N"));
  document.add(summary_section(
      report.comparison.share,
      "Shares of the measured strands, measured - predicted (no motor tension)", ""));
  document.add(notes_section(all_notes(report)));
  return document;
}

std::string compare_json(const CompareReport& report) {
  Json json{{"data", data_json(report)},
            {"fitted", false},
            {"tension", quantity_json(report.comparison.tension)},
            {"share", quantity_json(report.comparison.share)}};
  json["notes"] = notes_json(all_notes(report));
  json["settings"] = {{"hardware", to_json(report.model.hardware)},
                      {"model", model_json(report.model, 0)}};
  json["version"] = version_json();
  return print_stamped(std::move(json));
}

std::string residuals_csv(const CompareReport& report) {
  const MeasuredData& data = report.data;
  std::string csv = data.simulated ? fmt::format("# {}\n", simulated_text) : "";
  csv += "line,run,routing,held,direction,channel,quantity,measured,predicted,residual";
  csv += group_heading(data) + "\n";
  for (const ComparedValue& value : report.comparison.values) {
    const Reading& reading = data.readings[value.reading];
    csv +=
        fmt::format("{},{},{},{},{},{},{},{},{},{}{}\n", reading.line,
                    csv_field(data.runs[reading.run]), data.routings[reading.routing].word,
                    held_field(reading.grasp), direction_field(reading.direction),
                    data.channels[value.channel].name, quantity_name(value.quantity),
                    value.measured, value.predicted, value.residual(), group_field(data, reading));
  }
  return csv;
}

}  // namespace reeve::reports
