#pragma once

#include <string>
#include <vector>

#include "catalog/number_check.hpp"
#include "core/tension/tension.hpp"
#include "reports/document/document.hpp"

namespace reeve::reports {

// Describes a checked number:
// "T3", "share of T3, %", "reliability"
std::string quantity_text(const CheckedQuantity& quantity);
// The same, or what the number's source calls it.
std::string quantity_text(const CheckItem& item);

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
