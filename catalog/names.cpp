#include "catalog/names.hpp"

#include "core/canonical.hpp"

namespace reeve::catalog {

std::string name_of(const Catalogue& catalogue, const Routing& routing) {
  const Routing least = canonical(routing, FingerIdentity::identical);
  if (const CatalogueEntry* entry = catalogue.find_word(least)) return entry->name;
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    if (mechanism.canonical == least) return mechanism.name;
  }
  return "";
}

}  // namespace reeve::catalog
