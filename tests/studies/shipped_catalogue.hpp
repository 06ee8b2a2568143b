// The catalogue as it is shipped, and routings by its names or as words.
#pragma once

#include <filesystem>
#include <string>

#include "catalog/catalogue.hpp"
#include "core/notation.hpp"
#include "readings/measured_data.hpp"

namespace reeve::testing {

inline const std::filesystem::path shipped_folder = REEVE_CATALOG_DIR;

inline const Catalogue& shipped_catalogue() {
  static const Catalogue shipped = read_catalogue(shipped_folder);
  return shipped;
}

inline Routing routing_of(const std::string& name) {
  const CatalogueEntry* entry = shipped_catalogue().find_name(name);
  return entry != nullptr ? entry->routing : parse_routing(name);
}

// One reading of each of TR1 to TR7.
inline MeasuredData the_seven() {
  return read_measured_data((shipped_folder / "measured" / "exo_glove_ii.csv").string(),
                            routing_of);
}

}  // namespace reeve::testing
