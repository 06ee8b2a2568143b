// One run of `reeve explore` into a folder of its own, and what the commands' tests share.
#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
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

// The rows below the header, by its columns.
inline std::vector<std::map<std::string, std::string>> rows_of(const std::string& csv) {
  const auto fields = [](const std::string& line) {
    std::vector<std::string> list;
    std::istringstream in(line + ",");
    for (std::string field; std::getline(in, field, ',');) list.push_back(field);
    return list;
  };
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = fields(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> values = fields(line);
    EXPECT_EQ(values.size(), names.size()) << line;
    rows.emplace_back();
    for (std::size_t i = 0; i < names.size(); ++i) rows.back()[names[i]] = values[i];
  }
  return rows;
}

// Text, since the rest must be the same byte for byte.
// Times, and the work of one run.
inline std::string without_times(const std::string& summary) {
  std::string result;
  std::istringstream lines(summary);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("\"seconds\"") == std::string::npos &&
        line.find("\"designs_per_second\"") == std::string::npos &&
        line.find("_visited\"") == std::string::npos) {
      result += line + '\n';
    }
  }
  return result;
}

// Every file below a folder that is there, but for the seconds that it took.
inline std::map<std::string, std::string> files_below(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const std::string text = read_text(entry.path());
    files[std::filesystem::relative(entry.path(), folder)] =
        entry.path().extension() == ".json" ? without_times(text) : text;
  }
  return files;
}

// A Python that has the modules, "" if there is none. Debian's own packages are for Debian's own
// Python, and another may stand before it.
inline std::string python_with(const std::string& modules) {
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    if (run_process({python, "-c", "import " + modules}).exit_code == 0) return python;
  }
  return "";
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
