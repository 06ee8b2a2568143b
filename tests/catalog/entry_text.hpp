// Texts of catalogue entries, and what reading them complains of.
#pragma once

#include <string>

#include "catalog/catalogue.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {

inline const std::string minimal = "name = \"X\"\nword = \"M-1-F\"\n";
inline const std::string published = minimal + "held = [1]\n";
inline const std::string table =
    "[table]\nsource = \"Table I\"\ntension = [\"0.3\", \"0.2\"]\nshare_percent = [\"60\", \"40\"]\n";

inline std::string error_in_catalogue(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("x.toml", text);
  return folder.error_of([&] { read_catalogue(folder.path()); });
}

}  // namespace reeve::testing
