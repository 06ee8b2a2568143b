#include "pages/diagnosis_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include "numerics/random.hpp"

namespace reeve {
namespace {

constexpr std::size_t most_unknown_columns = 9;
constexpr std::uint32_t stream = 0x3a9;

using Value = std::function<std::optional<double>(const Reading&)>;

struct NumberColumn {
  MarkColumn column;
  Value value;
};

std::vector<NumberColumn> number_columns(const DiagnosisReport& report) {
  std::vector<NumberColumn> columns{
      {{"load", "residuals-load", "load: motor tension, N"},
       [](const Reading& r) { return r.motor_tension_N; }},
      {{"speed", "residuals-speed", "speed, mm/s"}, [](const Reading& r) { return r.speed_mm_s; }},
      {{"cycle", "residuals-cycle", "cycle"}, [](const Reading& r) { return r.cycle; }},
      {{"temperature", "residuals-temperature", "temperature, °C"},
       [](const Reading& r) { return r.temperature_C; }},
      {{"sheath_angle", "residuals-sheath-angle", "sheath angle, rad"},
       [](const Reading& r) { return r.sheath_angle_rad; }}};
  for (std::size_t k = 0; k < report.data.covariates.size(); ++k) {
    columns.push_back({{fmt::format("c{}", k), fmt::format("residuals-column-{}", k + 1),
                        fmt::format("column “{}”", report.data.covariates[k])},
                       [k](const Reading& r) { return r.covariates[k]; }});
  }
  return columns;
}

// Readings that were compared, once each.
std::vector<const Reading*> compared_readings(const DiagnosisReport& report) {
  std::vector<const Reading*> readings;
  for (const ComparedCell& cell : report.result.cells) {
    const Reading* reading = &report.data.readings[cell.cell.reading];
    if (readings.empty() || readings.back() != reading) readings.push_back(reading);
  }
  return readings;
}

// Up to two: enough to tell none from one from several.
std::set<double> values(const std::vector<const Reading*>& readings, const Value& value) {
  std::set<double> seen;
  for (const Reading* reading : readings) {
    if (const auto given = value(*reading)) seen.insert(*given);
    if (seen.size() > 1) break;
  }
  return seen;
}

// The same for the same number, whatever the readings: strides would meet every n-th strand only.
std::vector<std::size_t> chosen(std::size_t count, std::size_t most) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < count; ++i) {
    order.emplace_back(count > most ? uniform(1, stream, i) : 0, i);
  }
  std::sort(order.begin(), order.end());
  order.resize(std::min(count, most));
  std::vector<std::size_t> result;
  for (const auto& [key, i] : order) result.push_back(i);
  std::sort(result.begin(), result.end());
  return result;
}

std::string grasp_text(Grasp grasp) {
  const std::vector<int> held = held_fingers(grasp);
  return held.empty() ? "none" : fmt::format("{}", fmt::join(held, ", "));
}

Json mark(const DiagnosisReport& report, const ComparedCell& compared) {
  const Reading& reading = report.data.readings[compared.cell.reading];
  return {{"measured", compared.cell.measured_N},
          {"before", number(compared.before_N)},
          {"after", number(compared.after_N)},
          {"residual_before", number(compared.residual_before)},
          {"residual_after", number(compared.residual_after)},
          {"held_out", compared.held_out ? "held out" : "training"},
          {"routing", routing_label(report, report.data.routings[reading.routing].word)},
          {"strand", report.data.channels[compared.cell.channel].name},
          {"grasp", grasp_text(reading.grasp)},
          {"direction", reading.direction == Direction::pull ? "pull" : "release"},
          {"run", report.data.runs[reading.run]},
          {"line", reading.line},
          {"load", reading.motor_tension_N ? Json(*reading.motor_tension_N) : Json()}};
}

}  // namespace

MarkColumns mark_columns(const DiagnosisReport& report) {
  MarkColumns columns{{{"routing", "residuals-routing", "routing", true},
                       {"strand", "residuals-strand", "strand", true},
                       {"grasp", "residuals-grasp", "grasp: held fingers", true}},
                      {},
                      {},
                      0};
  const std::vector<const Reading*> readings = compared_readings(report);
  std::size_t unknown = 0;
  for (const auto& [column, value] : number_columns(report)) {
    const std::set<double> seen = values(readings, value);
    const std::string name = column.title.substr(0, column.title.find(','));
    if (seen.empty()) {
      columns.missing.push_back(name);
    } else if (seen.size() == 1) {
      columns.constant.push_back(fmt::format("{} ({:.6g})", column.title, *seen.begin()));
    } else if (column.field.starts_with('c') && column.field != "cycle" &&
               ++unknown > most_unknown_columns) {
      ++columns.not_drawn;
    } else {
      columns.shown.push_back(column);
    }
  }
  columns.shown.push_back({"line", "residuals-order", "order: line of the file"});
  return columns;
}

Json marks(const DiagnosisReport& report, const std::vector<MarkColumn>& columns,
           std::size_t most) {
  const std::vector<ComparedCell>& cells = report.result.cells;
  Json list = Json::array();
  for (const std::size_t i : chosen(cells.size(), most)) {
    Json datum = mark(report, cells[i]);
    const Reading& reading = report.data.readings[cells[i].cell.reading];
    for (const NumberColumn& known : number_columns(report)) {
      const bool shown = std::any_of(columns.begin(), columns.end(), [&](const MarkColumn& other) {
        return other.field == known.column.field;
      });
      const std::optional<double> given = known.value(reading);
      if (shown) datum[known.column.field] = given ? number(*given) : Json();
    }
    list.push_back(std::move(datum));
  }
  return list;
}

Json fields_of(const Json& marks, const std::vector<std::string>& fields) {
  Json list = Json::array();
  for (const Json& mark : marks) {
    Json datum = Json::object();
    for (const std::string& field : fields) datum[field] = mark[field];
    list.push_back(std::move(datum));
  }
  return list;
}

std::string routing_label(const DiagnosisReport& report, const std::string& word) {
  const auto named = report.names.find(word);
  return named == report.names.end() || named->second.empty() ? word : named->second;
}

}  // namespace reeve
