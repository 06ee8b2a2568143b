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

#include "causes/model.hpp"
#include "diagnosis/data/dataset.hpp"
#include "diagnosis/data/measured_data.hpp"
#include "diagnosis/data/sample.hpp"
#include "diagnosis/model/scatter.hpp"
#include "diagnosis/plan/next_measurement.hpp"
#include "diagnosis/verdict/compared_cell.hpp"
#include "diagnosis/verdict/confirmation.hpp"
#include "diagnosis/verdict/group_estimates.hpp"
#include "diagnosis/verdict/left_out.hpp"
#include "diagnosis/verdict/losses.hpp"
#include "diagnosis/verdict/row_scatter.hpp"
#include "diagnosis/verdict/share_error.hpp"
#include "diagnosis/verdict/structure.hpp"
#include "diagnosis/verdict/without_apart.hpp"

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

// too_few: readings, to look for anything.
enum class Verdict : std::uint8_t { none, cause, unexplained, indistinguishable, too_few };
const char* verdict_name(Verdict verdict);

struct EstimatedParameter {
  std::string name;
  std::string unit;
  double value = 0;
  double low = 0;
  double high = 0;
  std::optional<double> nominal;
  std::optional<Range> literature;
  bool at_bound = false;  // the value, or an end of its interval, stands where the search ended
};

struct RunnerUp {
  std::string name;
  double delta_log_likelihood = 0;  // by which it explains the training runs less
};

// A coefficient that is free in every model.
struct CalibratedCoefficient {
  std::string name;  // of the cause: tube_friction
  EstimatedParameter parameter;
  double p_value = 1;    // that the hardware is right and chance takes the estimate so far from it
  bool differs = false;  // from what the hardware says; then it is a named cause, too
};

struct NamedCause {
  std::string name;
  std::string meaning;
  std::string detail;
  Effect effect;
  std::vector<EstimatedParameter> parameters;
  std::optional<HeldOut> held_out;  // with this cause over without it, all others kept
  double p_value = 1;
  std::optional<RunnerUp> runner_up;
};

struct Unexplained {
  std::string about;  // "routing, grasp and strand"
  std::string where;  // "T2 of M-1-P-2-M, held 1 (reads more)"
  double p_value = 1;
};

struct DiagnosisResult {
  Verdict verdict = Verdict::none;
  std::vector<NamedCause> causes;
  std::vector<std::vector<std::string>> indistinguishable;
  // Between the first two of the first group.
  std::optional<PlannedMeasurement> separating_measurement;
  // Which separates the leading explanations, or else most shrinks the interval of the first cause.
  std::optional<PlannedMeasurement> next_measurement;
  std::optional<Unexplained> unexplained;
  std::vector<StructureFinding> structure;  // after the named causes
  std::optional<HeldOut> held_out;          // all causes over none
  std::vector<CalibratedCoefficient> calibration;
  std::vector<std::string> not_confirmed;  // accepted, but training runs forecast others worse
  std::vector<std::string> not_sure;       // the interval holds the nominal size, or a bound
  std::vector<std::string> withdrawn;      // together they may lose on the held-out runs
  std::optional<HeldOut> withdrawn_held_out;
  std::size_t most_causes = 0;            // that were looked for, beside coefficients
  std::optional<NoiseLimit> noise_limit;  // over the model as it was; nothing if nothing held out
  std::vector<RunGain> run_gains;         // all causes over none, each held-out run
  std::vector<WeighedCauses> weighed;
  double p_value = 1;                      // that chance alone gives what the best cause gains
  std::vector<EstimatesByGroup> by_group;  // coefficients and causes, fitted to each by itself
  std::optional<RowScatter> row_scatter;   // by the training runs, beside the model
  double structure_p_value = 1;  // that it gives the strongest of `structure`, family-wise
  Noise noise;
  MountingScatter mounting;
  Model model;  // the extended one
  std::vector<ComparedCell> cells;
  ShareErrors share_errors;
  std::vector<LeftOutRun> left_out;  // the named causes fitted without each run
  std::vector<Loss> losses;
  std::optional<WithoutApart> without_apart;
  std::size_t rows = 0;  // used, training and held out
  std::size_t runs = 0;
  std::size_t held_out_runs = 0;
  std::size_t dropped_duplicates = 0;
  std::size_t thinned_rows = 0;  // beyond most_readings
  std::vector<DataNote> notes;
};

// What is drawn is drawn by the numbers of runs and readings: a caller who wants the same of the
// same rows in any order puts them in one (data/row_order.hpp). Nothing if it was stopped. Throws
// InputError if no row can be compared.
std::optional<DiagnosisResult> diagnose_until(const MeasuredData& data, const Hardware& hardware,
                                              const DiagnoseOptions& options);
DiagnosisResult diagnose(const MeasuredData& data, const Hardware& hardware,
                         const DiagnoseOptions& options = {});

}  // namespace reeve::diagnosis
