#include "reports/diagnosis/diagnosis_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "catalog/model_file.hpp"
#include "causes/term.hpp"
#include "core/version.hpp"
#include "readings/csv.hpp"
#include "reports/data_text.hpp"
#include "reports/law_words.hpp"

namespace reeve::reports {
namespace {

bool at_the_least(double p_value, std::size_t replicates) {
  return p_value <= 1 / static_cast<double>(replicates + 1);
}

std::string grasp_text(Grasp grasp) {
  const std::vector<int> held = held_fingers(grasp);
  if (held.empty()) return "no finger held";
  return fmt::format("finger{} {} held", held.size() == 1 ? "" : "s", fmt::join(held, ", "));
}

// Returns "" if there is no choice of grasps.
std::string held_text(const Measurement& at) {
  const bool has_grasps = finger_count(at.routing.routing) > 1 || at.grasp.held != 0;
  return has_grasps ? " with " + grasp_text(at.grasp) : "";
}

// Names such as force_N have it already.
std::string unit_text(const EstimatedParameter& parameter) {
  const bool has_it = parameter.unit == "1" || parameter.name.ends_with("_" + parameter.unit);
  return has_it ? "" : " " + parameter.unit;
}

std::string nominal_text(const EstimatedParameter& parameter, const Effect& effect) {
  if (!parameter.nominal) return "";
  // Other causes add to what the hardware says.
  const bool in_hardware = effect.cause->reach() == Reach::hardware && *parameter.nominal != 0;
  return fmt::format("; {} {}", in_hardware ? "nominal" : "without it",
                     estimate(parameter, *parameter.nominal));
}

std::string literature_text(const EstimatedParameter& parameter) {
  if (!parameter.literature) return "";
  const Range range = *parameter.literature;
  const bool outside = parameter.value < range.low || parameter.value > range.high;
  return (outside ? "; outside the literature's " : ", literature ") +
         literature_range(parameter, "");
}

std::string parameter_text(const EstimatedParameter& parameter, const Effect& effect) {
  return fmt::format("{} = {}{} (95 % CI {}{}{})", parameter.name,
                     estimate(parameter, parameter.value), unit_text(parameter),
                     interval_text(parameter), nominal_text(parameter, effect),
                     literature_text(parameter));
}

// "95 % intervals of a 0.1 to 0.2, of b 30 to 40"
std::string intervals_text(const NamedCause& cause) {
  const auto of_one = [](const EstimatedParameter& parameter) {
    return fmt::format("of {} {}", parameter.name, interval_text(parameter));
  };
  return fmt::format("95 % interval{} {}", cause.parameters.size() == 1 ? "" : "s",
                     joined(cause.parameters, ", ", of_one));
}

}  // namespace

std::string catalogue_name(const DiagnosisReport& report, const std::string& word) {
  const auto named = report.names.find(word);
  return named == report.names.end() ? "" : named->second;
}

std::string routing_name(const DiagnosisReport& report, std::size_t routing) {
  const std::string& word = report.data.routings[routing].word;
  const std::string name = catalogue_name(report, word);
  return name.empty() ? word : name;
}

std::string joined_causes(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, " + "));
}

std::string estimate(const EstimatedParameter& parameter, double value) {
  const double half = (parameter.high - parameter.low) / 2;
  if (!std::isfinite(half) || half <= 0) return fmt::format("{:.4g}", value);
  // Two digits of a width that begins with 1 or 2, else one.
  const int places = std::clamp(static_cast<int>(std::ceil(std::log10(3 / half))), 0, 6);
  const bool vanishes = value != 0 && std::abs(value) < 0.5 * std::pow(10.0, -places);
  return vanishes ? fmt::format("{:.2g}", value) : fmt::format("{:.{}f}", value, places);
}

std::string interval_text(const EstimatedParameter& parameter) {
  return estimate(parameter, parameter.low) + " to " + estimate(parameter, parameter.high);
}

