#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "causes/term.hpp"
#include "diagnosis/fit/evidence.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis/diagnosis_evidence.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::reports {
namespace {

// "from 1.2 N to 0.3 N": root mean squares of the residuals that are meant.
template <typename IsMeant>
std::string fall_text(const DiagnosisReport& report, IsMeant is_meant) {
  double before = 0, after = 0, cells = 0;
  for (const ComparedCell& cell : report.result.cells) {
    if (!is_meant(cell)) continue;
    before += std::pow(cell.cell.measured_N - cell.before_N, 2);
    after += std::pow(cell.cell.measured_N - cell.after_N, 2);
    ++cells;
  }
  return fmt::format("from {} to {}", newton(std::sqrt(before / cells)),
                     newton(std::sqrt(after / cells)));
}

// Returns the gain on the readings that the causes were fitted to, if nothing was held out.
std::string fitted_gain_text(const DiagnosisReport& report) {
  return fmt::format(
      "Nothing was held out, so how much better the model forecasts is not known; on the readings "
      "that it was fitted to, residuals go {}.\n",
      fall_text(report, [](const ComparedCell&) { return true; }));
}

// Returns how residuals fall on the readings of a run that alone shows a cause. The model was
// fitted to these readings.
std::string only_run_lines(const DiagnosisReport& report) {
  std::string text;
  for (const NamedCause& cause : report.result.causes) {
    if (cause.only_run.empty()) continue;
    const std::string fall = fall_text(report, [&](const ComparedCell& cell) {
      return report.data.runs[report.data.readings[cell.cell.reading].run] == cause.only_run;
    });
    text += fmt::format(
        "Run {} alone shows {}, so a gain on runs that the model has not seen is not known; on run "
        "{} residuals go {}.\n",
        cause.only_run, cause.name, cause.only_run, fall);
  }
  return text;
}

// Causes that would gain nothing on the held-out runs even if they were right: none of these runs
// has the channel, the direction or the condition in which they show.
std::vector<std::string> untested_causes(const DiagnosisResult& result) {
  constexpr double nothing = 0.5;  // in log-likelihood: less than half a parameter brings by chance
  std::vector<std::string> names;
  for (const NamedCause& cause : result.causes) {
    if (cause.held_out && cause.held_out->expected_gain < nothing) names.push_back(cause.name);
  }
  return names;
}

std::string gain_line(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  const std::string of_one_run = only_run_lines(report);
  if (!result.held_out) return of_one_run.empty() ? fitted_gain_text(report) : of_one_run;
  const std::vector<std::string> untested = untested_causes(result);
  std::string gain =
      !untested.empty() && untested.size() == result.causes.size()
          ? ""
          : fmt::format("Residuals {}.\n", gain_text(*result.held_out, result.held_out_runs));
  if (untested.empty()) return gain + of_one_run;
  return gain + of_one_run +
         fmt::format(
             "Held-out runs say nothing of {}: with and without it, what they should read "
             "is the same.\n",
             fmt::join(untested, ", "));
}

std::string chance_sentence(const DiagnosisReport& report) {
  const bool significant = report.result.p_value <= report.settings.alpha;
  return fmt::format("The gain in likelihood is {}significant ({}).\n", significant ? "" : "not ",
                     p_text(report.result.p_value, report.settings.replicates));
}

std::string weak_structure_text(const DiagnosisReport& report) {
  const StructureFinding& strongest = report.result.structure.front();
  const double threshold = structure_share_of_alpha * report.settings.alpha;
  return fmt::format(
      "Weak structure remains by {}: {} ({}), {}", pattern_text(report, strongest.about),
      part_of_residuals(report, structure_N(report, strongest)),
      p_text(report.result.structure_p_value, report.settings.replicates),
      report.result.structure_p_value < threshold
          ? std::string("but the residuals hardly exceed the scatter of the readings")
          : fmt::format("which does not reach this test's threshold of {:g}", threshold));
}

std::string rest_text(const DiagnosisReport& report) {
  if (weak_structure_remains(report)) return weak_structure_text(report);
  return fmt::format("No further structure in the residuals ({})",
                     p_text(report.result.structure_p_value, report.settings.replicates));
}

bool cannot_be_told_apart(const DiagnosisResult& result, const std::string& name) {
  return std::ranges::any_of(result.indistinguishable,
                             [&](const auto& names) { return names.front() == name; });
}

std::string explains_text(const DiagnosisReport& report, const NamedCause& cause) {
  if (!(report.result.residual_before_N > 0)) return "";
  const double part_N = cause.explained.rms_N;
  return fmt::format(" It explains {} rms of {} ({} of the mean square{}).",
                     newton(std::max(0.0, part_N)), newton(report.result.residual_before_N),
                     fine_percent_text(std::max(0.0, cause.explained.share)),
                     is_negligible(report, part_N) ? ", negligible" : "");
}

// One line for each cause that stands alone, what explains most first; the table has all.
std::string cause_lines(const DiagnosisReport& report) {
  constexpr std::size_t most_lines = 3;
  const DiagnosisResult& result = report.result;
  std::string text;
  std::size_t lines = 0;
  for (const NamedCause& cause : result.causes) {
    if (cannot_be_told_apart(result, cause.name) || ++lines > most_lines) continue;
    text += capitalised((text.empty() ? "" : "besides, ") + cause_sentence(cause)) + "." +
            explains_text(report, cause) + "\n";
  }
  if (lines <= most_lines) return text;
  return text + fmt::format("{} less: see the table.\n",
                            plural(lines - most_lines, "further cause") +
                                (lines - most_lines == 1 ? " explains" : " explain"));
}

std::string indistinguishable_lines(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  std::string text;
  for (const std::vector<std::string>& names : result.indistinguishable) {
    text += fmt::format("Ambiguous: {} explains the data.\n", enumerated(names, " or "));
    for (const NamedCause& cause : result.causes) {
      if (cause.name != names.front()) continue;
      text += fmt::format("If it is the first: {}.{}\n", cause_sentence(cause),
                          explains_text(report, cause));
    }
  }
  return text;
}

std::string separation_line(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  if (!result.separating_measurement) {
    std::vector<std::string> others = result.indistinguishable.front();
    const std::string first = others.front();
    others.erase(others.begin());
    return fmt::format("None of the candidate measurements separates {} from {}.\n", first,
                       enumerated(others, " or "));
  }
  const std::vector<std::string>& between = result.separating_measurement->between;
  return fmt::format("To tell {} from {}, measure {}.\n", between[0], between[1],
                     measurement_text(*result.separating_measurement, report));
}

std::string too_few_answer() {
  return "Whether anything is wrong cannot be said: the readings are too few.\n"
         "No cause was looked for.\n"
         "The notes below say how many it takes.\n";
}

std::string leads_line(const DiagnosisReport& report) {
  const std::string sentence = leads_sentence(report);
  return sentence.empty() ? "" : sentence + "\n";
}

bool some_are_far(const DiagnosisResult& result) {
  return std::ranges::any_of(
      result.notes, [](const DataNote& note) { return note.kind == NoteKind::outlier_forecast; });
}

std::string none_answer(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  const bool is_believed = beyond_belief_sentence(result).empty();
  std::string text = fmt::format(
      "The nominal model explains {} {}.\n", some_are_far(result) ? "the other runs" : "the data",
      drowns_in_noise(result)          ? "only if readings scatter by more than can be believed"
      : !is_believed                   ? "only if mountings differ by more than can be believed"
      : weak_structure_remains(report) ? "but for weak structure"
                                       : "as well as their noise allows");
  if (some_are_far(result))
    text += "It is far from some readings of held-out runs: see the notes.\n";
  const std::vector<std::string> dropped = not_named_sentences(result);
  if (!dropped.empty()) {
    for (const std::string& sentence : dropped) text += sentence + "\n";
  } else {
    text += fmt::format("No cause is named: none raises the evidence by {:g}.\n", least_evidence);
  }
  return text + rest_text(report) + ".\n" + leads_line(report);
}

std::string apart_lines(const DiagnosisReport& report) {
  std::string text;
  for (const std::string& sentence : without_apart_sentences(report)) text += sentence + "\n";
  return text;
}

std::string cause_answer(const DiagnosisReport& report) {
  return cause_lines(report) + gain_line(report) + rest_text(report) +
         (weak_structure_remains(report) ? ".\n" : ". ") + chance_sentence(report) +
         leads_line(report) + apart_lines(report);
}

std::string indistinguishable_answer(const DiagnosisReport& report) {
  const std::string weak =
      weak_structure_remains(report) ? weak_structure_text(report) + ".\n" : std::string();
  return cause_lines(report) + indistinguishable_lines(report) + gain_line(report) + weak +
         separation_line(report) + leads_line(report) + apart_lines(report);
}

std::string rows_line(const DiagnosisResult& result) {
  return result.row_scatter ? row_sentence(result) + "\n" : "";
}

std::string size_of(const DiagnosisReport& report, const Unexplained& left) {
  if (left.about == "run" && !report.result.apart.empty()) {
    const Effect& effect = report.result.apart.front().effect;
    return causes::formula(*causes::term_of(*effect.cause), effect.values) + "; ";
  }
  for (const StructureFinding& finding : report.result.structure) {
    if (finding.about != left.about || !(structure_N(report, finding) > 0)) continue;
    return part_of_residuals(report, structure_N(report, finding)) + "; ";
  }
  return "";
}

std::string unexplained_answer(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  const Unexplained& left = *result.unexplained;
  std::string text = fmt::format(
      "The residuals follow something that no cause in the library explains: {}{} ({}{}).\n",
      pattern_text(report, left.about), left.where.empty() ? "" : ", most of all " + left.where,
      size_of(report, left), p_text(left.p_value, report.settings.replicates));
  text += leads_line(report);
  if (result.causes.empty()) {
    text += "No cause is named.\nThe nominal model is kept.\n";
    return text + rows_line(result);
  }
  text += rows_line(result);
  text += "Part of it is explained, so take the sizes with care:\n";
  return text + cause_lines(report) + indistinguishable_lines(report) + gain_line(report) +
         apart_lines(report);
}

std::string answer(const DiagnosisReport& report) {
  switch (report.result.verdict) {
    case Verdict::none:
      return none_answer(report);
    case Verdict::cause:
      return cause_answer(report);
    case Verdict::unexplained:
      return unexplained_answer(report);
    case Verdict::indistinguishable:
      return indistinguishable_answer(report);
    case Verdict::too_few:
      return too_few_answer();
  }
  return "";
}

// In another unit, or moved the other way, nothing else that is said would hold.
std::string check_first(const std::vector<DataNote>& notes, NoteKind kind, const char* what) {
  const auto first = std::ranges::find(notes, kind, &DataNote::kind);
  if (first == notes.end()) return "";
  const auto more = static_cast<std::size_t>(std::ranges::count(notes, kind, &DataNote::kind)) - 1;
  const std::string rest =
      more == 0 ? "" : fmt::format(" {} below.", plural(more, "more note") + " of the kind");
  return fmt::format("Check {} first: {}{}\n", what, first->text, rest);
}

std::string whole_answer(const DiagnosisReport& report) {
  std::string text = answer(report);
  for (const std::string& sentence : group_sentences(report)) {
    text += sentence + ".\n";
  }
  const std::vector<DataNote>& notes = report.result.notes;
  const std::string mountings = beyond_belief_sentence(report.result);
  return text.insert(text.find('\n') + 1,
                     check_first(notes, NoteKind::units, "the units") +
                         check_first(notes, NoteKind::inverted, "this") +
                         check_first(notes, NoteKind::not_as_pulled, "this") +
                         check_first(notes, NoteKind::other_direction, "this") +
                         check_first(notes, NoteKind::shifted_rows, "this") +
                         check_first(notes, NoteKind::outlier_groups, "this") +
                         (mountings.empty() ? "" : mountings + "\n"));
}

// Returns the position behind the first six lines.
std::size_t end_of_answer(const std::string& text) {
  constexpr int most_lines = 6;
  std::size_t end = 0;
  for (int line = 0; line < most_lines; ++line) {
    const std::size_t at = text.find('\n', end);
    if (at == std::string::npos) return text.size();
    end = at + 1;
  }
  return end;
}

}  // namespace

std::string diagnosis_answer(const DiagnosisReport& report) {
  const std::string text = whole_answer(report);
  return text.substr(0, end_of_answer(text));
}

std::string further_answer(const DiagnosisReport& report) {
  const std::string text = whole_answer(report);
  return text.substr(end_of_answer(text));
}

}  // namespace reeve::reports
