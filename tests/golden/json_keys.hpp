// The JSON of each command and its keys, for tests of the interface.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {

using Json = nlohmann::ordered_json;

inline const std::string example_model =
    (std::filesystem::path(REEVE_CATALOG_DIR) / "model" / "example.toml").string();

inline const std::string objectives =
    " uniformity efficiency force_transmission jams jams_all sheaths pulleys knots travel "
    "round_trip_efficiency adaptability torsional_balance reliability authors_efficiency transmission score "
    "blocks finger_uniformity parts cost uniformity_p5 efficiency_p5";
inline const std::string equivalent = " smallest_jams alike same_as place";

inline const std::string readings = std::string(REEVE_SOURCE_DIR) + "/tests/golden/readings.csv";

inline const std::string diagnosed = std::string(REEVE_SOURCE_DIR) + "/tests/golden/diagnose_";
inline const std::string seeds_readings =
    std::string(REEVE_CATALOG_DIR) + "/measured/exo_glove_ii.csv";

inline const std::string logged = std::string(REEVE_SOURCE_DIR) + "/tests/golden/log.csv";

inline const std::vector<std::string> power{
    "simulate", "--routings", "TR5",    "--rows", "6",       "--cause", "sensor_gain[T3]",
    "--set",    "gain=1.3",   "--runs", "4",      "--power", "1"};

inline const std::vector<std::string> sizing{"size",     "M-1-P-2-P-3-M",
                                             "--target", "1=2,others=1",
                                             "--vary",   "sheath_angle=1..12",
                                             "--vary",   "tip_angle=1..4",
                                             "--draws",  "5"};

inline Json json_of(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--format", "json"});
  return Json::parse(reeve(arguments).out);
}

inline Json summary(std::vector<std::string> options = {}) {
  const TemporaryFolder folder;
  options.insert(options.begin(), {"explore", "--out", folder.path().string()});
  return json_of(options);
}

inline std::string keys(const Json& json) {
  std::string text;
  for (const auto& [key, value] : json.items()) text += (text.empty() ? "" : " ") + key;
  return text;
}

inline Json with_page(std::vector<std::string> arguments) {
  const TemporaryFolder folder;
  arguments.insert(arguments.end(), {"--out", folder.path().string()});
  return json_of(arguments);
}

}  // namespace reeve::testing