std::string literature_range(const EstimatedParameter& parameter, const char* none) {
  const std::optional<Range>& range = parameter.literature;
  return range ? fmt::format("{:.4g} to {:.4g}", range->low, range->high) : none;
}

std::string cause_text(const NamedCause& cause) {
  if (const Term* term = term_of(*cause.effect.cause)) {
    return formula(*term, cause.effect.values) + ", " + intervals_text(cause);
  }
  std::string text = cause.name;
  for (const EstimatedParameter& parameter : cause.parameters) {
    text += ", " + parameter_text(parameter, cause.effect);
  }
  return cause.detail.empty() ? text : text + ", " + cause.detail;
}

std::string cause_meaning(const NamedCause& cause) {
  const Term* term = term_of(*cause.effect.cause);
  return term == nullptr ? cause.meaning : law_meaning(*term, cause.effect.values);
}

std::string parameter_unit(const NamedCause& cause, std::size_t i) {
  const Term* term = term_of(*cause.effect.cause);
  return term == nullptr ? cause.parameters[i].unit : law_unit(*term, i);
}

std::string cause_sentence(const NamedCause& cause) {
  return cause_meaning(cause) + ": " + cause_text(cause);
}

std::string size_with_interval(const NamedCause& cause) {
  std::string text = cause.name;
  for (const EstimatedParameter& parameter : cause.parameters) {
    text += fmt::format(", {} = {}{} ({})", parameter.name, estimate(parameter, parameter.value),
                        unit_text(parameter), interval_text(parameter));
  }
  return text;
}

bool is_negligible(const DiagnosisReport& report, double part_N) {
  constexpr double matters = 0.002;  // share of the readings
  double square = 0;
  for (const ComparedCell& cell : report.result.cells) square += std::pow(cell.cell.measured_N, 2);
  const double reading_N =
      std::sqrt(square / std::max(1.0, static_cast<double>(report.result.cells.size())));
  return part_N < matters * reading_N;
}

std::string part_of_residuals(const DiagnosisReport& report, double part_N) {
  return fmt::format("{} of {}{}", newton(std::max(0.0, part_N)),
                     newton(report.result.residual_before_N),
                     is_negligible(report, part_N) ? ", negligible" : "");
}

double structure_N(const DiagnosisReport& report, const StructureFinding& finding) {
  return std::sqrt(finding.share) * report.result.residual_after_N;
}

std::string lead_text(const Lead& lead) {
  constexpr std::size_t most_named = 2;
  std::string text =
      fmt::format("{} ({} nats", lead.effect.cause->meaning(), gain_number(lead.evidence));
  for (std::size_t i = 0; i < std::min(lead.alike.size(), most_named); ++i) {
    text += (i == 0 ? "; alike " : " or ") + std::string(lead.alike[i].cause->meaning());
  }
  return text + ")";
}

std::string leads_sentence(const DiagnosisReport& report) {
  const std::vector<Lead>& leads = report.result.leads;
  if (leads.empty()) return "";
  return fmt::format("Strongest lead{}, not confirmed: {}.", leads.size() == 1 ? "" : "s",
                     joined(leads, "; ", lead_text));
}

std::string gain_text(const HeldOut& held_out, std::size_t runs) {
  const bool rises = held_out.reduction < 0;
  std::string text =
      fmt::format("on {} {} by {} ({} to {}): from {} to {}", plural(runs, "held-out run"),
                  rises ? "rise" : "fall", percent_text(std::abs(held_out.reduction)),
                  percent_text(rises ? -held_out.high : held_out.low),
                  percent_text(rises ? -held_out.low : held_out.high),
                  newton(held_out.rms_before_N), newton(held_out.rms_after_N));
  // In newton the greatest readings count most, and with them how far their mounting is off.
  if (held_out.low <= 0 && held_out.gain_low > 0) {
    text += fmt::format(
        "; but weighed by what noise and mountings do to each, the readings are likelier by {} ({} "
        "to {}) in log-likelihood",
        gain_number(held_out.log_likelihood_gain), gain_number(held_out.gain_low),
        gain_number(held_out.gain_high));
  }
  return text;
}

