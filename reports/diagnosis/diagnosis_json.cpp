#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "causes/term.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis/diagnosis_evidence.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"
#include "reports/law_words.hpp"
#include "reports/output/csv_field.hpp"
#include "reports/output/json.hpp"
#include "reports/output/stamp.hpp"

namespace reeve::reports {
namespace {

Json held_out_json(const HeldOut& held_out) {
  return {{"rms_before", number(held_out.rms_before_N)},
          {"rms_after", number(held_out.rms_after_N)},
          {"reduction", number(held_out.reduction)},
          {"low", number(held_out.low)},
          {"high", number(held_out.high)},
          {"log_likelihood_gain", number(held_out.log_likelihood_gain)},
          {"gain_low", number(held_out.gain_low)},
          {"gain_high", number(held_out.gain_high)},
          {"expected_gain", number(held_out.expected_gain)}};
}

Json parameter_json(const EstimatedParameter& parameter) {
  return {{"name", parameter.name},
          {"value", number(parameter.value)},
          {"low", number(parameter.low)},
          {"high", number(parameter.high)},
          {"nominal", value_or_null(parameter.nominal, number)},
          {"unit", parameter.unit},
          {"at_bound", parameter.at_bound},
          {"literature", value_or_null(parameter.literature, [](const Range& range) {
             return Json::array({range.low, range.high});
           })}};
}

template <typename Items, typename Number>
Json numbers_json(const Items& items, Number number_of) {
  return list_json(items, [&](const auto& item) { return number(number_of(item)); });
}

Json axis_json(const AxisName& axis) {
  return {{"name", axis.name}, {"unit", text_or_null(axis.unit)}};
}

// Columns, as for a data frame.
Json partial_json(const PartialResiduals& partial, const MeasuredData& data) {
  const auto reading = [&](const PartialPoint& point) -> const Reading& {
    return data.readings[point.reading];
  };
  Json points{
      {"x", numbers_json(partial.points, [](const PartialPoint& p) { return p.x; })},
      {"y", numbers_json(partial.points, [](const PartialPoint& p) { return p.y; })},
      {"deviation",
       numbers_json(partial.points, [](const PartialPoint& p) { return p.deviation; })},
      {"run",
       list_json(partial.points, [&](const PartialPoint& p) { return data.runs[reading(p).run]; })},
      {"line", list_json(partial.points, [&](const PartialPoint& p) { return reading(p).line; })},
      {"held_out", list_json(partial.points, [](const PartialPoint& p) { return p.held_out; })}};
  Json curve{{"x", numbers_json(partial.curve, [](const CurvePoint& p) { return p.x; })},
             {"y", numbers_json(partial.curve, [](const CurvePoint& p) { return p.y; })},
             {"low", numbers_json(partial.curve, [](const CurvePoint& p) { return p.low; })},
             {"high", numbers_json(partial.curve, [](const CurvePoint& p) { return p.high; })}};
  return {{"x", axis_json(partial.x)},    {"y", axis_json(partial.y)},
          {"points", std::move(points)},  {"curve", std::move(curve)},
          {"left_out", partial.left_out}, {"thinned", partial.thinned}};
}

Json partial_or_null(const std::optional<PartialResiduals>& partial, const MeasuredData& data) {
  return value_or_null(partial,
                       [&](const PartialResiduals& some) { return partial_json(some, data); });
}

Json cause_json(const NamedCause& cause, const DiagnosisReport& report) {
  return {{"name", cause.name},
          {"meaning", cause.meaning},
          {"detail", text_or_null(cause.detail)},
          {"explained",
           {{"rms", number(cause.explained.rms_N)}, {"share", number(cause.explained.share)}}},
          {"parameters", list_json(cause.parameters, parameter_json)},
          {"held_out", value_or_null(cause.held_out, held_out_json)},
          {"only_run", text_or_null(cause.only_run)},
          {"p_value", cause.p_value},
          {"evidence", value_or_null(cause.evidence, number)},
          {"probability", value_or_null(cause.probability, number)},
          {"folds", value_or_null(cause.folds, number)},
          {"runner_up", value_or_null(cause.runner_up,
                                      [](const RunnerUp& other) {
                                        return Json{{"name", other.name},
                                                    {"delta_log_likelihood",
                                                     number(other.delta_log_likelihood)}};
                                      })},
          {"partial_residuals", partial_or_null(cause.partial, report.data)}};
}

// As of a cause, with the parts of its term in place of the meaning.
Json named_law_json(const NamedCause& cause, const DiagnosisReport& report) {
  const Term& term = *term_of(*cause.effect.cause);
  Json json = cause_json(cause, report);
  json.erase("meaning");
  json.erase("detail");
  json.update(law_json(term));
  json["formula"] = formula(term, cause.effect.values);
  json["text"] = capitalised(cause_sentence(cause)) + ".";
  for (std::size_t i = 0; i < cause.parameters.size(); ++i) {
    json["parameters"][i]["unit"] = parameter_unit(cause, i);
  }
  return json;
}

bool is_law(const NamedCause& cause) { return term_of(*cause.effect.cause) != nullptr; }

Json measurement_json(const PlannedMeasurement& planned, const DiagnosisReport& report) {
  const Measurement& at = planned.measurement;
  const auto if_used = [](bool used, double value) { return used ? Json(value) : Json(nullptr); };
  const bool shrinks = !planned.parameter.empty();
  return {{"routing", at.routing.word},
          {"name", text_or_null(catalogue_name(report, at.routing.word))},
          {"held", held_fingers(at.grasp)},
          {"direction", direction_field(at.direction)},
          {"motor_tension_N", at.conditions.motor_tension_N},
          {"speed_mm_s", if_used(at.uses_speed, at.conditions.speed_mm_s)},
          {"cycle", if_used(at.uses_cycle, at.conditions.cycle)},
          {"temperature_C", if_used(at.uses_temperature, at.conditions.temperature_C)},
          {"readings", planned_readings},
          {"why", planned.why},
          {"expected", list_json(planned.expected,
                                 [&](const ExpectedReading& reading) {
                                   return Json{{"channel", reading.segment},
                                               {"expected_N", number(reading.expected_N)},
                                               {"other_N", if_used(!shrinks, reading.other_N)},
                                               {"deviation_N", number(reading.deviation_N)}};
                                 })},
          {"expected_log_likelihood", if_used(!shrinks, planned.expected_log_likelihood)},
          {"parameter", text_or_null(planned.parameter)},
          {"width_now", if_used(shrinks, planned.width_now)},
          {"width_expected", if_used(shrinks, planned.width_expected)}};
}

Json noise_json(const DiagnosisReport& report) {
  const Noise& noise = report.result.noise;
  return {{"relative", noise.relative},
          {"absolute_N", noise.absolute_N},
          {"source", noise_source_name(noise.source)},
          {"degrees_of_freedom", noise.degrees_of_freedom},
          {"within_mountings", noise.within_mountings},
          {"of_group", noise_of_groups_json(report)}};
}

Json diagnosis_settings_json(const DiagnosisReport& report) {
  const DiagnosisSettings& settings = report.settings;
  return {{"data", report.data.file},
          {"alpha", settings.alpha},
          {"hold_out", settings.hold_out},
          {"seed", settings.seed},
          {"generated_routings", report.with_generated},
          {"hardware", to_json(report.hardware)},
          {"terms", list_json(settings.terms, effect_name)}};
}

void add_findings(Json& json, const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  const auto planned = [&](const PlannedMeasurement& measurement) {
    return measurement_json(measurement, report);
  };
  json["verdict"] = verdict_name(result.verdict);
  std::vector<NamedCause> laws = result.causes;
  const auto causes = std::stable_partition(laws.begin(), laws.end(), is_law);
  json["causes"] = list_json(std::vector(causes, laws.end()),
                             [&](const NamedCause& cause) { return cause_json(cause, report); });
  laws.erase(causes, laws.end());
  json["laws"] =
      list_json(laws, [&](const NamedCause& law) { return named_law_json(law, report); });
  json["indistinguishable"] = result.indistinguishable;
  json["separating_measurement"] = value_or_null(result.separating_measurement, planned);
  json["unexplained"] = value_or_null(result.unexplained, [](const Unexplained& left) {
    return Json{{"about", left.about}, {"where", left.where}, {"p_value", left.p_value}};
  });
  json["leads"] = list_json(result.leads, [&](const Lead& lead) {
    const Term& term = *term_of(*lead.effect.cause);
    Json fields{{"name", effect_name(lead.effect)}, {"evidence", number(lead.evidence)}};
    fields.update(law_json(term));
    fields["formula"] = formula(term, lead.effect.values);
    fields["alike"] = list_json(lead.alike, effect_name);
    fields["partial_residuals"] = partial_or_null(lead.partial, report.data);
    return fields;
  });
  json["residuals"] = {{"before", number(result.residual_before_N)},
                       {"after", number(result.residual_after_N)}};
  json["next_measurement"] = value_or_null(result.next_measurement, planned);
  json["held_out"] = value_or_null(result.held_out, held_out_json);
}

Json noise_limit_json(const NoiseLimit& limit) {
  return {{"log_likelihood_gain", number(limit.log_likelihood_gain)},
          {"low", number(limit.low)},
          {"high", number(limit.high)},
          {"rms", number(limit.rms_N)}};
}

Json share_errors_json(const DiagnosisReport& report) {
  const ShareErrors& errors = report.result.share_errors;
  if (errors.groups.empty()) return nullptr;
  return {{"before", number(errors.before)},
          {"after", number(errors.after)},
          {"left_out", value_or_null(errors.left_out, number)},
          {"routings", list_json(errors.groups, [&](const ShareError& group) {
             return Json{{"routing", report.data.routings[group.routing].word},
                         {"held", held_fingers(group.grasp)},
                         {"rows", group.rows},
                         {"held_out_rows", group.held_out_rows},
                         {"before", number(group.before)},
                         {"after", number(group.after)},
                         {"left_out", value_or_null(group.left_out, number)}};
           })}};
}

// [{"name", "parameters": {"mu": 0.05}}]
Json effects_json(const Model& model) {
  return list_json(model.effects, [&](const Effect& effect) {
    Json values = Json::object();
    const auto parameters = effect.cause->parameters(model.hardware);
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      values[parameters[p].name] = number(effect.values[p]);
    }
    return Json{{"name", effect_name(effect)}, {"parameters", values}};
  });
}

Json loss_json(const Loss& loss, const MeasuredData& data) {
  return {{"routing", data.routings[loss.routing].word},
          {"held", held_fingers(loss.grasp)},
          {"direction", direction_field(loss.direction)},
          {"from", segment_name(loss.high)},
          {"to", segment_name(loss.low)},
          {"over",
           list_json(loss.over, [](ContactKind kind) { return Json(contact_kind_name(kind)); })},
          {"rows", loss.rows},
          {"measured", number(loss.measured)},
          {"deviation", number(loss.deviation)},
          {"before", number(loss.before)},
          {"after", number(loss.after)},
          {"stands_apart", loss.stands_apart}};
}

Json without_apart_json(const WithoutApart& without, const MeasuredData& data) {
  Json causes = effects_json(without.model);
  for (std::size_t e = 0; e < without.intervals.size(); ++e) {
    causes[e]["intervals"] = list_json(without.intervals[e], [](const ParameterInterval& interval) {
      return Json::array({number(interval.low), number(interval.high)});
    });
  }
  return {{"left_out", list_json(without.left_out,
                                 [&](const Cell& cell) {
                                   return Json{{"line", data.readings[cell.reading].line},
                                               {"channel", data.channels[cell.channel].name}};
                                 })},
          {"causes", causes},
          {"share_error", value_or_null(without.share_error, number)}};
}

Json published_json(const PublishedModel& model, const std::vector<Loss>& losses) {
  return {{"name", model.name},
          {"mu", model.mu},
          {"error", number(model.error)},
          {"equations_error", number(model.equations)},
          {"lines", list_json(model.lines,
                              [](const PublishedLine& line) {
                                return Json{{"source", line.source},
                                            {"shares", line.shares},
                                            {"error", number(line.error)},
                                            {"equations_error", number(line.equations)}};
                              })},
          {"other_losses", list_json(model.losses, [&](const PublishedLoss& loss) {
             return Json{{"from", segment_name(losses[loss.loss].high)},
                         {"to", segment_name(losses[loss.loss].low)},
                         {"loss", loss.loss},
                         {"printed", number(loss.printed)},
                         {"equations", number(loss.equations)},
                         {"sheaths", loss.sheaths},
                         {"sheaths_drawn", loss.sheaths_drawn}};
           })}};
}

void add_evidence(Json& json, const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  json["held_out_by_run"] = list_json(result.run_gains, [&](const RunGain& gain) {
    return Json{{"run", report.data.runs[gain.run]},
                {"values", gain.cells},
                {"rms_before", number(gain.rms_before_N)},
                {"rms_after", number(gain.rms_after_N)},
                {"rms_noise", number(gain.rms_noise_N)}};
  });
  json["noise_limit"] = value_or_null(result.noise_limit, noise_limit_json);
  json["not_confirmed"] = result.not_confirmed;
  json["folds"] = result.folds;
  json["apart"] = list_json(result.apart, [](const RunsApart& apart) {
    return Json{{"runs", apart.runs},
                {"text", apart.text},
                {"size", number(apart.effect.values.front())},
                {"evidence", number(apart.evidence)}};
  });
  json["weighed"] = list_json(result.weighed, [](const WeighedCauses& cause) {
    return Json{{"name", joined_causes(cause.causes)},
                {"log_likelihood_gain", number(cause.gain)},
                {"held_out", value_or_null(cause.held_out, held_out_json)}};
  });
  json["structure"] = list_json(result.structure, [&](const StructureFinding& finding) {
    return Json{{"about", finding.about},
                {"rms", number(structure_N(report, finding))},
                {"statistic", number(finding.statistic)},
                {"p_value", finding.p_value}};
  });
  json["share_errors"] = share_errors_json(report);
  json["left_out_runs"] = list_json(result.left_out, [&](const LeftOutRun& run) {
    return Json{{"run", report.data.runs[run.run]}, {"causes", effects_json(run.model)}};
  });
  json["losses"] =
      list_json(result.losses, [&](const Loss& loss) { return loss_json(loss, report.data); });
  json["without_apart"] = value_or_null(
      report.result.without_apart,
      [&](const WithoutApart& without) { return without_apart_json(without, report.data); });
  json["published"] = list_json(report.published, [&](const PublishedModel& model) {
    return published_json(model, report.result.losses);
  });
  json["noise"] = noise_json(report);
  json["mountings"] = mountings_json(result);
  json["row_scatter"] = row_scatter_json(result);
  json["coefficients"] = coefficients_json(result);
  json["by_group"] = by_group_json(report);
  json["ranking"] = value_or_null(report.ranking, [](const CatalogueRanking& ranking) {
    return Json{
        {"changes", ranking.changes()}, {"before", ranking.before}, {"after", ranking.after}};
  });
}

}  // namespace

