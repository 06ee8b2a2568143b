// The catalogue by name, as a table and as JSON.
#pragma once

#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "studies/catalogue_list.hpp"

namespace reeve::reports {

// "2, 3, 4": the numbers of fingers that the catalogue has it for.
std::string sizes_text(const ListedMechanism& mechanism);

Document catalogue_sheet(const std::vector<ListedMechanism>& list);
std::string catalogue_json(const std::vector<ListedMechanism>& list);

}  // namespace reeve::reports
