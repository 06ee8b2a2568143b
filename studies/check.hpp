// Everything published that the catalogue's folder holds, computed again: its routings
// (catalog/check.hpp) and its publications (publication_check.hpp).
#pragma once

#include <filesystem>

#include "catalog/catalogue.hpp"
#include "catalog/check.hpp"

namespace reeve {

// `folder` is the one that the catalogue was read from. Throws InputError.
CheckReport check_all(const Catalogue& catalogue, const std::filesystem::path& folder);

}  // namespace reeve