std::string diagnosis_json(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  Json json;
  add_findings(json, report);
  add_evidence(json, report);
  json["simulated"] = report.data.simulated;
  json["too_few"] = result.verdict == Verdict::too_few;
  json["rows"] = result.rows;
  json["runs"] = result.runs;
  json["held_out_runs"] = result.held_out_runs;
  json["dropped_duplicates"] = result.dropped_duplicates;
  json["thinned_rows"] = result.thinned_rows;
  json["calibration"] = {{"replicates", report.settings.replicates},
                         {"family_wise_alpha", report.settings.alpha},
                         {"p_value", result.p_value},
                         {"structure_p_value", result.structure_p_value}};
  json["notes"] = notes_json(result.notes);
  json["seconds"] = report.seconds;
  json["settings"] = diagnosis_settings_json(report);
  json["version"] = version_json();
  return print_stamped(std::move(json));
}

std::string diagnosis_residuals_csv(const DiagnosisReport& report) {
  const MeasuredData& data = report.data;
  std::string csv = data.simulated ? fmt::format("# {}\n", simulated_text) : "";
  csv +=
      "line,run,routing,held,direction,channel,held_out,measured_N,before_N,after_N,deviation_N,"
      "residual_before,residual_after,left_out_N";
  csv += group_heading(data) + "\n";
  for (const ComparedCell& compared : report.result.cells) {
    const Reading& reading = data.readings[compared.cell.reading];
    const std::string left_out = compared.left_out_N ? fmt::format("{}", *compared.left_out_N) : "";
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}{}\n", reading.line,
                       csv_field(data.runs[reading.run]), data.routings[reading.routing].word,
                       held_field(reading.grasp), direction_field(reading.direction),
                       data.channels[compared.cell.channel].name, compared.held_out,
                       compared.cell.measured_N, compared.before_N, compared.after_N,
                       compared.deviation_N, compared.residual_before, compared.residual_after,
                       left_out, group_field(data, reading));
  }
  return csv;
}

}  // namespace reeve::reports
