// Compares what users' scripts read with files in expected/: keys, their order and strings exactly,
// numbers to within 1e-9. Seconds, rates, the version and what hangs on it are left out.
//
// REEVE_UPDATE_GOLDEN=1 in the environment rewrites the files instead; look at the difference
// before you keep it, and at docs/schema.
#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {

using Json = nlohmann::ordered_json;

inline std::filesystem::path file_of(const std::string& name) {
  return std::filesystem::path(REEVE_SOURCE_DIR) / "tests" / "golden" / "expected" / name;
}

inline bool updating() {
  const char* value = std::getenv("REEVE_UPDATE_GOLDEN");
  return value != nullptr && std::string(value) == "1";
}

// Relative; or the rounding of the objectives, which a last bit can tip over.
inline constexpr double computed = 1e-9;
// What a minimiser finds: where the minimum is flat, a last bit moves it further.
inline constexpr double fitted = 1e-5;

inline bool near(double a, double b, double tolerance = computed) {
  return std::abs(a - b) <= std::max(tolerance * std::max(std::abs(a), std::abs(b)), 1.5e-10);
}

inline void leave_out_what_varies(Json& json) {
  for (const char* key : {"seconds", "designs_per_second", "exploration", "result_id", "version"}) {
    if (json.contains(key)) json[key] = "varies";
  }
}

inline std::string kind(const Json& json) {
  return json.is_number_integer() ? "integer" : json.type_name();
}

inline void compare(const Json& actual, const Json& expected, const std::string& path,
                    double tolerance) {
  if (kind(actual) != kind(expected)) {
    ADD_FAILURE() << path << ": " << actual.dump() << ", expected " << expected.dump();
  } else if (actual.is_number()) {
    EXPECT_TRUE(near(actual, expected, tolerance))
        << path << ": " << actual.dump() << ", expected " << expected.dump();
  } else if (actual.is_structured()) {
    ASSERT_EQ(actual.size(), expected.size()) << path;
    for (auto a = actual.begin(), e = expected.begin(); a != actual.end(); ++a, ++e) {
      const std::string at =
          actual.is_object() ? a.key() : std::to_string(std::distance(actual.begin(), a));
      if (actual.is_object()) {
        EXPECT_EQ(a.key(), e.key()) << path;
      }
      compare(*a, *e, path + "/" + at, tolerance);
    }
  } else {
    EXPECT_EQ(actual, expected) << path;
  }
}

inline void expect_json(const std::string& text, const std::string& name,
                        double tolerance = computed) {
  Json actual = Json::parse(text);
  leave_out_what_varies(actual);
  if (updating()) std::ofstream(file_of(name)) << actual.dump(2) << '\n';
  compare(actual, Json::parse(read_text(file_of(name))), name, tolerance);
}

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) parts.push_back(part);
  return parts;
}

inline bool read_number(const std::string& text, double& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

inline void expect_same_field(const std::string& actual, const std::string& expected,
                              double tolerance) {
  double a = 0;
  double e = 0;
  if (read_number(actual, a) && read_number(expected, e)) {
    EXPECT_TRUE(near(a, e, tolerance)) << actual << ", expected " << expected;
  } else {
    EXPECT_EQ(actual, expected);
  }
}

inline void expect_csv(const std::string& text, const std::string& name,
                       double tolerance = computed) {
  if (updating()) std::ofstream(file_of(name)) << text;
  const std::vector<std::string> lines = split(text, '\n');
  const std::vector<std::string> expected = split(read_text(file_of(name)), '\n');
  ASSERT_EQ(lines.size(), expected.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    SCOPED_TRACE(name + ":" + std::to_string(i + 1));
    const std::vector<std::string> fields = split(lines[i], ',');
    const std::vector<std::string> expected_fields = split(expected[i], ',');
    ASSERT_EQ(fields.size(), expected_fields.size());
    for (std::size_t k = 0; k < fields.size(); ++k) {
      expect_same_field(fields[k], expected_fields[k], tolerance);
    }
  }
}

// The last column of tables in a folder, which hangs on the version.
inline std::string without_id(const std::string& csv) {
  return std::regex_replace(csv, std::regex(",[0-9a-f]{16}\n"), ",varies\n");
}

// Run in the folder of the sources: a file's name is printed as it was given.
inline std::string output_of(const std::vector<std::string>& arguments) {
  ProcessOptions options;
  options.directory = REEVE_SOURCE_DIR;
  const ProcessResult result = reeve(arguments, options);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  return result.out;
}

inline void expect_text(const std::string& text, const std::filesystem::path& file) {
  if (updating()) std::ofstream(file, std::ios::binary) << text;
  EXPECT_EQ(text, read_text(file)) << file;
}

}  // namespace reeve::testing
