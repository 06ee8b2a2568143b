#include "pages/diagnosis/diagnosis_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "reports/diagnosis/diagnosis_evidence.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::pages {
namespace {

using Causes = std::vector<std::string>;

Causes names_of(const std::vector<NamedCause>& causes) {
  Causes names;
  for (const NamedCause& cause : causes) names.push_back(cause.name);
  return names;
}

// The models in which one of a group's names stands in the place of the first.
bool is_equivalent(const DiagnosisResult& result, const Causes& model) {
  for (const Causes& group : result.indistinguishable) {
    for (std::size_t i = 1; i < group.size(); ++i) {
      Causes equivalent = names_of(result.causes);
      std::ranges::replace(equivalent, group.front(), group[i]);
      if (model == equivalent) return true;
    }
  }
  return false;
}

// Rows that do not read as the file says, or a sensor that is not like the others.
bool asks_for_a_look(const DiagnosisResult& result) {
  return std::ranges::any_of(result.notes, [](const DataNote& note) {
    return note.kind == NoteKind::other_direction || note.kind == NoteKind::shifted_rows ||
           note.kind == NoteKind::outlier_groups;
  });
}

bool is_refuted(const DiagnosisResult& result, const Causes& model) {
  const Causes& refuted = result.not_confirmed;
  return model.size() == 1 && std::ranges::find(refuted, model.front()) != refuted.end();
}

}  // namespace

std::string simulated_label(const DiagnosisReport& report) {
  return report.data.simulated ? "Simulated data. " : "";
}

VerdictLabel verdict_label(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  switch (result.verdict) {
    case Verdict::none:
      if (!beyond_belief_sentence(result).empty()) {
        return {"No cause is named, but the readings scatter beyond belief", "question"};
      }
      if (asks_for_a_look(result)) {
        return {"No cause is named, but some readings are to be looked at first", "question"};
      }
      return {weak_structure_remains(report) ? "No cause is named, and weak structure remains"
                                             : "Nothing is wrong that the readings could show",
              "check"};
    case Verdict::cause:
      return {result.causes.size() == 1 ? "One cause is named" : "Several causes are named",
              "found"};
    case Verdict::unexplained:
      return {"Something is wrong that no known cause explains", "question"};
    case Verdict::indistinguishable:
      return {"Ambiguous: several causes explain the data equally well", "alike"};
    case Verdict::too_few:
      return {"Too few readings to say anything", "open"};
  }
  return {};
}

std::string compared_alt(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  const std::string what =
      result.causes.empty()
          ? "Measured over predicted tensions of the nominal model. "
          : "Measured over predicted tensions, before and after the model is extended. ";
  if (!result.held_out) {
    return what + fmt::format("{} values.", result.cells.size());
  }
  return what + fmt::format("Residuals {}.", gain_text(*result.held_out, result.held_out_runs));
}

std::string standing(const DiagnosisResult& result, const std::vector<std::string>& model) {
  if (model == names_of(result.causes)) return "named";
  if (is_equivalent(result, model)) return "cannot be told from it";
  return is_refuted(result, model) ? "not confirmed" : "weighed";
}

std::vector<WeighedCauses> by_training_gain(std::vector<WeighedCauses> weighed) {
  std::ranges::stable_sort(weighed, std::ranges::greater{}, &WeighedCauses::gain);
  return weighed;
}

}  // namespace reeve::pages
