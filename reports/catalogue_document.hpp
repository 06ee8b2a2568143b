// The catalogue's routings side by side, as schematics.
#pragma once

#include <string>
#include <vector>

#include "core/tension/tension.hpp"

namespace reeve::reports {

struct ShownEntry {
  std::string title;
  Network network;
  Grasp grasp;
  TensionState state;
};

std::string catalogue_document(const std::vector<ShownEntry>& entries);

}  // namespace reeve::reports
