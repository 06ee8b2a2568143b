// Diagnosis: names the causes for which the simulation is wrong, and the gain from adding them.
//
//   data without repetitions → coefficients calibrated (calibration.hpp) → terms accepted by their
//   evidence on all readings (term_search.hpp) → the same search without each fold of runs
//   (folds.hpp): do most find the same names, and does what they find gain on the runs that they
//   have not seen → runs apart, anything left (structure.hpp) → verdict
//
// A cause is named if its evidence is that of odds of 20 or more (least_evidence), if most folds
// find it, too, and if the models of the folds gain on unseen runs in likelihood and do not lose in
// newtons. A coefficient is named if its calibration differs from what the hardware says.
// docs/diagnosis.md tells it for people.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/diagnosis_result.hpp"
#include "diagnosis/search/term_search.hpp"
#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

// Settings that determine the result, besides the data and the hardware.
struct DiagnosisSettings : TermSearchOptions {
  double hold_out = 0;  // share of the runs that are sealed for a last test
  std::uint64_t seed = 1;
  std::size_t replicates = 1000;
};

struct DiagnoseOptions : DiagnosisSettings {
  int threads = 0;
  // To choose the next measurement from, beside those of the data.
  std::vector<MeasurableRouting> routings;
  // Called as each stage begins: how long they take is not known.
  std::function<void(const char* stage)> stage;
  const std::atomic<bool>* stop = nullptr;  // set by any thread, it ends the diagnosis
};

// Random draws depend on the numbers of runs and readings. For the same result from the same rows
// in any order, put them in a fixed order first (readings/row_order.hpp). Returns nothing if it was
// stopped. Throws InputError if no row can be compared, or if one of the options' terms changes no
// reading.
std::optional<DiagnosisResult> diagnose_until(const MeasuredData& data, const Hardware& hardware,
                                              const DiagnoseOptions& options);
DiagnosisResult diagnose(const MeasuredData& data, const Hardware& hardware,
                         const DiagnoseOptions& options = {});

}  // namespace reeve::diagnosis
