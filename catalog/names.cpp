#include "catalog/names.hpp"

#include "core/canonical.hpp"
#include "core/notation.hpp"

namespace reeve::catalog {

std::string name_of(const Catalogue& catalogue, const std::string& word) {
  const CatalogueEntry* entry =
      catalogue.find_word(canonical(parse_routing(word), FingerIdentity::identical));
  return entry == nullptr ? "" : entry->name;
}

}  // namespace reeve::catalog
