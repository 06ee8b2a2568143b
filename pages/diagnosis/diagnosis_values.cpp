#include "pages/diagnosis/diagnosis_values.hpp"

#include <fmt/format.h>

#include <sstream>

#include "diagnosis/search/rivals.hpp"
#include "pages/diagnosis/diagnosis_labels.hpp"
#include "pages/diagnosis/diagnosis_tables.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::pages {
namespace {

Json sentences(const std::string& text) {
  Json list = Json::array();
  std::istringstream in(text);
  in.exceptions(std::ios::badbit);  // no memory is no end of the text
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) list.push_back({{"text", line}, {"first", list.empty()}});
  }
  return list;
}

Json named_values(const DiagnosisReport& report) {
  Json list = Json::array();
  for (const NamedCause& cause : report.result.causes) {
    Json item{{"name", cause.name},
              {"meaning", capitalised(cause.meaning)},
              {"detail", cause.detail},
              {"p", p_text(cause.p_value, report.settings.replicates)}};
    if (cause.runner_up) {
      item["runner_up"] = {{"name", cause.runner_up->name},
                           {"delta", gain_number(cause.runner_up->delta_log_likelihood)},
                           {"as_well", cause.runner_up->delta_log_likelihood < 0.05}};
    }
    list.push_back(std::move(item));
  }
  return list;
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
  Json list = Json::array();
  for (const std::vector<std::string>& names : result.indistinguishable) {
    list.push_back({{"names", names}});
  }
  return list;
}

std::string joined(const std::vector<std::string>& parts) {
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

Json answer_values(const DiagnosisReport& report) {
  const VerdictLabel label = verdict_label(report);
  return {{"verdict", verdict_name(report.result.verdict)},
          {"words", label.words},
          {"shape_" + label.shape, true},
          {"sentences", sentences(diagnosis_answer(report))}};
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
          {"not_confirmed", joined(result.not_confirmed)},
          {"groups", groups(result)},
          {"has_groups", !result.indistinguishable.empty()},
          {"margin", fmt::format("{:.2g}", alias_margin)},
          {"chance", chance_text(result.p_value, report.settings.replicates)},
          {"has_held_out", result.held_out_runs > 0}};
}

Json structure_values(const DiagnosisReport& report, const MarkColumns& columns) {
  const DiagnosisResult& result = report.result;
  return {{"findings", structure_table(report)},
          {"missing", joined(columns.missing)},
          {"constant", joined(columns.constant)},
          {"not_drawn",
           columns.not_drawn == 0 ? "" : plural(columns.not_drawn, "further unknown column")},
          {"extended", !result.causes.empty()}};
}

}  // namespace reeve::pages
