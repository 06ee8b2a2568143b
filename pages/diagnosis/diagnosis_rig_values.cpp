// Of the page's values those about the rig: what to measure next, the data, the settings.
#include <fmt/format.h>

#include "core/notation.hpp"
#include "pages/diagnosis/diagnosis_tables.hpp"
#include "pages/diagnosis/diagnosis_values.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"
#include "reports/output/csv_field.hpp"

namespace reeve::pages {
namespace {

// Header and one row, the measured cells empty.
std::string rows_to_record(const PlannedMeasurement& planned) {
  const Measurement& at = planned.measurement;
  std::string header = "run,routing,held,direction,motor_tension_N";
  std::string row =
      fmt::format("NEW,{},{},{},{}", csv_field(at.routing.word), held_field(at.grasp),
                  direction_field(at.direction), set_value(at.conditions.motor_tension_N));
  const auto add = [&](bool used, const char* column, double value) {
    if (!used) return;
    header += fmt::format(",{}", column);
    row += "," + set_value(value);
  };
  add(at.uses_speed, "speed_mm_s", at.conditions.speed_mm_s);
  add(at.uses_cycle, "cycle", at.conditions.cycle);
  add(at.uses_temperature, "temperature_C", at.conditions.temperature_C);
  for (const ExpectedReading& reading : planned.expected) {
    header += fmt::format(
        ",T{}_N", reading.segment.starts_with('T') ? reading.segment.substr(1) : reading.segment);
    row += ',';
  }
  return header + "\n" + row + "\n";
}

const char* source_text(NoiseSource source) {
  switch (source) {
    case NoiseSource::repeats:
      return "from repeated readings";
    case NoiseSource::smoothing:
      return "from what no smooth law explains";
    case NoiseSource::repeats_and_smoothing:
      return "from repeated readings and from what no smooth law explains";
    case NoiseSource::known:
      return "as told";
    case NoiseSource::residuals:
      return "from what the model leaves";
  }
  return "";
}

}  // namespace

Json next_values(const DiagnosisReport& report) {
  const std::optional<PlannedMeasurement>& next = report.result.next_measurement;
  if (!next) return nullptr;
  return {{"measurement", measurement_text(*next, report)},
          {"why", next->why},
          {"readings", planned_readings},
          {"expected", expected_table(report.result)},
          {"rows", rows_to_record(*next)}};
}

Json data_values(const DiagnosisPageInput& input) {
  const DiagnosisReport& report = input.report;
  const DiagnosisResult& result = report.result;
  const Noise& noise = result.noise;
  const DiagnosisSettings& settings = report.settings;
  return {{"file", report.data.file},
          {"simulated", report.data.simulated},
          {"rows", plural(result.rows, "reading")},
          {"runs", plural(result.runs, "run")},
          {"held_out", result.held_out_runs},
          {"duplicates", result.dropped_duplicates},
          {"thinned", result.thinned_rows},
          {"noise", fmt::format("{} of the reading and {}", fine_percent_text(noise.relative),
                                newton(noise.absolute_N))},
          {"noise_source", source_text(noise.source)},
          {"noise_degrees", fmt::format("{:.0f}", noise.degrees_of_freedom)},
          {"notes", notes_table(result)},
          {"command", input.command},
          {"alpha", fmt::format("{:g}", settings.alpha)},
          {"hold_out", percent_text(settings.hold_out)},
          {"seed", settings.seed},
          {"replicates", settings.replicates},
          {"explore", report.with_generated},
          {"friction", friction_table(report.hardware)}};
}

}  // namespace reeve::pages
