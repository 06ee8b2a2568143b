#include "studies/catalogue_list.hpp"

#include <utility>

#include "catalog/number_check.hpp"
#include "studies/catalogue_check.hpp"

namespace reeve::studies {
namespace {

template <typename Entry>
ListedMechanism listed(const Catalogue& catalogue, const Entry& entry, const std::string& family) {
  return {family,
          entry.name,
          entry.word,
          entry.routing,
          catalogue.sizes_of(entry.name),
          entry.title,
          entry.source,
          0,
          0};
}

void count_numbers(const CheckReport& report, ListedMechanism& mechanism) {
  for (const CheckItem& item : report.items) {
    if (item.family != mechanism.family || item.routing != mechanism.name) continue;
    ++mechanism.printed;
    if (item.status == CheckStatus::agrees) ++mechanism.agree;
  }
}

}  // namespace

std::vector<ListedMechanism> catalogue_list(const Catalogue& catalogue, const CatalogueFiles& files,
                                            const std::optional<std::string>& family,
                                            const std::optional<int>& fingers) {
  std::vector<ListedMechanism> list;
  const auto add = [&](ListedMechanism mechanism) {
    if (family && *family != mechanism.family) return;
    if (fingers && *fingers != finger_count(mechanism.routing)) return;
    list.push_back(std::move(mechanism));
  };
  for (const CatalogueEntry& entry : catalogue.entries) {
    add(listed(catalogue, entry, paper_family));
  }
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    add(listed(catalogue, mechanism, mechanism.family));
  }
  const CheckReport report = check_all(catalogue, files, family);
  for (ListedMechanism& mechanism : list) count_numbers(report, mechanism);
  return list;
}

}  // namespace reeve::studies
