#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "pages/diagnosis/diagnosis_labels.hpp"
#include "pages/diagnosis/diagnosis_values.hpp"
#include "pages/shell/html_table.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis/diagnosis_evidence.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::pages {
namespace {

constexpr const char* none = "–";

std::string written(const HtmlTable& table) { return table.table.rows.empty() ? "" : html(table); }

std::string weighed_caption(const DiagnosisResult& result) {
  std::string caption = "Gain in log-likelihood over the nominal model";
  const std::optional<NoiseLimit>& limit = result.noise_limit;
  if (!limit) return caption;
  return caption + fmt::format("; as good as noise allows on the held-out runs: {} ({}), rms {}",
                               gain_number(limit->log_likelihood_gain),
                               gain_interval(limit->low, limit->high), newton(limit->rms_N));
}

std::string lines_text(const std::vector<std::size_t>& lines) {
  constexpr std::size_t most = 12;
  if (lines.empty()) return "the whole file";
  const std::size_t shown = std::min(lines.size(), most);
  const auto end = lines.begin() + static_cast<std::ptrdiff_t>(shown);
  return fmt::format("{}{}", fmt::join(lines.begin(), end, ", "),
                     shown < lines.size() ? ", …" : "");
}

}  // namespace

bool separates_causes(const DiagnosisResult& result) {
  return result.next_measurement && !result.next_measurement->between.empty();
}

std::string findings_table(const DiagnosisReport& report) {
  constexpr std::size_t most = 6;
  const std::vector<NamedCause>& causes = report.result.causes;
  Table table{{text_column("finding"), number_column("explains"), number_column("share"),
               text_column("size, 95 % interval"), number_column("p")},
              {}};
  for (std::size_t i = 0; i < causes.size() && i < most; ++i) {
    const NamedCause& cause = causes[i];
    const std::string size =
        cause.parameters.empty()
            ? cause.detail
            : fmt::format("{} = {} ({})", cause.parameters.front().name,
                          estimate(cause.parameters.front(), cause.parameters.front().value),
                          interval_text(cause.parameters.front()));
    table.add({cause.name, part_of_residuals(report, cause.explained.rms_N),
               fine_percent_text(cause.explained.share), size,
               p_number(cause.p_value, report.settings.replicates)});
  }
  std::string caption =
      "Part of the rms residual that each cause explains, added from the greatest on";
  if (causes.size() > most) caption += fmt::format("; {} more below", causes.size() - most);
  return written({"findings", caption, std::move(table)});
}

std::string sizes_table(const DiagnosisResult& result) {
  Table table{{text_column("cause"), text_column("parameter"), number_column("estimate"),
               number_column("95 % interval"), number_column("nominal"),
               number_column("literature"), text_column("unit")},
              {}};
  for (const NamedCause& cause : result.causes) {
    for (std::size_t i = 0; i < cause.parameters.size(); ++i) {
      const EstimatedParameter& parameter = cause.parameters[i];
      table.add({cause.name, parameter.name, estimate(parameter, parameter.value),
                 interval_text(parameter),
                 parameter.nominal ? estimate(parameter, *parameter.nominal) : none,
                 literature_range(parameter, none), parameter_unit(cause, i)});
    }
  }
  return written({"named-causes", "Sizes, with 95 % intervals", std::move(table)});
}

std::string calibration_table(const DiagnosisResult& result) {
  Table table{{text_column("contacts"), text_column("parameter"), number_column("calibrated"),
               number_column("95 % interval"), text_column("compared with the nominal value")},
              {}};
  for (const CalibratedCoefficient& coefficient : result.calibration) {
    const EstimatedParameter& parameter = coefficient.parameter;
    const char* bound = parameter.at_bound ? ", at the limit of the search" : "";
    table.add({coefficient.name, parameter.name, estimate(parameter, parameter.value),
               interval_text(parameter), capitalised(beside_hardware(coefficient)) + bound});
  }
  return written({"calibrated", "Friction coefficients by these readings, with 95 % intervals",
                  std::move(table)});
}

std::string groups_table(const DiagnosisReport& report) {
  return written(
      {"by-group", "Each group fitted by itself, with 95 % intervals", group_table(report)});
}

