#include "reports/diagnosis/diagnosis_groups.hpp"

#include <fmt/format.h>

#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::reports {
namespace {

EstimatedParameter as_parameter(const EstimatesByGroup& of, const GroupEstimate& estimate) {
  EstimatedParameter parameter;
  parameter.name = of.parameter;
  parameter.unit = of.unit;
  parameter.value = estimate.value;
  parameter.low = estimate.interval.low;
  parameter.high = estimate.interval.high;
  return parameter;
}

std::string group_text(const EstimatesByGroup& of, const GroupEstimate& one,
                       const std::string& name) {
  const EstimatedParameter parameter = as_parameter(of, one);
  return fmt::format("{} ({} to {}) in {}", estimate(parameter, parameter.value),
                     estimate(parameter, parameter.low), estimate(parameter, parameter.high), name);
}

// A group whose scatter too few readings tell is taken to be as all (model/scatter_fit.hpp).
bool is_told(double scale) { return scale != 1; }

// A list of so many is no sentence any more; the JSON has all.
constexpr std::size_t most_told = 6;

}  // namespace

std::vector<std::string> group_sentences(const DiagnosisReport& report) {
  std::vector<std::string> sentences;
  for (const EstimatesByGroup& of : report.result.by_group) {
    if (!of.differs) continue;
    std::vector<std::string> told;
    for (const GroupEstimate& one : of.groups) {
      if (told.size() == most_told && one.group != of.farthest) continue;
      told.push_back(group_text(of, one, report.data.groups[one.group]));
    }
    const std::size_t left = of.groups.size() - told.size();
    const std::string more = left == 0 ? "" : fmt::format(" ({} more groups)", left);
    sentences.push_back(fmt::format(
        "By group, each fitted by itself, {} differs: {} = {}{}; {} stands out ({})", of.cause,
        of.parameter, fmt::join(told, ", "), more, report.data.groups[of.farthest],
        p_text(of.p_value, report.settings.replicates)));
  }
  return sentences;
}

std::string group_scatter_sentence(const DiagnosisReport& report) {
  const std::vector<double>& scales = report.result.noise.of_group;
  if (scales.empty()) return "";
  std::vector<std::string> told;
  std::size_t left = 0;
  for (std::size_t g = 0; g < scales.size(); ++g) {
    if (!is_told(scales[g]) || told.size() == most_told) {
      ++left;
    } else {
      told.push_back(fmt::format("{:.2g} in {}", scales[g], report.data.groups[g]));
    }
  }
  return fmt::format("Readings scatter otherwise in each group, by so many times the noise: {}{}.",
                     fmt::join(told, ", "),
                     left == 0 ? "" : fmt::format(" ({} more groups)", left));
}

Json by_group_json(const DiagnosisReport& report) {
  Json json = Json::array();
  for (const EstimatesByGroup& of : report.result.by_group) {
    Json groups = Json::array();
    for (const GroupEstimate& one : of.groups) {
      groups.push_back({{"group", report.data.groups[one.group]},
                        {"value", one.value},
                        {"low", one.interval.low},
                        {"high", one.interval.high}});
    }
    json.push_back({{"name", of.cause},
                    {"parameter", of.parameter},
                    {"unit", of.unit},
                    {"groups", std::move(groups)},
                    {"farthest", report.data.groups[of.farthest]},
                    {"p_value", of.p_value},
                    {"differs", of.differs}});
  }
  return json;
}

Json noise_of_groups_json(const DiagnosisReport& report) {
  Json json = Json::array();
  const std::vector<double>& scales = report.result.noise.of_group;
  for (std::size_t g = 0; g < scales.size(); ++g) {
    json.push_back({{"group", report.data.groups[g]},
                    {"factor", is_told(scales[g]) ? Json(scales[g]) : Json()}});
  }
  return json;
}

}  // namespace reeve::reports
