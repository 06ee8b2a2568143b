#include "catalog/names.hpp"

#include <algorithm>

#include "core/canonical.hpp"

namespace reeve::catalog {
namespace {

std::size_t token_count(const Routing& routing) {
  std::size_t count = 0;
  for (const Tendon& tendon : routing.tendons) count += tendon.walk.size();
  return count;
}

// Whether there is a known routing of this size at all: putting one in its canonical form takes
// longer than that.
bool may_be_known(const Catalogue& catalogue, const Routing& routing) {
  const std::size_t tokens = token_count(routing);
  const auto is_of_its_size = [&](const Routing& known) {
    return known.tendons.size() == routing.tendons.size() && token_count(known) == tokens;
  };
  return std::any_of(catalogue.entries.begin(), catalogue.entries.end(),
                     [&](const auto& entry) { return is_of_its_size(entry.routing); }) ||
         std::any_of(catalogue.mechanisms.begin(), catalogue.mechanisms.end(),
                     [&](const auto& mechanism) { return is_of_its_size(mechanism.canonical); });
}

}  // namespace

std::string name_of(const Catalogue& catalogue, const Routing& routing) {
  if (!may_be_known(catalogue, routing)) return "";
  const Routing least = canonical(routing, FingerIdentity::identical);
  if (const CatalogueEntry* entry = catalogue.find_word(least)) return entry->name;
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    if (mechanism.canonical == least) return mechanism.name;
  }
  return "";
}

}  // namespace reeve::catalog
