#pragma once

#include <string>

#include "catalog/catalogue.hpp"
#include "core/routing.hpp"

namespace reeve::catalog {

// The catalogue's name of a routing, or "". Fingers count as identical: M-2-P-1-F is TR4 too.
std::string name_of(const Catalogue& catalogue, const Routing& routing);

}  // namespace reeve::catalog
