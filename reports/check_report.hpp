#pragma once

#include <string>
#include <vector>

#include "catalog/check.hpp"
#include "core/tension/tension.hpp"
#include "reports/document/document.hpp"

namespace reeve::reports {

// The catalogue's routings side by side, as schematics.
struct ShownEntry {
  std::string title;
  Network network;
  Grasp grasp;
  TensionState state;
};

std::string catalogue_document(const std::vector<ShownEntry>& entries);

Document check_sheet(const CheckReport& report);
std::string check_json(const CheckReport& report);

}  // namespace reeve::reports
