// The strand tensions of a routing of the catalogue, as a publication's readings have them.
#pragma once

#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/publication.hpp"
#include "readings/measured_data.hpp"

namespace reeve::studies {

// T1 … T2n, N, of the one reading of this routing that pulls in the grasp of the published numbers.
// Throws InputError if there is none, or another.
std::vector<double> strand_readings(const Publication& publication, const CatalogueEntry& entry,
                                    const MeasuredData& readings);

// Throws InputError if the catalogue has no such routing.
const CatalogueEntry& entry_of(const Catalogue& catalogue, const Publication& publication,
                               const std::string& routing);

}  // namespace reeve::studies
