// One run of `reeve explore` into a folder of its own, and what the commands' tests share.
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/process.hpp"
#include "tests/support/sanitizers.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {

using Json = nlohmann::ordered_json;

inline const std::string readings = std::string(REEVE_SOURCE_DIR) + "/tests/golden/readings.csv";

inline ProcessOptions disturbed(int signal, std::function<bool(const RunningProcess&)> when) {
  ProcessOptions options{.disturbance = Disturbance{signal, std::move(when)}};
  return options;
}

// Adds --parts full if no parts are named: its designs do not change with what the default allows.
inline Arguments with_full_parts(Arguments arguments) {
  const bool names_parts =
      std::any_of(arguments.begin(), arguments.end(),
                  [](const std::string& each) { return each.starts_with("--parts"); });
  if (!names_parts) arguments.insert(arguments.end(), {"--parts", "full"});
  return arguments;
}

struct Explored {
  TemporaryFolder folder;
  ProcessResult result;

  explicit Explored(Arguments arguments, ProcessOptions options = {}) {
    run(std::move(arguments), std::move(options));
  }

  // Again, into the same folder.
  void run(Arguments arguments, ProcessOptions options = {}) {
    arguments = with_full_parts(std::move(arguments));
    arguments.insert(arguments.begin(), {"explore", "--out", "out"});
    options.directory = folder.path();
    result = reeve(arguments, options);
  }

  std::filesystem::path out() const { return folder.path() / "out"; }
  std::string file(const std::string& name) const { return read_text(out() / name); }
  Json summary() const { return Json::parse(file("summary.json")); }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(out())) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
};

// The third column of each line after the header. Names with commas are none of ours.
inline std::vector<std::string> words(const std::string& csv) {
  std::vector<std::string> result;
  std::istringstream lines(csv);
  bool in_header = true;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    if (!in_header) {
      const std::size_t begin = line.find(',', line.find(',') + 1) + 1;
      result.push_back(line.substr(begin, line.find(',', begin) - begin));
    }
    in_header = false;
  }
  return result;
}

// Text, since the rest must be the same byte for byte.
inline std::string without_times(const std::string& summary) {
  std::string result;
  std::istringstream lines(summary);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("\"seconds\"") == std::string::npos &&
        line.find("\"designs_per_second\"") == std::string::npos) {
      result += line + '\n';
    }
  }
  return result;
}

// The blocks of a document in a language, as they stand there.
inline std::vector<std::string> blocks_of(const std::string& document,
                                          const std::string& language) {
  const std::string text = read_text(std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / document);
  const std::string opening = "\n```" + language + "\n";
  std::vector<std::string> blocks;
  for (std::size_t at = text.find(opening); at != std::string::npos; at = text.find(opening, at)) {
    at += opening.size();
    blocks.push_back(text.substr(at, text.find("```", at) - at));
  }
  return blocks;
}

}  // namespace reeve::testing
