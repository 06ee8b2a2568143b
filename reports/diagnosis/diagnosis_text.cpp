#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "diagnosis/fit/evidence.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis/diagnosis_evidence.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::reports {
namespace {

// Limits of lists that can be long; the JSON has all.
constexpr std::size_t most_rows = 8;
constexpr std::size_t most_findings = 6;

void add_sentences(Section& section, const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) section.lines.push_back({sentence});
}

// A section of no more than so many rows; a line below says how many there are besides.
Section cut_section(const std::string& title, Table table, std::size_t most) {
  const std::size_t all = table.rows.size();
  table.rows.resize(std::min(all, most));
  Section section{title, std::move(table), {}};
  if (all > most) section.lines.push_back({fmt::format("… {} more", all - most)});
  return section;
}

std::string noise_text(const Noise& noise) {
  if (noise.source == NoiseSource::known) return "Noise: of each channel as it was told";
  const char* source = noise.source == NoiseSource::repeats     ? "repeated readings"
                       : noise.source == NoiseSource::smoothing ? "what no smooth law explains"
                       : noise.source == NoiseSource::repeats_and_smoothing
                           ? "repeated readings and what no smooth law explains"
                           : "the residuals";
  return fmt::format("Noise: {} of the reading and {}, by {} ({:.0f} degrees of freedom)",
                     fine_percent_text(noise.relative), newton(noise.absolute_N), source,
                     noise.degrees_of_freedom);
}

Section data_section(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  Section section{"Data", std::nullopt, {}};
  section.lines.push_back({fmt::format("{}: {}; {} dropped", report.data.file, used_text(report),
                                       plural(result.dropped_duplicates, "repeated reading"))});
  if (report.data.simulated) section.lines.push_back(simulated_line());
  section.lines.push_back({noise_text(result.noise)});
  add_sentences(section, scatter_sentences(result));
  for (const std::string& sentence : coefficient_sentences(result)) {
    section.lines.push_back({"Calibrated: " + sentence});
  }
  const std::string groups_scatter = group_scatter_sentence(report);
  if (!groups_scatter.empty()) section.lines.push_back({groups_scatter});
  add_sentences(section, not_named_sentences(result));
  return section;
}

std::vector<TableColumn> cause_columns() {
  return {text_column("cause"),
          number_column("explains"),
          text_column("parameter"),
          number_column("value"),
          number_column("95 % interval"),
          number_column("nominal"),
          number_column("literature", "", 1),
          text_column("unit"),
          number_column("p"),
          text_column("runner-up (evidence less)")};
}

Section causes_section(const DiagnosisReport& report) {
  const std::vector<NamedCause>& causes = report.result.causes;
  if (causes.empty()) return {};
  Table table{cause_columns(), {}};
  for (const NamedCause& cause : causes) {
    const std::string explains = part_of_residuals(report, cause.explained.rms_N);
    const std::string p = p_number(cause.p_value, report.settings.replicates);
    const std::string other = cause.runner_up
                                  ? fmt::format("{} ({})", cause.runner_up->name,
                                                gain_number(cause.runner_up->delta_log_likelihood))
                                  : "-";
    if (cause.parameters.empty()) {
      table.add({cause.name, explains, cause.detail.empty() ? "-" : cause.detail, "-", "-", "-",
                 "-", "-", p, other});
    }
    for (std::size_t i = 0; i < cause.parameters.size(); ++i) {
      const EstimatedParameter& parameter = cause.parameters[i];
      const bool first = i == 0;
      table.add({first ? cause.name : "", first ? explains : "", parameter.name,
                 estimate(parameter, parameter.value), interval_text(parameter),
                 parameter.nominal ? estimate(parameter, *parameter.nominal) : "-",
                 literature_range(parameter, "-"), parameter_unit(cause, i), first ? p : "",
                 first ? other : ""});
    }
  }
  Section section = cut_section("Causes, by the share of the residuals that they explain",
                                std::move(table), most_findings);
  add_sentences(section, influence_sentences(report));
  return section;
}

Section gains_section(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  if (!result.held_out) return {};
  Table table{{text_column("with"), number_column("rms without it"), number_column("rms with it"),
               number_column("reduction"), number_column("95 % interval"),
               number_column("log-likelihood gain", "", 1), number_column("95 % interval", "", 2),
               number_column("expected gain", "", 3)},
              {}};
  add_gains(result, table);
  return {fmt::format("Gain on {}, each cause over all others",
                      plural(result.held_out_runs, "held-out run")),
          table,
          {}};
}

