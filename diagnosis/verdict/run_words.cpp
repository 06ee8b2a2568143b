#include "diagnosis/verdict/run_words.hpp"

#include <algorithm>

namespace reeve::diagnosis {

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

std::string runs_text(const std::vector<std::size_t>& runs, const MeasuredData& data) {
  if (runs.size() > 1 && runs.size() == data.runs.size()) return "all runs";
  std::vector<std::string> names;
  for (const std::size_t run : runs) names.push_back(data.runs[run]);
  const bool say_it = std::all_of(names.begin(), names.end(), [](const std::string& name) {
    return name.starts_with("run") || name.starts_with("Run");
  });
  const std::string what = say_it ? "" : names.size() == 1 ? "run " : "runs ";
  const bool in_a_row = runs.back() - runs.front() + 1 == runs.size();
  return what +
         (runs.size() > 2 && in_a_row ? names.front() + " to " + names.back() : listed(names));
}

}  // namespace reeve::diagnosis
