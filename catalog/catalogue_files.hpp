// Files of a catalogue: in a folder, or in the program, which contains the catalogue of its build.
// Paths are relative to the catalogue: "tr1.toml", "measured/exo_glove_ii.csv".
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/toml_node.hpp"

namespace reeve::catalog {

struct CatalogueFile {
  std::string name;                 // path on disk, or in the program's catalogue
  std::optional<std::string> text;  // content of a file in the program
};

// The catalogue's files in the program, by their path in the catalogue. The build generates it.
const std::map<std::string_view, std::string_view>& embedded_catalogue();

class CatalogueFiles {
 public:
  static CatalogueFiles built_in();
  static CatalogueFiles in(const std::filesystem::path& folder);
  // Returns the folder that REEVE_CATALOG names, or else the built-in catalogue.
  static CatalogueFiles shipped();

  // The *.toml that lie directly in this folder of the catalogue, "" for itself, by name. Throws
  // InputError.
  std::vector<TomlNode> toml(const std::string& folder) const;
  // The folders that lie directly in this one, by name; none if there is no such folder. Throws
  // InputError.
  std::vector<std::string> folders(const std::string& folder) const;
  CatalogueFile find(const std::string& path) const;

 private:
  std::filesystem::path folder_;  // "": built in
};

}  // namespace reeve::catalog