std::string weighed_table(const DiagnosisResult& result) {
  Table table{{text_column("model"), text_column("stands as"), number_column("all readings"),
               number_column("held-out runs"), number_column("95 % interval"),
               number_column("rms held out")},
              {}};
  for (const WeighedCauses& model : by_training_gain(result.weighed)) {
    const std::string place = standing(result, model.causes);
    const std::optional<HeldOut>& held_out = model.held_out;
    table.add({(place == "named" ? "◆ " : "") + joined_causes(model.causes), place,
               gain_number(model.gain),
               held_out ? gain_number(held_out->log_likelihood_gain) : none,
               held_out ? gain_interval(held_out->gain_low, held_out->gain_high) : none,
               held_out ? newton(held_out->rms_after_N) : none});
  }
  return written({"weighed-models", weighed_caption(result), std::move(table), true});
}

std::string gains_table(const DiagnosisResult& result) {
  Table table{
      {text_column("with"), number_column("rms without it"), number_column("rms with it"),
       number_column("reduction"), number_column("interval"), number_column("log-likelihood gain"),
       number_column("interval"), number_column("expected, if right")},
      {}};
  add_gains(result, table);
  return written({"gains",
                  fmt::format("On {} that no fit has seen, each cause over all others; intervals "
                              "are of 95 %",
                              plural(result.held_out_runs, "run")),
                  std::move(table)});
}

std::string structure_table(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  return written({"structure",
                  fmt::format("What the residuals could still follow{}, tested on the training "
                              "runs ({} for all together)",
                              result.causes.empty() ? "" : " after the model is extended",
                              p_text(result.structure_p_value, report.settings.replicates)),
                  reports::structure_table(report, result.structure.size()), true});
}

std::string expected_table(const DiagnosisResult& result) {
  const bool separates = separates_causes(result);
  std::string caption = "What the sensors should read there, N";
  Table table{{text_column("sensor")}, {}};
  if (separates) {
    const std::vector<std::string>& names = result.next_measurement->between;
    caption += fmt::format(": if it is {}, and if it is {}", names[0], names[1]);
    for (int i = 0; i < 2; ++i) {
      table.columns.push_back(number_column(names[static_cast<std::size_t>(i)]));
    }
  } else {
    table.columns.push_back(number_column("extended model"));
  }
  table.columns.push_back(number_column("noise, sd"));
  for (const ExpectedReading& reading : result.next_measurement->expected) {
    std::vector<std::string> cells{reading.segment, fmt::format("{:.3g}", reading.expected_N)};
    if (separates) cells.push_back(fmt::format("{:.3g}", reading.other_N));
    cells.push_back(fmt::format("{:.2g}", reading.deviation_N));
    table.add(std::move(cells));
  }
  return written({"expected", caption, std::move(table)});
}

std::string ranking_table(const CatalogueRanking& ranking) {
  Table table{{number_column("rank"), text_column("before"), text_column("after")}, {}};
  for (std::size_t i = 0; i < ranking.after.size(); ++i) {
    const auto was = std::ranges::find(ranking.before, ranking.after[i]) - ranking.before.begin();
    const bool moved = was != static_cast<std::ptrdiff_t>(i);
    table.add({std::to_string(i + 1), i < ranking.before.size() ? ranking.before[i] : "",
               moved ? fmt::format("{} (was {})", ranking.after[i], was + 1) : ranking.after[i]},
              moved ? Tint::notable : Tint::none);
  }
  return written({"ranks", "Rank of the catalogue's routings", std::move(table)});
}

std::string notes_table(const DiagnosisResult& result) {
  Table table{
      {text_column("what"), text_column("note"), number_column("lines"), text_column("which")}, {}};
  for (const DataNote& note : result.notes) {
    std::string kind = note_kind_name(note.kind);
    std::ranges::replace(kind, '_', ' ');
    table.add({kind, note.text, note.lines.empty() ? none : std::to_string(note.lines.size()),
               lines_text(note.lines)});
  }
  return written(
      {"notes", "What looks wrong or was left out; nothing was mended", std::move(table)});
}

std::string friction_table(const Hardware& hardware) {
  Table table{{text_column("part"), number_column("friction coefficient"),
               number_column("wrap angle", "rad")},
              {}};
  const auto add = [&](const char* part, const ContactLaw& law) {
    table.add({part, fmt::format("{:.4g}", law.mu), fmt::format("{:.4g}", law.whole_angle_rad())});
  };
  add("tube", hardware.tube);
  add("bearing", hardware.bearing);
  if (hardware.block) add("floating block", *hardware.block);
  add("sheath", hardware.sheath);
  return written({"friction",
                  "The nominal model: friction by kind of part; diagnosis.json has what "
                  "differs at single fingers and contacts",
                  std::move(table)});
}

}  // namespace reeve::pages
