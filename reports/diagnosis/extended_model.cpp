#include <fmt/format.h>

#include "catalog/model_file.hpp"
#include "core/version.hpp"
#include "readings/csv.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"

namespace reeve::reports {

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
