// Result of a diagnosis (diagnose.hpp), in values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "causes/model.hpp"
#include "diagnosis/chosen_readings.hpp"
#include "diagnosis/fit/intervals.hpp"
#include "diagnosis/fit/mounting_scatter.hpp"
#include "diagnosis/plan/next_measurement.hpp"
#include "diagnosis/verdict/compared_cell.hpp"
#include "diagnosis/verdict/explained.hpp"
#include "diagnosis/verdict/group_estimates.hpp"
#include "diagnosis/verdict/held_out.hpp"
#include "diagnosis/verdict/leads.hpp"
#include "diagnosis/verdict/left_out.hpp"
#include "diagnosis/verdict/losses.hpp"
#include "diagnosis/verdict/partial_residuals.hpp"
#include "diagnosis/verdict/row_scatter.hpp"
#include "diagnosis/verdict/share_error.hpp"
#include "diagnosis/verdict/structure.hpp"
#include "diagnosis/verdict/without_apart.hpp"

namespace reeve::diagnosis {

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
  double delta_log_likelihood = 0;  // by which its evidence is less
};

// A coefficient that is free in every model.
struct CalibratedCoefficient {
  std::string name;  // name of the cause: tube_friction
  EstimatedParameter parameter;
  double p_value = 1;    // chance of an estimate so far from the hardware's value if that is right
  bool differs = false;  // from what the hardware says; then it is a named cause, too
};

struct NamedCause {
  std::string name;
  std::string meaning;
  std::string detail;
  Effect effect;
  std::vector<EstimatedParameter> parameters;
  double p_value = 1;  // at most: under a model without it evidence rises so far by chance
  Explained explained;
  std::optional<PartialResiduals> partial{};  // nothing if no reading depends on it
  // The rest is nothing of a coefficient.
  // The gain with this cause over without it, all others kept. There is none if all readings that
  // it changes are of one run: a model that has not seen that run cannot know the cause.
  std::optional<HeldOut> held_out{};
  std::string only_run{};               // name of that run, or empty
  std::optional<double> evidence{};     // nats above the model without it
  std::optional<double> probability{};  // share among the causes that cannot be told from it
  std::optional<double> folds{};        // share of the folds that find it
  std::optional<RunnerUp> runner_up{};
};

// Runs that do something by themselves: a law of theirs alone, which no model keeps.
struct RunsApart {
  std::vector<std::string> runs;
  Effect effect;
  double evidence = 0;
  std::string text;  // what differs there, or might as well: "gain of T1 in run 3"
};

// The named causes together, or others in the place of one of them.
struct WeighedCauses {
  std::vector<std::string> causes;
  double gain = 0;                  // rise of evidence over the nominal model
  std::optional<HeldOut> held_out;  // gain of the named causes
};

struct Unexplained {
  std::string about;  // "routing, grasp and strand"
  std::string where;  // "T2 of M-1-P-2-M, held 1 (reads more)"
  double p_value = 1;
};

struct DiagnosisResult : SampleCounts {
  Verdict verdict = Verdict::none;
  std::vector<NamedCause> causes;  // sorted by the residuals that they explain
  std::vector<std::vector<std::string>> indistinguishable;
  // Between the first two of the first group.
  std::optional<PlannedMeasurement> separating_measurement;
  // Separates the leading explanations, or else most shrinks the interval of the first cause.
  std::optional<PlannedMeasurement> next_measurement;
  std::optional<Unexplained> unexplained;
  std::vector<StructureFinding> structure;  // after the named causes
  std::vector<Lead> leads;       // places to look, if structure is left or a term is not confirmed
  double residual_before_N = 0;  // root mean square, of all readings
  double residual_after_N = 0;
  std::optional<HeldOut> held_out;  // all causes over none
  std::vector<CalibratedCoefficient> calibration;
  std::vector<RunsApart> apart;
  // Found in all readings, but not in most folds, or no gain on the runs that these have not seen.
  std::vector<std::string> not_confirmed;
  std::size_t folds = 0;
  std::size_t most_causes = 0;            // greatest number looked for, beside coefficients
  std::optional<NoiseLimit> noise_limit;  // over the model as it was; nothing if nothing held out
  std::vector<RunGain> run_gains;         // all causes over none, each held-out run
  std::vector<WeighedCauses> weighed;
  double p_value = 1;                      // chance of the best cause's gain if no cause acts
  std::vector<EstimatesByGroup> by_group;  // coefficients and causes, fitted to each by itself
  std::optional<RowScatter> row_scatter;   // by the training runs, beside the model
  double structure_p_value = 1;            // chance of the strongest of `structure`, family-wise
  Noise noise;
  MountingScatter mounting;
  Model model;  // the extended one
  std::vector<ComparedCell> cells;
  ShareErrors share_errors;
  std::vector<LeftOutRun> left_out;  // the named causes fitted without each run
  std::vector<Loss> losses;
  std::optional<WithoutApart> without_apart;
};

// "recorded 1, measured 2" of wrong_grasp; otherwise empty.
std::string grasps_text(const Subject& subject);

NamedCause named_cause(const Effect& effect, double p_value);

// The p-th parameter of an effect, as it is searched where forces are of this scale.
EstimatedParameter estimated(const Effect& effect, std::size_t p, const ParameterInterval& interval,
                             const Hardware& hardware, double force_scale);

// Adds what the model has of each; `intervals` is parallel to its effects.
void describe(std::vector<NamedCause>& causes, const Model& model, const Hardware& hardware,
              const std::vector<std::vector<ParameterInterval>>& intervals, double force_scale,
              bool bends_are_recorded);

}  // namespace reeve::diagnosis
