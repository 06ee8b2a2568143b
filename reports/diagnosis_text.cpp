#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/rivals.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis_report.hpp"
#include "reports/diagnosis_words.hpp"
#include "reports/text_table.hpp"

namespace reeve {
namespace {

// Of lists that can be long; the JSON has all.
constexpr std::size_t most_rows = 8;

std::string data_text(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  std::string text =
      fmt::format("\nData\n{}: {} in {}, {} of them held out; {} dropped\n", report.data.file,
                  plural(result.rows, "reading"), plural(result.runs, "run"), result.held_out_runs,
                  plural(result.dropped_duplicates, "repeated reading"));
  if (report.data.simulated) text += fmt::format("The data are {}.\n", simulated_text);
  const Noise& noise = result.noise;
  const char* source = noise.source == NoiseSource::repeats     ? "repeated readings"
                       : noise.source == NoiseSource::smoothing ? "what no smooth law explains"
                       : noise.source == NoiseSource::repeats_and_smoothing
                           ? "repeated readings and what no smooth law explains"
                           : "what the model leaves";
  return text +
         fmt::format("Noise: {:.2g} % of the reading and {}, by {} ({:.0f} degrees of freedom)\n",
                     100 * noise.relative, newton(noise.absolute_N), source,
                     noise.degrees_of_freedom);
}

std::string range_text(const std::optional<Range>& range) {
  return range ? fmt::format("{:.4g} to {:.4g}", range->low, range->high) : "-";
}

std::string causes_text(const DiagnosisReport& report) {
  const std::vector<NamedCause>& causes = report.result.causes;
  if (causes.empty()) return "";
  TextTable table({"<cause", "<parameter", "value", "95 % interval", "nominal", "literature",
                   "<unit", "p", "<runner-up (log-likelihood less)"});
  for (const NamedCause& cause : causes) {
    const std::string p = fmt::format("{:.2g}", cause.p_value);
    const std::string other = cause.runner_up ? fmt::format("{} ({:.1f})", cause.runner_up->name,
                                                            cause.runner_up->delta_log_likelihood)
                                              : "-";
    if (cause.parameters.empty()) {
      table.add({cause.name, cause.detail.empty() ? "-" : cause.detail, "-", "-", "-", "-", "-", p,
                 other});
    }
    for (const EstimatedParameter& parameter : cause.parameters) {
      const bool first = &parameter == &cause.parameters.front();
      table.add({first ? cause.name : "", parameter.name, estimate(parameter, parameter.value),
                 fmt::format("{} to {}", estimate(parameter, parameter.low),
                             estimate(parameter, parameter.high)),
                 parameter.nominal ? estimate(parameter, *parameter.nominal) : "-",
                 range_text(parameter.literature), parameter.unit, first ? p : "",
                 first ? other : ""});
    }
  }
  return "\nCauses, each accepted against chance over the whole search\n" + table.text();
}

void add_gain(TextTable& table, const std::string& name, const HeldOut& held_out) {
  table.add({name, newton(held_out.rms_before_N), newton(held_out.rms_after_N),
             percent_text(held_out.reduction),
             fmt::format("{} to {}", percent_text(held_out.low), percent_text(held_out.high)),
             fmt::format("{:.3g}", held_out.log_likelihood_gain),
             fmt::format("{:.3g} to {:.3g}", held_out.gain_low, held_out.gain_high),
             fmt::format("{:.3g}", held_out.expected_gain)});
}

std::string gains_text(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  if (!result.held_out) return "";
  TextTable table({"<with", "rms before", "rms after", "reduction", "95 % interval",
                   "log-likelihood gain", "95 % interval", "expected gain"});
  for (const NamedCause& cause : result.causes) {
    if (cause.held_out) add_gain(table, cause.name, *cause.held_out);
  }
  if (result.causes.size() > 1) add_gain(table, "all together", *result.held_out);
  return fmt::format("\nGain on {} that the fit has not seen, each cause over all others\n{}",
                     plural(result.held_out_runs, "run"), table.text());
}

std::string weighed_text(const DiagnosisReport& report) {
  const std::vector<WeighedCause>& weighed = report.result.weighed;
  if (weighed.empty()) return "";
  TextTable table({"<model", "training runs", "held-out runs", "rms held out"});
  for (std::size_t i = 0; i < weighed.size() && i < most_rows; ++i) {
    const std::optional<HeldOut>& held_out = weighed[i].held_out;
    table.add({weighed[i].name, fmt::format("{:.1f}", weighed[i].gain),
               held_out ? fmt::format("{:.1f}", held_out->log_likelihood_gain) : "-",
               held_out ? newton(held_out->rms_after_N) : "-"});
  }
  std::string text = "\nWeighed: gain in log-likelihood over the model as it stands\n";
  text += table.text();
  if (weighed.size() > most_rows) text += fmt::format("… {} more\n", weighed.size() - most_rows);
  for (const std::string& name : report.result.not_confirmed) {
    text += fmt::format("{} failed on the held-out runs, and is not named.\n", name);
  }
  return text;
}

std::string indistinguishable_text(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  if (result.indistinguishable.empty()) return "";
  std::string text = fmt::format(
      "\nCannot be told apart (less than {:.2g} in log-likelihood between them)\n", alias_margin);
  for (const std::vector<std::string>& names : result.indistinguishable) {
    text += fmt::format("- {}\n", fmt::join(names, ", "));
  }
  return text;
}

std::string left_text(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  if (result.structure.empty()) return "";
  constexpr std::size_t most = 3;
  TextTable table({"<residuals follow", "deviations from chance", "p of this alone"});
  for (std::size_t i = 0; i < result.structure.size() && i < most; ++i) {
    const StructureFinding& finding = result.structure[i];
    table.add({finding.about, fixed(finding.statistic, 1), fmt::format("{:.2g}", finding.p_value)});
  }
  return fmt::format("\nWhat is left, the strongest of {} ({} for all together)\n{}",
                     plural(result.structure.size(), "pattern"),
                     p_text(result.structure_p_value, report.settings.replicates), table.text());
}

std::string next_text(const DiagnosisReport& report) {
  const std::optional<PlannedMeasurement>& next = report.result.next_measurement;
  if (!next) return "";
  return fmt::format("\nNext measurement\n{}: {}.\n", measurement_text(*next, report), next->why);
}

std::string ranking_text(const DiagnosisReport& report) {
  if (!report.ranking) return "";
  const CatalogueRanking& ranking = *report.ranking;
  std::string text =
      "\nRanking of the catalogue (2 fingers, over mean uniformity and efficiency)\n";
  if (!ranking.changes()) {
    return text + fmt::format("does not change: {}\n", fmt::join(ranking.after, ", "));
  }
  return text + fmt::format("changes from  {}\n        to    {}\n", fmt::join(ranking.before, ", "),
                            fmt::join(ranking.after, ", "));
}

}  // namespace

std::string diagnosis_text(const DiagnosisReport& report) {
  return diagnosis_answer(report) + causes_text(report) + gains_text(report) +
         weighed_text(report) + indistinguishable_text(report) + left_text(report) +
         next_text(report) + ranking_text(report) + data_text(report) +
         notes_text(report.result.notes);
}

}  // namespace reeve
