#include "pages/diagnosis/diagnosis_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "diagnosis/search/rivals.hpp"
#include "pages/diagnosis/diagnosis_labels.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"
#include "reports/results/data_text.hpp"

namespace reeve::pages {
namespace {

Json sentences(const std::string& text) {
  Json list = Json::array();
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) list.push_back({{"text", line}, {"first", list.empty()}});
  }
  return list;
}

// A log-likelihood: below a hundred to a tenth, which is where it decides anything.
std::string gain_number(double gain) {
  return fmt::format("{:.{}f}", gain, std::abs(gain) < 99.95 ? 1 : 0);
}

std::string gain_interval(double low, double high) {
  return gain_number(low) + " to " + gain_number(high);
}

Json parameter_values(const NamedCause& cause, const EstimatedParameter& parameter) {
  const auto written = [&](double value) { return estimate(parameter, value); };
  return {{"cause", cause.name},
          {"parameter", parameter.name},
          {"value", written(parameter.value)},
          {"interval", written(parameter.low) + " to " + written(parameter.high)},
          {"unit", parameter.unit},
          {"nominal", parameter.nominal ? written(*parameter.nominal) : "–"},
          {"literature", parameter.literature
                             ? fmt::format("{:.4g} to {:.4g}", parameter.literature->low,
                                           parameter.literature->high)
                             : "–"}};
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
                           {"delta", fmt::format("{:.1f}", cause.runner_up->delta_log_likelihood)},
                           {"as_well", cause.runner_up->delta_log_likelihood < 0.05}};
    }
    list.push_back(std::move(item));
  }
  return list;
}

Json parameters(const DiagnosisResult& result) {
  Json list = Json::array();
  for (const NamedCause& cause : result.causes) {
    for (const EstimatedParameter& parameter : cause.parameters) {
      list.push_back(parameter_values(cause, parameter));
    }
  }
  return list;
}

Json gain_values(const std::string& name, const HeldOut& held_out) {
  return {{"name", name},
          {"before", newton(held_out.rms_before_N)},
          {"after", newton(held_out.rms_after_N)},
          {"reduction", percent_text(held_out.reduction)},
          {"reduction_interval", percent_text(held_out.low) + " to " + percent_text(held_out.high)},
          {"gain", gain_number(held_out.log_likelihood_gain)},
          {"gain_interval", gain_interval(held_out.gain_low, held_out.gain_high)},
          {"expected", gain_number(held_out.expected_gain)}};
}

Json gains(const DiagnosisResult& result) {
  Json list = Json::array();
  for (const NamedCause& cause : result.causes) {
    if (cause.held_out) list.push_back(gain_values(cause.name, *cause.held_out));
  }
  if (result.held_out && result.causes.size() > 1) {
    list.push_back(gain_values("all together", *result.held_out));
  }
  return list;
}

Json weighed(const DiagnosisResult& result) {
  Json list = Json::array();
  for (const WeighedCauses& cause : by_training_gain(result.weighed)) {
    const std::string place = standing(result, cause.causes);
    Json item{{"name", joined_causes(cause.causes)},
              {"standing", place},
              {"is_named", place == "named"},
              {"training", gain_number(cause.gain)},
              {"held_out", "–"},
              {"interval", "–"},
              {"rms", "–"}};
    if (cause.held_out) {
      item["held_out"] = gain_number(cause.held_out->log_likelihood_gain);
      item["interval"] = gain_interval(cause.held_out->gain_low, cause.held_out->gain_high);
      item["rms"] = newton(cause.held_out->rms_after_N);
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
  const VerdictLabel label = verdict_label(report.result);
  return {{"verdict", name(report.result.verdict)},
          {"words", label.words},
          {"shape_" + label.shape, true},
          {"sentences", sentences(diagnosis_answer(report))}};
}

Json cause_values(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  return {{"named", named_values(report)},
          {"has_named", !result.causes.empty()},
          {"too_few", result.verdict == Verdict::too_few},
          {"parameters", parameters(result)},
          {"has_parameters", !parameters(result).empty()},
          {"gains", gains(result)},
          {"has_gains", !gains(result).empty()},
          {"weighed", weighed(result)},
          {"has_weighed", !result.weighed.empty()},
          {"limit", limit_values(result)},
          {"not_confirmed", joined(result.not_confirmed)},
          {"groups", groups(result)},
          {"has_groups", !result.indistinguishable.empty()},
          {"margin", fmt::format("{:.2g}", alias_margin)},
          {"chance", chance_text(result.p_value, report.settings.replicates)},
          {"held_out_runs", plural(result.held_out_runs, "run")},
          {"has_held_out", result.held_out_runs > 0}};
}

Json structure_values(const DiagnosisReport& report, const MarkColumns& columns) {
  const DiagnosisResult& result = report.result;
  Json findings = Json::array();
  for (const StructureFinding& finding : result.structure) {
    findings.push_back({{"about", finding.about},
                        {"statistic", fmt::format("{:.1f}", finding.statistic)},
                        {"p", fmt::format("{:.2g}", finding.p_value)}});
  }
  return {{"findings", findings},
          {"has_findings", !findings.empty()},
          {"p", p_text(result.structure_p_value, report.settings.replicates)},
          {"missing", joined(columns.missing)},
          {"constant", joined(columns.constant)},
          {"not_drawn",
           columns.not_drawn == 0 ? "" : plural(columns.not_drawn, "further unknown column")},
          {"extended", !result.causes.empty()}};
}

}  // namespace reeve::pages
