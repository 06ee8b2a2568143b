// The routings that are to be ranked: those that are given by name or word, and those of a family
// of the catalogue.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "core/routing.hpp"
#include "studies/tension_distributions.hpp"

namespace reeve::cli {

// Reads --distribution-mu of `rank`, such as "0.18,0.09,model": coefficients of tubes and sheaths
// alike, and the model as it is. Throws InputError.
std::vector<FrictionCase> read_friction_cases(const std::string& text, const Model& model);

struct AskedRoutings {
  std::vector<std::string> given;
  bool catalogued = false;  // also those of a family with as many fingers
  int fingers = 0;          // … as these, where none are given
  std::optional<std::string> family;
};

// At least one, each once, all with the same number of fingers. Throws InputError.
std::vector<Routing> ranked_routings(const AskedRoutings& asked, const Catalogue& catalogue);

// A word that mechanisms of several families have gets the name that it has in this one.
void name_by(const std::string& family, Catalogue& catalogue);

}  // namespace reeve::cli
