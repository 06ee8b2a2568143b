// Everything published that the catalogue's files hold, computed again: its routings
// (catalog/check.hpp) and publications (publication_check.hpp), which are the family "paper", and
// its other families (catalog/mechanisms/mechanism_check.hpp).
#pragma once

#include <optional>
#include <string>

#include "catalog/catalogue.hpp"
#include "catalog/check.hpp"

namespace reeve::studies {

// One family after the other, or one alone. `files` are those that the catalogue was read from.
// Throws InputError.
CheckReport check_all(const Catalogue& catalogue, const CatalogueFiles& files,
                      const std::optional<std::string>& family = std::nullopt);

}  // namespace reeve::studies
