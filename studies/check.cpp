#include "studies/check.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "catalog/mechanisms/mechanism_check.hpp"
#include "catalog/publication.hpp"
#include "core/notation.hpp"
#include "readings/measured_data.hpp"
#include "studies/publication_check.hpp"

namespace reeve::studies {

namespace {

CheckReport check_paper(const Catalogue& catalogue, const CatalogueFiles& files) {
  CheckReport report = check(catalogue);
  const auto routing = [&](const std::string& text) {
    const Routing* named = catalogue.find_routing(text);
    return named == nullptr ? parse_routing(text) : *named;
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

void append(CheckReport part, CheckReport& report) {
  std::move(part.items.begin(), part.items.end(), std::back_inserter(report.items));
  std::move(part.misprints.begin(), part.misprints.end(), std::back_inserter(report.misprints));
}

}  // namespace

CheckReport check_all(const Catalogue& catalogue, const CatalogueFiles& files,
                      const std::optional<std::string>& family) {
  CheckReport report;
  if (!family || *family == paper_family) report = check_paper(catalogue, files);
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    if (!family || *family == mechanism.family) append(check_mechanism(mechanism), report);
  }
  return report;
}

}  // namespace reeve::studies
