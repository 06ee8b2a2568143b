// docs/schema has every key, and docs/json.md every column.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "search/evaluate/objectives.hpp"
#include "tests/golden/json_keys.hpp"

namespace reeve::testing {
namespace {

// True for an object whose keys depend on the input; python/tests/test_schema.py checks its values.
bool is_map(const std::string& key, const Json& value) {
  static const std::set<std::string> maps{
      "tensions",   "shares", "rejected", "bands",      "weights",    "gains",    "losses",
      "objectives", "values", "others",   "conditions", "parameters", "intervals"};
  return value.is_object() && maps.contains(key);
}

// All keys that do not depend on the input.
void collect(const Json& json, std::set<std::string>& keys) {
  for (const auto& [key, value] : json.items()) {
    if (json.is_object()) keys.insert(key);
    if (value.is_structured() && !is_map(key, value)) collect(value, keys);
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

std::string all_schemas() {
  std::string text;
  const auto folder = std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "schema";
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    text += read_text(file.path());
  }
  return text;
}

TEST(TheJsonDocument, NamesEveryColumnAndTheSchemasEveryKey) {
  const std::string document =
      read_text(std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "json.md");
  const std::string schemas = all_schemas();
  const TemporaryFolder folder;
  const std::string hardware =
      (std::filesystem::path(REEVE_CATALOG_DIR) / "hardware" / "example.toml").string();
  std::set<std::string> keys_seen;
  collect(json_of({"show", "TR1"}), keys_seen);
  collect(json_of({"show", "LuffTackle"}), keys_seen);
  collect(json_of({"rank", "--catalogue", "--uncertainty", "--draws", "5"}), keys_seen);
  collect(json_of({"rank", "--catalogue", "--hardware", hardware}), keys_seen);
  collect(json_of({"rank", "TR3", "TR7", "--margin"}), keys_seen);
  collect(json_of({"rank", "TR3", "TR7", "--sweep", "mu=0.1..0.2"}), keys_seen);
  collect(with_page({"rank", "TR5", "TR7", "--data", readings}), keys_seen);
  collect(json_of({"rank", "TR5", "--model", example_model}), keys_seen);
  collect(summary(), keys_seen);
  const std::string prices =
      (std::filesystem::path(REEVE_CATALOG_DIR) / "prices" / "example.toml").string();
  collect(summary({"--cost", prices}), keys_seen);
  collect(summary({"--constraint", "sheaths<=0"}), keys_seen);
  collect(json_of({"count"}), keys_seen);
  collect(json_of({"check"}), keys_seen);
  collect(json_of({"compare", readings}), keys_seen);
  collect(json_of(power), keys_seen);
  collect(json_of(sizing), keys_seen);
  collect(json_of({"import", logged}), keys_seen);
  collect(json_of({"diagnose", diagnosed + "cause.csv"}), keys_seen);
  collect(json_of({"diagnose", seeds_readings}), keys_seen);
  const std::string csv =
      reeve({"rank", "--catalogue", "--uncertainty", "--draws", "5", "--format", "csv"}).out;
  reeve({"compare", readings, "--out", folder.path().string()});
  const std::string residuals = read_text(folder.path() / "residuals.csv");
  const std::size_t second = residuals.find('\n') + 1;  // below a comment
  std::set<std::string> columns_seen;
  for (const std::string& header :
       {csv.substr(0, csv.find('\n')),
        residuals.substr(second, residuals.find('\n', second) - second)}) {
    std::istringstream columns(header);
    for (std::string column; std::getline(columns, column, ',');) columns_seen.insert(column);
  }
  EXPECT_GT(keys_seen.size(), 60U);
  for (const std::string& key : keys_seen) {
    EXPECT_NE(schemas.find('"' + key + "\": {"), std::string::npos) << key;
  }
  EXPECT_GT(columns_seen.size(), 60U);
  for (const std::string& column : columns_seen) {
    EXPECT_NE(document.find('`' + as_documented(column) + '`'), std::string::npos) << column;
  }
}

}  // namespace
}  // namespace reeve::testing
