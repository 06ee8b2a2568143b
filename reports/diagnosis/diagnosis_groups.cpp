#include <fmt/format.h>

#include <algorithm>

#include "reports/diagnosis/diagnosis_evidence.hpp"
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
  return fmt::format("{} ({}) in {}", estimate(parameter, parameter.value),
                     interval_text(parameter), name);
}

// No smaller than that of any other finding: the t distribution of few readings is no truth to so
// many digits.
std::string chance_text(const EstimatesByGroup& of, const DiagnosisReport& report) {
  const std::size_t replicates = report.settings.replicates;
  const double least = 1 / static_cast<double>(replicates + 1);
  return p_text(std::max(of.p_value, least), replicates);
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
    sentences.push_back(
        fmt::format("By group, each fitted by itself, {} differs: {} = {}{}; {} stands out ({})",
                    of.cause, of.parameter, fmt::join(told, ", "), more,
                    report.data.groups[of.farthest], chance_text(of, report)));
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

Table group_table(const DiagnosisReport& report) {
  Table table{{text_column("what"), text_column("group"), number_column("value"),
               number_column("95 % interval"), text_column("remark")},
              {}};
  for (const EstimatesByGroup& of : report.result.by_group) {
    const std::string unit = of.unit == "1" ? "" : ", " + of.unit;
    for (const GroupEstimate& one : of.groups) {
      const EstimatedParameter parameter = as_parameter(of, one);
      const bool stands_out = of.differs && one.group == of.farthest;
      table.add({fmt::format("{}, {}{}", of.cause, of.parameter, unit),
                 report.data.groups[one.group], estimate(parameter, parameter.value),
                 interval_text(parameter),
                 stands_out ? fmt::format("stands out ({})", chance_text(of, report)) : ""});
    }
  }
  return table;
}

Json by_group_json(const DiagnosisReport& report) {
  const auto of_group = [&](const GroupEstimate& one) {
    return Json{{"group", report.data.groups[one.group]},
                {"value", one.value},
                {"low", one.interval.low},
                {"high", one.interval.high}};
  };
  return list_json(report.result.by_group, [&](const EstimatesByGroup& of) {
    return Json{{"name", of.cause},
                {"parameter", of.parameter},
                {"unit", of.unit},
                {"groups", list_json(of.groups, of_group)},
                {"farthest", report.data.groups[of.farthest]},
                {"p_value", of.p_value},
                {"differs", of.differs}};
  });
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
