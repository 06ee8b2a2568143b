#include "pages/diagnosis/diagnosis_values.hpp"

#include <fmt/format.h>

#include <array>

#include "causes/term.hpp"
#include "diagnosis/fit/evidence.hpp"
#include "pages/diagnosis/diagnosis_labels.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"
#include "reports/output/csv_field.hpp"

namespace reeve::pages {
namespace {

Json sentences(const std::string& text) {
  std::vector<DocumentLine> lines;
  add_lines(lines, text);
  std::erase_if(lines, [](const DocumentLine& line) { return line.text.empty(); });
  return list_json(lines, [](const DocumentLine& line) { return Json{{"text", line.text}}; });
}

Json named_values(const DiagnosisReport& report) {
  return list_json(report.result.causes, [&](const NamedCause& cause) {
    const Term* term = term_of(*cause.effect.cause);
    Json item{{"name", cause.name},
              {"meaning", capitalised(cause_meaning(cause))},
              {"detail", term == nullptr ? cause.detail : formula(*term, cause.effect.values)},
              {"p", p_text(cause.p_value, report.settings.replicates)}};
    if (cause.runner_up) {
      item["runner_up"] = {{"name", cause.runner_up->name},
                           {"delta", gain_number(cause.runner_up->delta_log_likelihood)},
                           {"as_well", cause.runner_up->delta_log_likelihood < 0.05}};
    }
    return item;
  });
}

Json limit_values(const DiagnosisResult& result) {
  const std::optional<NoiseLimit>& limit = result.noise_limit;
  if (!limit) return nullptr;
  const bool beyond = result.held_out && result.held_out->log_likelihood_gain > limit->high;
  return {{"gain", gain_number(limit->log_likelihood_gain)},
          {"interval", gain_interval(limit->low, limit->high)},
          {"rms", newton(limit->rms_N)},
          {"beyond", beyond}};
}

Json groups(const DiagnosisResult& result) {
  return list_json(result.indistinguishable, [](const std::vector<std::string>& names) {
    return Json{{"names", names}};
  });
}

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
  // In the order of NoiseSource.
  constexpr std::array texts{"from repeated readings", "from what no smooth law explains",
                             "from repeated readings and from what no smooth law explains",
                             "from the residuals", "as told"};
  return texts.at(static_cast<std::size_t>(source));
}

}  // namespace

Json answer_values(const DiagnosisReport& report) {
  const VerdictLabel label = verdict_label(report);
  const std::string answer = diagnosis_answer(report);
  const std::size_t end = answer.find('\n');
  return {{"verdict", verdict_name(report.result.verdict)},
          {"words", label.words},
          {"shape_" + label.shape, true},
          {"lead", answer.substr(0, end)},
          {"findings", findings_table(report)},
          {"sentences", sentences(answer.substr(end) + further_answer(report))}};
}

Json cause_values(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  return {{"named", named_values(report)},
          {"has_named", !result.causes.empty()},
          {"too_few", result.verdict == Verdict::too_few},
          {"sizes", sizes_table(result)},
          {"calibrated", calibration_table(result)},
          {"by_group", groups_table(report)},
          {"gains", gains_table(result)},
          {"weighed", weighed_table(result)},
          {"has_weighed", !result.weighed.empty()},
          {"limit", limit_values(result)},
          {"not_confirmed", fmt::format("{}", fmt::join(result.not_confirmed, ", "))},
          {"groups", groups(result)},
          {"has_groups", !result.indistinguishable.empty()},
          {"margin", fmt::format("{:.2g}", least_evidence)},
          {"has_held_out", result.held_out_runs > 0}};
}

Json structure_values(const DiagnosisReport& report, const MarkColumns& columns) {
  const DiagnosisResult& result = report.result;
  return {{"findings", structure_table(report)},
          {"missing", fmt::format("{}", fmt::join(columns.missing, ", "))},
          {"constant", fmt::format("{}", fmt::join(columns.constant, ", "))},
          {"not_drawn",
           columns.not_drawn == 0 ? "" : plural(columns.not_drawn, "further unknown column")},
          {"extended", !result.causes.empty()}};
}

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
          {"used", used_text(report)},
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
          {"generated_routings", report.with_generated},
          {"friction", friction_table(report.hardware)}};
}

}  // namespace reeve::pages
