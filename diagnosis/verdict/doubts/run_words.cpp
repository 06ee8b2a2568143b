#include "diagnosis/verdict/doubts/run_words.hpp"

#include <fmt/format.h>

namespace reeve::diagnosis {

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

std::string runs_text(const std::vector<std::size_t>& runs, const MeasuredData& data) {
  if (runs.size() == 1) return "run " + data.runs[runs.front()];
  if (runs.size() == data.runs.size()) return "all runs";
  if (runs.size() > 2 && runs.back() - runs.front() + 1 == runs.size()) {
    return fmt::format("runs {} to {}", data.runs[runs.front()], data.runs[runs.back()]);
  }
  std::vector<std::string> names;
  for (const std::size_t run : runs) names.push_back(data.runs[run]);
  return "runs " + listed(names);
}

}  // namespace reeve::diagnosis
