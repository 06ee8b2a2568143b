#include "pages/diagnosis/diagnosis_labels.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The models in which one of a group's names stands in the place of the first.
bool is_alike(const DiagnosisResult& result, const std::string& model) {
  for (const std::vector<std::string>& group : result.indistinguishable) {
    std::string kept;
    for (const NamedCause& cause : result.causes) {
      if (cause.name != group.front()) kept += " + " + cause.name;
    }
    for (std::size_t i = 1; i < group.size(); ++i) {
      if (model == group[i] + kept) return true;
    }
  }
  return false;
}

}  // namespace

std::string simulated_label(const DiagnosisReport& report) {
  return report.data.simulated ? "Simulated data. " : "";
}

VerdictLabel verdict_label(const DiagnosisResult& result) {
  if (result.too_few_readings) return {"Too few readings to say anything", "open"};
  switch (result.verdict) {
    case Verdict::none:
      return {"Nothing is wrong that the readings could show", "check"};
    case Verdict::cause:
      return {result.causes.size() == 1 ? "One cause is named" : "Several causes are named",
              "found"};
    case Verdict::unexplained:
      return {"Something is wrong that no known cause explains", "question"};
    case Verdict::indistinguishable:
      return {"Several causes explain the data alike", "alike"};
  }
  return {};
}

std::string compared_alt(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  const std::string what =
      result.causes.empty()
          ? "Measured over predicted tensions of the model as it stands. "
          : "Measured over predicted tensions, before and after the model is extended. ";
  if (!result.held_out) {
    return what + fmt::format("{} values.", result.cells.size());
  }
  return what + fmt::format("Residuals {}.", gain_text(*result.held_out, result.held_out_runs));
}

std::string standing(const DiagnosisResult& result, const std::string& model) {
  std::string named;
  for (const NamedCause& cause : result.causes) {
    named += (named.empty() ? "" : " + ") + cause.name;
  }
  if (model == named) return "named";
  if (is_alike(result, model)) return "cannot be told from it";
  return contains(result.not_confirmed, model) ? "not confirmed" : "weighed";
}

std::vector<WeighedCause> by_training_gain(std::vector<WeighedCause> weighed) {
  std::stable_sort(weighed.begin(), weighed.end(),
                   [](const auto& a, const auto& b) { return a.gain > b.gain; });
  return weighed;
}

}  // namespace reeve
