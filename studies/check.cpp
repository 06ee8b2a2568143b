#include "studies/check.hpp"

#include <utility>

#include "catalog/publication.hpp"
#include "core/notation.hpp"
#include "diagnosis/measured_data.hpp"
#include "studies/publication_check.hpp"

namespace reeve {

CheckReport check_all(const Catalogue& catalogue, const std::filesystem::path& folder) {
  CheckReport report = check(catalogue);
  const auto routing = [&](const std::string& text) {
    const CatalogueEntry* entry = catalogue.find_name(text);
    return entry == nullptr ? parse_routing(text) : entry->routing;
  };
  for (const Publication& publication : read_publications(folder)) {
    const MeasuredData readings =
        read_measured_data(folder / "measured" / publication.readings, routing);
    for (CheckItem& item : check_publication(catalogue, publication, readings)) {
      report.items.push_back(std::move(item));
    }
  }
  return report;
}

}  // namespace reeve
