#include "studies/check.hpp"

#include <utility>

#include "catalog/publication.hpp"
#include "core/notation.hpp"
#include "diagnosis/data/measured_data.hpp"
#include "studies/publication_check.hpp"

namespace reeve::studies {

CheckReport check_all(const Catalogue& catalogue, const CatalogueFiles& files) {
  CheckReport report = check(catalogue);
  const auto routing = [&](const std::string& text) {
    const CatalogueEntry* entry = catalogue.find_name(text);
    return entry == nullptr ? parse_routing(text) : entry->routing;
  };
  for (const Publication& publication : read_publications(files)) {
    const CatalogueFile file = files.find("measured/" + publication.readings);
    const MeasuredData readings = file.text ? parse_measured_data(*file.text, file.name, routing)
                                            : read_measured_data(file.name, routing);
    for (CheckItem& item : check_publication(catalogue, publication, readings)) {
      report.items.push_back(std::move(item));
    }
  }
  return report;
}

}  // namespace reeve::studies
