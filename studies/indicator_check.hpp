// The indicators of a publication from its readings (catalogue_check.hpp).
#pragma once

#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/number_check.hpp"
#include "catalog/publication.hpp"
#include "readings/measured_data.hpp"

namespace reeve::studies {

// The strand tensions of a routing of the catalogue, as a publication's readings have them:
// T1 … T2n, N, of the one reading of this routing that pulls in the grasp of the published numbers.
// Throws InputError if there is none, or another.
std::vector<double> strand_readings(const Publication& publication, const CatalogueEntry& entry,
                                    const MeasuredData& readings);

// Throws InputError if the catalogue has no such routing.
const CatalogueEntry& entry_of(const Catalogue& catalogue, const Publication& publication,
                               const std::string& routing);

// A number and by how much it may be off.
struct Uncertain {
  double value = 0;
  double tolerance = 0;
};

// Motor-side tension of a sheath that is pulled, over that of its strand, inverted: T_strand / T,
// as the transmission of one routing implies it.
Uncertain implied_ratio(const Catalogue& catalogue, const Publication& publication,
                        const MeasuredData& readings);

std::vector<CheckItem> check_indicators(const Catalogue& catalogue, const Publication& publication,
                                        const MeasuredData& readings);

}  // namespace reeve::studies
