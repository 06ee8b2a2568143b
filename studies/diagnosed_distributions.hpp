// The tension distributions of readings before and after their diagnosis: as the model stands, or,
// where publications draw the same routings, with the coefficients that they assume; and with what
// was diagnosed.
#pragma once

#include <optional>
#include <vector>

#include "catalog/catalogue.hpp"
#include "diagnosis/diagnose.hpp"
#include "readings/measured_data.hpp"
#include "studies/published_models.hpp"
#include "studies/tension_distributions.hpp"

namespace reeve::studies {

// Of the data's routings with as many fingers as the first that has shares, in their grasps.
// Nothing if no pulled reading has all strands, or a model has no tensions in one of the grasps.
std::optional<TensionDistributions> diagnosed_distributions(
    const MeasuredData& data, const Hardware& hardware, const DiagnosisResult& result,
    const std::vector<PublishedModel>& published, const Catalogue& catalogue);

}  // namespace reeve::studies
