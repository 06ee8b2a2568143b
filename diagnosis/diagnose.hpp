// What the simulation gets wrong, why, and what mending it gains.
//
//   data without repetitions → runs held out → coefficients calibrated (calibration.hpp) → scatter
//   of readings and of mountings → causes accepted on the training runs (cause_search.hpp) → do
//   these confirm each other (cross_validation.hpp), are their sizes sure → the gain on the
//   held-out runs, which are opened once: if all names together may lose there, none is named →
//   what else would explain all readings as much → is anything left (structure.hpp) → verdict
//
// A cause is named if it was accepted against chance (family-wise, alpha), if the training runs,
// each forecast from the others, confirm it, if the interval of its size excludes the nominal one
// and the size does not stand at a bound, if the named causes together gain on the held-out runs,
// and if no other cause explains all readings nearly as well (within `alias_margin` in
// log-likelihood). A coefficient is named if its calibration differs from what the hardware says.
// docs/diagnosis.md tells it for people.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/diagnosis_result.hpp"
#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

// What the result depends on, besides the data and the hardware.
struct DiagnosisSettings {
  double alpha = 0.02;
  double hold_out = 0.3;  // share of the runs
  std::uint64_t seed = 1;
  std::size_t replicates = 1000;
  std::optional<std::size_t> most_causes;  // beside coefficients; none: as many as the data carry
  // Relative standard deviation of friction exponents from mounting to mounting, if it is known.
  std::optional<double> mounting_scatter;
};

struct DiagnoseOptions : DiagnosisSettings {
  int threads = 0;
  // To choose the next measurement from, beside those of the data.
  std::vector<MeasurableRouting> routings;
  // Called now and then; returns whether to stop. Stage by stage, since the length is not known.
  std::function<bool(const char* stage)> stage;
  // Asked within stages, too, and by any thread.
  const std::atomic<bool>* stop = nullptr;
};

// What is drawn is drawn by the numbers of runs and readings: a caller who wants the same of the
// same rows in any order puts them in one (data/row_order.hpp). Nothing if it was stopped. Throws
// InputError if no row can be compared.
std::optional<DiagnosisResult> diagnose_until(const MeasuredData& data, const Hardware& hardware,
                                              const DiagnoseOptions& options);
DiagnosisResult diagnose(const MeasuredData& data, const Hardware& hardware,
                         const DiagnoseOptions& options = {});

}  // namespace reeve::diagnosis
