#include <fmt/format.h>

#include <array>

#include "reports/diagnosis/diagnosis_evidence.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::reports {
namespace {

constexpr std::array all_kinds{Mounted::sheath, Mounted::tube, Mounted::bearing, Mounted::gain,
                               Mounted::zero};

const char* of_what(Mounted kind) {
  // In the order of Mounted.
  constexpr std::array names{"the sheaths' exponents", "the tubes' exponents",
                             "the bearings' exponents", "the channels' gains",
                             "the channels' zeros (of the median reading)"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string percent_in(const MountingScatter& scatter, Mounted kind) {
  return fmt::format("{} in {}",
                     fine_percent_text(scatter.relative[static_cast<std::size_t>(kind)]),
                     of_what(kind));
}

bool is_beyond_belief(const MountingScatter& scatter, Mounted kind) {
  const auto k = static_cast<std::size_t>(kind);
  return scatter.present[k] && believed(scatter).relative[k] < scatter.relative[k];
}

bool is_assumed(const MountingScatter& scatter, Mounted kind) {
  return scatter.present[static_cast<std::size_t>(kind)] && !is_told(scatter, kind) &&
         !is_beyond_belief(scatter, kind) && !scatter.given;
}

// The scatter of each kind of which that is so, in per cent.
std::vector<std::string> percents(const MountingScatter& scatter,
                                  bool (*is_so)(const MountingScatter&, Mounted)) {
  std::vector<std::string> texts;
  for (const Mounted kind : all_kinds) {
    if (is_so(scatter, kind)) texts.push_back(percent_in(scatter, kind));
  }
  return texts;
}

bool is_known(const MountingScatter& scatter, Mounted kind) {
  return scatter.present[static_cast<std::size_t>(kind)] && !is_assumed(scatter, kind);
}

std::string known_sentence(const DiagnosisResult& result) {
  const MountingScatter& scatter = result.mounting;
  const std::vector<std::string> known = percents(scatter, is_known);
  if (known.empty()) return "";
  const std::string by =
      scatter.given ? "by --mounting-scatter"
                    : fmt::format("by {} mounted again{}", scatter.mounted_again,
                                  scatter.is_bounded ? ", which alone exceeds published rigs" : "");
  const std::string mountings =
      fmt::format("Mountings differ by {} ({})", fmt::join(known, ", "), by);
  if (result.noise.source == NoiseSource::known) return mountings + ".";
  return fmt::format("{}; readings of one mounting repeat to {}.", mountings,
                     fine_percent_text(result.noise.relative));
}

std::string assumed_sentence(const MountingScatter& scatter) {
  const std::vector<std::string> assumed = percents(scatter, is_assumed);
  if (assumed.empty()) return "";
  return fmt::format(
      "Mounting scatter is assumed: {} ({}). Set it with --mounting-scatter.",
      fmt::join(assumed, ", "),
      scatter.mounted_again == 0 ? "no routing is mounted twice" : "too few repeated mountings");
}

Json coefficient_json(const CalibratedCoefficient& coefficient) {
  const EstimatedParameter& parameter = coefficient.parameter;
  return {{"name", coefficient.name},
          {"parameter", parameter.name},
          {"value", parameter.value},
          {"low", parameter.low},
          {"high", parameter.high},
          {"at_bound", parameter.at_bound},
          {"hardware", value_or_null(parameter.nominal, number)},
          {"p_value", coefficient.p_value},
          {"differs", coefficient.differs}};
}

}  // namespace

std::vector<std::string> scatter_sentences(const DiagnosisResult& result) {
  std::vector<std::string> sentences;
  if (result.row_scatter) sentences.push_back(row_sentence(result));
  for (std::string sentence : {known_sentence(result), assumed_sentence(result.mounting)}) {
    if (!sentence.empty()) sentences.push_back(std::move(sentence));
  }
  return sentences;
}

std::string row_sentence(const DiagnosisResult& result) {
  constexpr double most_of_a_motor = 0.3;
  if (!result.row_scatter) return "";
  const double off = result.row_scatter->relative;
  const std::string together = fmt::format(
      "Residuals of a row are correlated, as if the motor tension were off by {} from row to row: ",
      fine_percent_text(off));
  if (off > most_of_a_motor) {
    return together +
           "more than any motor's; look whether directions, grasps and columns are what the file says.";
  }
  return together +
         fmt::format(
             "if it is a motor current or a coarse sensor, say so with --noise motor={:.2g}%.",
             100 * off);
}

bool drowns_in_noise(const DiagnosisResult& result) {
  constexpr double most_of_any_sensor = 0.5;
  return result.noise.source != NoiseSource::known && result.noise.relative > most_of_any_sensor;
}

std::string beyond_belief_sentence(const DiagnosisResult& result) {
  if (drowns_in_noise(result)) {
    return fmt::format(
        "Check this first: it takes readings that scatter by {:.0f} %, more than those of any force "
        "sensor. Are routings, grasps, directions, units and columns what the file says?",
        100 * result.noise.relative);
  }
  const std::vector<std::string> beyond = percents(result.mounting, is_beyond_belief);
  if (beyond.empty()) return "";
  return fmt::format(
      "Check this first: it takes mountings that differ by {}, more than those of any rig in print. "
      "Are routings, grasps, directions and columns what the file says? --mounting-scatter says "
      "what you know.",
      fmt::join(beyond, ", "));
}

Json row_scatter_json(const DiagnosisResult& result) {
  return value_or_null(result.row_scatter, [](const RowScatter& scatter) {
    return Json{{"relative", scatter.relative},
                {"log_likelihood_gain", scatter.log_likelihood_gain}};
  });
}

Json mountings_json(const DiagnosisResult& result) {
  const MountingScatter& scatter = result.mounting;
  Json json{{"mounted_again", scatter.mounted_again},
            {"given", scatter.given},
            {"bounded", scatter.is_bounded}};
  for (const Mounted kind : all_kinds) {
    const auto k = static_cast<std::size_t>(kind);
    json[mounted_name(kind)] = scatter.present[k] ? Json{{"relative", scatter.relative[k]},
                                                         {"told_by", scatter.told_by[k]},
                                                         {"assumed", is_assumed(scatter, kind)}}
                                                  : Json(nullptr);
  }
  return json;
}

std::vector<std::string> not_named_sentences(const DiagnosisResult& result) {
  std::vector<std::string> sentences;
  for (const std::string& name : result.not_confirmed) {
    sentences.push_back(
        fmt::format("{} is not named: it is found in all readings, but not confirmed by models "
                    "that have not seen some of the runs.",
                    name));
  }
  return sentences;
}

// An interval may leave the hardware's value out, and the coefficient be no named cause all the
// same: that is asked at a stricter level, over all coefficients together.
std::string beside_hardware(const CalibratedCoefficient& coefficient) {
  const EstimatedParameter& parameter = coefficient.parameter;
  const std::string hardware = estimate(parameter, *parameter.nominal);
  if (coefficient.differs) return fmt::format("differs from the nominal value ({})", hardware);
  const bool inside = parameter.low <= *parameter.nominal && *parameter.nominal <= parameter.high;
  if (inside) return fmt::format("agrees with the nominal value ({})", hardware);
  return fmt::format(
      "perhaps differs from the nominal value ({}), too little to name it (p = {:.2g})", hardware,
      coefficient.p_value);
}

std::vector<std::string> coefficient_sentences(const DiagnosisResult& result) {
  std::vector<std::string> sentences;
  for (const CalibratedCoefficient& coefficient : result.calibration) {
    const EstimatedParameter& parameter = coefficient.parameter;
    sentences.push_back(fmt::format("{}: {} = {} ({}{}), {}", coefficient.name, parameter.name,
                                    estimate(parameter, parameter.value), interval_text(parameter),
                                    parameter.at_bound ? ", at the limit of the search" : "",
                                    beside_hardware(coefficient)));
  }
  return sentences;
}

Json coefficients_json(const DiagnosisResult& result) {
  return list_json(result.calibration, coefficient_json);
}

}  // namespace reeve::reports
