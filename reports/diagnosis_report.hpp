// A diagnosis: the answer and its evidence for people, the same for programs, and every value.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "diagnosis/diagnose.hpp"
#include "diagnosis/measured_data.hpp"
#include "reports/sheet.hpp"
#include "studies/published_models.hpp"

namespace reeve {

struct DiagnosisSettings {
  double alpha = DiagnoseOptions{}.alpha;
  double hold_out = DiagnoseOptions{}.hold_out;
  std::uint64_t seed = DiagnoseOptions{}.seed;
  std::size_t replicates = DiagnoseOptions{}.replicates;
  bool explore = false;  // whether generated routings were offered for the next measurement
};

// Names of the catalogue's routings, best first, before and after the model is extended.
struct CatalogueRanking {
  std::vector<std::string> before;
  std::vector<std::string> after;

  bool changes() const { return before != after; }
};

struct DiagnosisReport {
  MeasuredData data;
  Hardware hardware;
  DiagnosisSettings settings;
  DiagnosisResult result;
  std::map<std::string, std::string> names;  // of the catalogue, by word
  std::optional<CatalogueRanking> ranking;   // only where a cause extends the model
  std::vector<PublishedModel> published;     // of the data's routings in their grasps
  double seconds = 0;
};

// What is wrong, which cause, how much better: a few lines.
std::string diagnosis_answer(const DiagnosisReport& report);
// The answer, then what it rests on.
Sheet diagnosis_sheet(const DiagnosisReport& report);
std::string diagnosis_json(const DiagnosisReport& report);
// One line for each reading and channel; a comment line at the top if the data are simulated.
std::string diagnosis_residuals_csv(const DiagnosisReport& report);

}  // namespace reeve
