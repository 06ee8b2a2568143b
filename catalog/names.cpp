#include "catalog/names.hpp"

#include "core/canonical.hpp"
#include "core/notation.hpp"

namespace reeve::catalog {

std::string name_of(const Catalogue& catalogue, const std::string& word) {
  const Routing routing = canonical(parse_routing(word), FingerIdentity::identical);
  if (const CatalogueEntry* entry = catalogue.find_word(routing)) return entry->name;
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    if (mechanism.canonical == routing) return mechanism.name;
  }
  return "";
}

}  // namespace reeve::catalog