std::string measurement_text(const PlannedMeasurement& planned, const DiagnosisReport& report) {
  const Measurement& at = planned.measurement;
  const std::string& word = at.routing.word;
  const std::string name = catalogue_name(report, word);
  std::string text = name.empty() ? word : fmt::format("{} ({})", name, word);
  text += fmt::format("{}, {} with {} N at the motor", held_text(at),
                      at.direction == Direction::pull ? "pulled" : "released",
                      set_value(at.conditions.motor_tension_N));
  if (at.uses_speed) text += fmt::format(", at {} mm/s", set_value(at.conditions.speed_mm_s));
  if (at.uses_cycle) text += fmt::format(", after {} cycles", set_value(at.conditions.cycle));
  if (at.uses_temperature) {
    text += fmt::format(", at {} °C", set_value(at.conditions.temperature_C));
  }
  return text;
}

std::string pattern_text(const DiagnosisReport& report, const std::string& about) {
  if (!is_bench(report.data)) return about;
  if (about == "grasp") return "direction";
  return about == "routing, grasp and strand" ? "routing, direction and strand" : about;
}

bool weak_structure_remains(const DiagnosisReport& report) {
  return !report.result.unexplained && !report.result.structure.empty() &&
         report.result.structure_p_value <= report.settings.alpha;
}

std::string used_text(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  std::string used =
      fmt::format("{} in {}", plural(result.rows, "reading"), plural(result.runs, "run"));
  if (result.held_out_runs == 0) return used;
  return used + (report.settings.hold_out > 0
                     ? fmt::format(", {} of them held out", result.held_out_runs)
                     : ", each run forecast once by a model fitted without it");
}

std::string newton(double value) {
  constexpr double has_exponent = 99.5;  // in two digits
  constexpr double readable = 1e6;
  if (value < has_exponent || value >= readable) return fmt::format("{:.2g} N", value);
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return fmt::format("{:.0f} N", std::round(value / digit) * digit);
}

std::string fine_percent_text(double share) {
  const double percent = 100 * share;
  return percent < 99.5 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

std::string percent_text(double share) {
  return fmt::format("{:.0f} %", std::round(100 * share) + 0.0);  // never -0
}

std::string p_text(double p_value, std::size_t replicates) {
  return at_the_least(p_value, replicates) ? "p " + p_number(p_value, replicates)
                                           : "p = " + p_number(p_value, replicates);
}

std::string p_number(double p_value, std::size_t replicates) {
  return fmt::format("{}{:.2g}", at_the_least(p_value, replicates) ? "< " : "", p_value);
}

std::string gain_number(double gain) {
  if (std::abs(gain) < 0.05) return "0.0";  // never -0.0
  return fmt::format("{:.{}f}", gain, std::abs(gain) < 99.95 ? 1 : 0);
}

std::string gain_interval(double low, double high) {
  return gain_number(low) + " to " + gain_number(high);
}

std::string set_value(double value) { return fmt::format("{:.6g}", value); }

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string extended_model_toml(const DiagnosisReport& report,
                                const UncertaintyRanges& uncertainty) {
  const DiagnosisResult& result = report.result;
  const Version build = version();
  std::vector<std::string> lines{fmt::format("Extended by reeve {} from the readings in {}",
                                             build.number, one_line(report.data.file))};
  if (report.data.simulated) lines.push_back(fmt::format("The data are {}.", simulated_text));
  lines.push_back(fmt::format("Verdict: {}", verdict_name(result.verdict)));
  for (const NamedCause& cause : result.causes) {
    lines.push_back(capitalised(cause_sentence(cause)));
  }
  for (const auto& names : result.indistinguishable) {
    lines.push_back(fmt::format("The data cannot tell apart: {}", fmt::join(names, ", ")));
  }
  return model_toml(result.model, lines, uncertainty);
}

}  // namespace reeve::reports
