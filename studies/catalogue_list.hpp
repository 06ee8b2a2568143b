// The routings and mechanisms of the catalogue by name, with how many of their printed numbers the
// solver gives.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/catalogue_files.hpp"
#include "core/routing.hpp"

namespace reeve::studies {

struct ListedMechanism {
  std::string family;
  std::string name;
  std::string word;
  Routing routing;
  std::vector<Routing> sizes;  // with its own, by the number of fingers
  std::string title;
  std::string source;
  std::size_t printed = 0;  // numbers that are recomputed
  std::size_t agree = 0;    // numbers that agree
};

// Lists the mechanisms of one family, or of one number of fingers, if they are given: paper first,
// then families by name. `files` are those that the catalogue was read from.
std::vector<ListedMechanism> catalogue_list(const Catalogue& catalogue, const CatalogueFiles& files,
                                            const std::optional<std::string>& family,
                                            const std::optional<int>& fingers);

}  // namespace reeve::studies
