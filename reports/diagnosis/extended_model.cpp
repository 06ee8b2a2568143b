#include <fmt/format.h>

#include "catalog/rig/model_file.hpp"
#include "core/version.hpp"
#include "diagnosis/data/csv.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"
#include "reports/results/data_text.hpp"

namespace reeve::reports {

std::string extended_model_toml(const DiagnosisReport& report,
                                const UncertaintyRanges& uncertainty) {
  const DiagnosisResult& result = report.result;
  const Version build = version();
  std::vector<std::string> lines{fmt::format("Extended by reeve {} from the readings in {}",
                                             build.number, one_line(report.data.file))};
  if (report.data.simulated) lines.push_back(fmt::format("The data are {}.", simulated_text));
  lines.push_back(fmt::format("Verdict: {}", verdict_name(result.verdict)));
  for (const NamedCause& cause : result.causes) lines.push_back(cause_text(cause));
  for (const auto& names : result.indistinguishable) {
    lines.push_back(fmt::format("The data cannot tell apart: {}", fmt::join(names, ", ")));
  }
  return model_toml(result.model, lines, uncertainty);
}

}  // namespace reeve::reports
