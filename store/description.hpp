// Identity of a store's exploration: a run can continue in the store only if all of this is the
// same.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::store {

struct StoredSetting {
  std::string key;
  std::string value;  // JSON

  friend bool operator==(const StoredSetting&, const StoredSetting&) = default;
};

struct Description {
  std::string exploration;              // exploration id, as in all its files
  std::string version;                  // program version
  std::string arguments;                // arguments of the command, a JSON list
  std::vector<StoredSetting> settings;  // sorted by key
  std::vector<std::string> known{};     // names of the known routings
  std::vector<std::string> limits{};    // the constraints
};

// "top (1000, and not 500), constraints ([], and not ["jams<=1"])": what differs. Where no setting
// does, the version or the catalogue; nothing if they are of one exploration.
std::optional<std::string> difference(const Description& there, const Description& asked);

}  // namespace reeve::store
