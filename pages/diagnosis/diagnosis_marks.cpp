#include "pages/diagnosis/diagnosis_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "numerics/random.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::pages {
namespace {

constexpr std::size_t most_unknown_columns = 9;
constexpr std::uint32_t stream = 0x3a9;

using Value = std::function<std::optional<double>(const Reading&)>;

// Returns the columns that the file's format names, then the user's own.
std::vector<MarkColumn> known_columns() {
  return {
      {"residuals-load", "load: motor tension, N", nullptr,
       [](const Reading& r) { return r.motor_tension_N; }},
      {"residuals-speed", "speed, mm/s", nullptr, [](const Reading& r) { return r.speed_mm_s; }},
      {"residuals-cycle", "cycle", nullptr, [](const Reading& r) { return r.cycle; }},
      {"residuals-temperature", "temperature, °C", nullptr,
       [](const Reading& r) { return r.temperature_C; }},
      {"residuals-sheath-angle", "sheath angle, rad", nullptr,
       [](const Reading& r) { return r.sheath_angle_rad; }}};
}

std::vector<MarkColumn> unknown_columns(const DiagnosisReport& report) {
  std::vector<MarkColumn> columns;
  for (std::size_t k = 0; k < report.data.covariates.size(); ++k) {
    columns.push_back({fmt::format("residuals-column-{}", k + 1),
                       fmt::format("column “{}”", report.data.covariates[k]), nullptr,
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
  std::ranges::sort(order);
  order.resize(std::min(count, most));
  std::vector<std::size_t> result;
  for (const auto& [key, i] : order) result.push_back(i);
  std::ranges::sort(result);
  return result;
}

std::string grasp_text(Grasp grasp) {
  const std::vector<int> held = held_fingers(grasp);
  return held.empty() ? "none" : fmt::format("{}", fmt::join(held, ", "));
}

ReadingMark mark(const DiagnosisReport& report, const ComparedCell& compared, bool on_a_bench) {
  const Reading& reading = report.data.readings[compared.cell.reading];
  return {&reading,
          compared.cell.measured_N,
          compared.before_N,
          compared.after_N,
          compared.residual_before,
          compared.residual_after,
          compared.held_out,
          routing_name(report, reading.routing),
          report.data.channels[compared.cell.channel].name,
          on_a_bench ? "" : grasp_text(reading.grasp),
          report.data.runs[reading.run]};
}

// Into the list that it belongs to.
void sort_in(const MarkColumn& column, const std::set<double>& seen, MarkColumns& columns) {
  const std::string name = column.title.substr(0, column.title.find(','));
  if (seen.empty()) {
    columns.missing.push_back(name);
  } else if (seen.size() == 1) {
    columns.constant.push_back(fmt::format("{} ({:.6g})", column.title, *seen.begin()));
  } else {
    columns.shown.push_back(column);
  }
}

}  // namespace

MarkColumns mark_columns(const DiagnosisReport& report) {
  MarkColumns columns{{{"residuals-routing", "routing", &ReadingMark::routing, {}},
                       {"residuals-strand", "strand", &ReadingMark::strand, {}}},
                      {},
                      {},
                      0};
  if (!is_bench(report.data)) {
    columns.shown.push_back({"residuals-grasp", "grasp: held fingers", &ReadingMark::grasp, {}});
  }
  const std::vector<const Reading*> readings = compared_readings(report);
  for (const MarkColumn& column : known_columns()) {
    sort_in(column, values(readings, column.number), columns);
  }
  const std::size_t known = columns.shown.size();
  for (const MarkColumn& column : unknown_columns(report)) {
    const std::set<double> seen = values(readings, column.number);
    if (seen.size() > 1 && columns.shown.size() == known + most_unknown_columns) {
      ++columns.not_drawn;
    } else {
      sort_in(column, seen, columns);
    }
  }
  columns.shown.push_back({"residuals-order", "order: line of the file", nullptr,
                           [](const Reading& r) { return static_cast<double>(r.line); }});
  return columns;
}

std::vector<ReadingMark> marks(const DiagnosisReport& report, std::size_t most) {
  const bool on_a_bench = is_bench(report.data);
  std::vector<ReadingMark> list;
  for (const std::size_t i : chosen(report.result.cells.size(), most)) {
    list.push_back(mark(report, report.result.cells[i], on_a_bench));
  }
  return list;
}

}  // namespace reeve::pages
