// Everything published that the catalogue's files hold, computed again: its routings
// (catalog/check.hpp) and its publications (publication_check.hpp).
#pragma once

#include "catalog/catalogue.hpp"
#include "catalog/check.hpp"

namespace reeve::studies {

// `files` are those that the catalogue was read from. Throws InputError.
CheckReport check_all(const Catalogue& catalogue, const CatalogueFiles& files);

}  // namespace reeve::studies
