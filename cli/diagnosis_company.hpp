// What a diagnosis takes from the catalogue and the generator, and gives back to them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "causes/model.hpp"
#include "core/uncertainty_ranges.hpp"
#include "diagnosis/measured_data.hpp"
#include "diagnosis/next_measurement.hpp"
#include "reports/diagnosis_report.hpp"
#include "reports/show_report.hpp"

namespace reeve::cli {

// Those of the catalogue with as many fingers as the data's; with `generated` also routings of one
// tendon that all known parts allow, at most 200.
std::vector<MeasurableRouting> measurable_routings(const MeasuredData& data,
                                                   const Catalogue& catalogue, bool generated);

// The catalogue's routings of two fingers; nothing if the model has no effect.
std::optional<CatalogueRanking> catalogue_ranking(const Hardware& plain, const Model& extended,
                                                  const Catalogue& catalogue);

// The routing of the next measurement, by the extended model in the measurement's grasp and
// conditions; nothing if there is no such measurement, or the model has no tensions in it.
std::optional<ShownRouting> next_routing(const DiagnosisReport& report, const Catalogue& catalogue);

// A model file that says where it is from.
std::string extended_model_toml(const DiagnosisReport& report,
                                const UncertaintyRanges& uncertainty);

}  // namespace reeve::cli
