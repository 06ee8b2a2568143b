// docs/json.md has every key and every column.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "search/evaluate/objectives.hpp"
#include "tests/golden/json_keys.hpp"

namespace reeve::testing {
namespace {

// All keys that do not depend on the input.
void collect(const Json& json, std::set<std::string>& keys) {
  for (const auto& [key, value] : json.items()) {
    if (json.is_object()) keys.insert(key);
    if (value.is_structured() && key != "tensions" && key != "shares" && key != "rejected") {
      collect(value, keys);
    }
  }
}

// The columns of an objective's band have one line for all objectives.
std::string as_documented(const std::string& name) {
  for (const std::string suffix : {"_median", "_p5", "_p95"}) {
    for (const ObjectiveRow& row : objective_table()) {
      if (name == row.name + suffix) return "<objective>" + suffix;
    }
  }
  return name;
}

TEST(TheJsonDocument, NamesEveryKeyAndEveryColumn) {
  const std::string document =
      read_text(std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "json.md");
  const TemporaryFolder folder;
  const std::string hardware =
      (std::filesystem::path(REEVE_CATALOG_DIR) / "hardware" / "example.toml").string();
  std::set<std::string> names;
  collect(json_of({"show", "TR1"}), names);
  collect(json_of({"show", "LuffTackle"}), names);
  collect(json_of({"rank", "--catalog", "--uncertainty", "--draws", "5"}), names);
  collect(json_of({"rank", "--catalog", "--hardware", hardware}), names);
  collect(json_of({"rank", "TR3", "TR7", "--margin"}), names);
  collect(json_of({"rank", "TR3", "TR7", "--sweep", "mu=0.1..0.2"}), names);
  collect(with_page({"rank", "TR5", "TR7", "--data", readings}), names);
  collect(json_of({"rank", "TR5", "--model", example_model}), names);
  collect(summary(), names);
  const std::string prices =
      (std::filesystem::path(REEVE_CATALOG_DIR) / "prices" / "example.toml").string();
  collect(summary({"--cost", prices}), names);
  collect(summary({"--constraint", "sheaths<=0"}), names);
  collect(json_of({"count"}), names);
  collect(json_of({"check"}), names);
  collect(json_of({"compare", readings}), names);
  collect(json_of(power), names);
  collect(json_of(sizing), names);
  collect(json_of({"import", logged}), names);
  collect(json_of({"diagnose", diagnosed + "cause.csv"}), names);
  collect(json_of({"diagnose", seeds_readings}), names);
  const std::string csv =
      reeve({"rank", "--catalog", "--uncertainty", "--draws", "5", "--format", "csv"}).out;
  reeve({"compare", readings, "--out", folder.path().string()});
  const std::string residuals = read_text(folder.path() / "residuals.csv");
  const std::size_t second = residuals.find('\n') + 1;  // below a comment
  for (const std::string& header :
       {csv.substr(0, csv.find('\n')),
        residuals.substr(second, residuals.find('\n', second) - second)}) {
    std::istringstream columns(header);
    for (std::string column; std::getline(columns, column, ',');) names.insert(column);
  }
  EXPECT_GT(names.size(), 60U);
  for (const std::string& name : names) {
    EXPECT_NE(document.find('`' + as_documented(name) + '`'), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace reeve::testing
