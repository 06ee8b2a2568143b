// The indicators of a publication from its readings (catalogue_check.hpp).
#pragma once

#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/number_check.hpp"
#include "catalog/publication.hpp"
#include "readings/measured_data.hpp"

namespace reeve::studies {

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
