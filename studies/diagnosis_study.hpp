// Readings diagnosed, and set beside what the catalogue knows: whether its ranking changes, and
// what publications draw of the same routings.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "diagnosis/diagnose.hpp"
#include "readings/measured_data.hpp"
#include "studies/published_models.hpp"
#include "studies/shown_routing.hpp"

namespace reeve::studies {

struct DiagnosisRequest {
  MeasuredData data;
  Hardware hardware;
  DiagnosisSettings settings;
  // True if the next measurement may be of a generated routing: of one tendon, with the data's
  // numbers of fingers, of all known parts, at most 200. Otherwise it is one of the catalogue's or
  // the data's.
  bool with_generated = false;
  int threads = 0;
  std::function<void(const char* stage)> stage;  // as in DiagnoseOptions, like the next
  const std::atomic<bool>* stop = nullptr;
};

// Names of the catalogue's routings of two fingers, best first by mean uniformity and efficiency,
// before and after the model is extended.
struct CatalogueRanking {
  std::vector<std::string> before;
  std::vector<std::string> after;

  bool changes() const { return before != after; }
};

struct DiagnosisReport {
  MeasuredData data;  // in the order of its contents (readings/row_order.hpp)
  Hardware hardware;
  DiagnosisSettings settings;
  bool with_generated = false;
  DiagnosisResult result;
  std::map<std::string, std::string> names;  // names in the catalogue, by word
  // Only where a cause extends the model, to one that has tensions in all these routings, and the
  // readings are of a hand.
  std::optional<CatalogueRanking> ranking;
  std::vector<PublishedModel> published;  // models of the data's routings in their grasps
  double seconds = 0;
};

// True if the readings leave no choice of grasps: all are of routings with one finger at most,
// which nothing holds. They tell of parts, not of a hand.
bool is_bench(const MeasuredData& data);

// Nothing if it was stopped. Throws InputError if no row can be compared.
std::optional<DiagnosisReport> diagnosis_study(DiagnosisRequest request,
                                               const Catalogue& catalogue);

// The routing of the next measurement, by the extended model in the measurement's grasp and
// conditions; nothing if there is no such measurement, or the model has no tensions in it.
std::optional<SolvedRouting> next_routing(const DiagnosisReport& report,
                                          const Catalogue& catalogue);

}  // namespace reeve::studies