Section weighed_section(const DiagnosisReport& report) {
  const std::vector<WeighedCauses>& weighed = report.result.weighed;
  if (weighed.empty()) return {};
  Table table{{text_column("model"), number_column("all readings"), number_column("held-out runs"),
               number_column("rms held out")},
              {}};
  for (const WeighedCauses& model : weighed) {
    const std::optional<HeldOut>& held_out = model.held_out;
    table.add({joined_causes(model.causes), gain_number(model.gain),
               held_out ? gain_number(held_out->log_likelihood_gain) : "-",
               held_out ? newton(held_out->rms_after_N) : "-"});
  }
  return cut_section("Compared models: gain in log-likelihood over the nominal model",
                     std::move(table), most_rows);
}

Section indistinguishable_section(const DiagnosisReport& report) {
  Section section{
      fmt::format("Ambiguous (less than {:.2g} nats of evidence between them)", least_evidence),
      std::nullopt,
      {}};
  for (const std::vector<std::string>& names : report.result.indistinguishable) {
    section.lines.push_back({fmt::format("- {}", fmt::join(names, ", "))});
  }
  return section;
}

Section left_section(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  if (result.structure.empty()) return {};
  constexpr std::size_t most = 3;
  return {fmt::format("Structure in the residuals: the strongest of {} ({} for all together)",
                      plural(result.structure.size(), "pattern"),
                      p_text(result.structure_p_value, report.settings.replicates)),
          structure_table(report, most),
          {}};
}

// Than that it is right.
bool says_more_than_the_model(const DiagnosisReport& report) {
  const std::vector<Loss>& losses = report.result.losses;
  return !report.result.model.effects.empty() || std::ranges::any_of(losses, &Loss::stands_apart);
}

Section shares_section(const DiagnosisReport& report) {
  if (report.result.share_errors.groups.empty() || !says_more_than_the_model(report)) return {};
  Section section{
      "Error of the tension distribution, root of the summed squared differences of the shares",
      share_error_table(report),
      {}};
  add_sentences(section, published_sentences(report));
  return section;
}

Section losses_section(const DiagnosisReport& report) {
  constexpr std::size_t most_losses = 24;
  Table table = loss_table(report);
  if (table.rows.empty() || !says_more_than_the_model(report)) return {};
  Section section =
      cut_section("Ratio of the tensions from sensor to sensor", std::move(table), most_losses);
  add_sentences(section, loss_sentences(report));
  return section;
}

Section groups_section(const DiagnosisReport& report) {
  Table table = group_table(report);
  if (table.rows.empty()) return {};
  return {"By group, each fitted by itself", std::move(table), {}};
}

Section next_section(const DiagnosisReport& report) {
  const std::optional<PlannedMeasurement>& next = report.result.next_measurement;
  if (!next) return {};
  return {"Next measurement",
          std::nullopt,
          {{fmt::format("{}: {}.", measurement_text(*next, report), next->why)}}};
}

Section ranking_section(const DiagnosisReport& report) {
  if (!report.ranking) return {};
  const CatalogueRanking& ranking = *report.ranking;
  Section section{"Ranking of the catalogue (2 fingers, over mean uniformity and efficiency)",
                  std::nullopt,
                  {}};
  if (!ranking.changes()) {
    section.lines.push_back({fmt::format("does not change: {}", fmt::join(ranking.after, ", "))});
  } else {
    section.lines.push_back({fmt::format("changes from  {}", fmt::join(ranking.before, ", "))});
    section.lines.push_back({fmt::format("        to    {}", fmt::join(ranking.after, ", "))});
  }
  return section;
}

}  // namespace

Document diagnosis_document(const DiagnosisReport& report) {
  Section answer;
  add_lines(answer.lines, diagnosis_answer(report));
  Document document{{answer}};
  for (const auto part : {causes_section, gains_section, weighed_section, indistinguishable_section,
                          left_section, shares_section, groups_section, losses_section,
                          next_section, ranking_section, data_section}) {
    document.add(part(report));
  }
  Section further;
  add_lines(further.lines, further_answer(report));
  document.add(further);
  document.add(notes_section(report.result.notes));
  return document;
}

}  // namespace reeve::reports
