#include "diagnosis/diagnose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "diagnosis/chosen_readings.hpp"
#include "diagnosis/diagnosis_result.hpp"
#include "diagnosis/fit/intervals.hpp"
#include "diagnosis/fit/problem.hpp"
#include "diagnosis/plan/power.hpp"
#include "diagnosis/search/candidates.hpp"
#include "diagnosis/search/explanation.hpp"
#include "diagnosis/verdict/aliases.hpp"
#include "diagnosis/verdict/channel_units.hpp"
#include "diagnosis/verdict/confirmation.hpp"
#include "diagnosis/verdict/other_direction.hpp"
#include "diagnosis/verdict/outlier_forecasts.hpp"
#include "diagnosis/verdict/outlier_groups.hpp"
#include "diagnosis/verdict/residual_structure.hpp"
#include "diagnosis/verdict/run_words.hpp"
#include "diagnosis/verdict/withdrawal.hpp"
#include "numerics/streams.hpp"

namespace reeve::diagnosis {
namespace {

void require_some_tension(const MeasuredData& data) {
  const std::vector<bool> dead = reads_zero_alone(data);
  if (std::find(dead.begin(), dead.end(), false) != dead.end()) return;
  throw InputError({.what = "every tension in the data",
                    .value = "0",
                    .expected = "a sensor that reads something"});
}

// A cause with two parameters and noise that nothing else tells would leave six.
constexpr double too_few_degrees = 8;

class Diagnosis {
 public:
  Diagnosis(const MeasuredData& data, const Hardware& hardware, const DiagnoseOptions& options)
      : data_(data),
        options_(options),
        workers_(options.threads, options.stop),
        sample_(sample(data, options.hold_out, options.seed)) {
    nominal_.hardware = hardware;
    result_.model = nominal_;
    take_over_counts();
    note_what_the_model_doubts();
  }

  std::optional<DiagnosisResult> run() {
    candidates_ = candidates(survey(data_), nominal_.hardware, force_scale(data_));
    if (sample_.training.degrees_of_freedom() < too_few_degrees) {
      note_too_few();
      found_ = nothing_explained(sample_.training, nominal_, explanation_options(), workers_);
      take_over_found();
    } else {
      if (!find_causes()) return std::nullopt;
      // The held-out runs are opened here.
      const Withdrawal withdrawal =
          withdraw_what_may_lose(found_, sample_.held_out, nominal_, options_.seed, workers_);
      result_.withdrawn = withdrawal.names;
      result_.withdrawn_held_out = withdrawal.held_out;
      take_over_found();
      if (!weigh_rivals()) return std::nullopt;
      confirm();
      if (!stopped("checking what is left")) check_residual_structure();
      if (!stopped("looking for readings far off")) check_far_readings();
      if (!stopped("comparing groups")) compare_groups();
    }
    if (stop_) return std::nullopt;
    describe(result_.causes, result_.model, nominal_.hardware,
             parameter_intervals(found_.problem, result_.model, found_.mounting_degrees()),
             force_scale(data_));
    // Where nothing is named the hardware stands, and its coefficients with it.
    if (result_.causes.empty()) result_.model = nominal_;
    decide();
    if (stopped("choosing the next measurement")) return std::nullopt;
    plan_measurements();
    if (stopped("leaving out one run after the other")) return std::nullopt;
    leave_out_runs();
    result_.cells = compared_cells(sample_, nominal_, result_.model, found_.scatter,
                                   result_.left_out, workers_);
    if (auto far = outlier_forecasts(result_.cells, data_, result_.noise, options_.alpha)) {
      result_.notes.push_back(std::move(*far));
    }
    result_.share_errors = share_errors(data_, result_.cells);
    result_.losses = losses(data_, result_.model, result_.cells);
    result_.without_apart = without_apart(data_, result_.model, found_.scatter, result_.cells,
                                          result_.losses, workers_);
    return std::move(result_);
  }

 private:
  bool stopped(const char* stage) {
    if (options_.stage && options_.stage(stage)) stop_ = true;
    if (options_.stop != nullptr && options_.stop->load()) stop_ = true;
    return stop_;
  }

  void take_over_counts() {
    result_.rows = sample_.rows;
    result_.runs = sample_.runs;
    result_.held_out_runs = sample_.held_out_runs;
    result_.dropped_duplicates = sample_.dropped_duplicates;
    result_.thinned_rows = sample_.thinned_rows;
    result_.notes = sample_.notes;
  }

  bool is_noted(NoteKind kind) const {
    return std::any_of(result_.notes.begin(), result_.notes.end(),
                       [&](const DataNote& note) { return note.kind == kind; });
  }

  // Before anything is fitted, and where the tensions alone have not said it.
  void note_what_the_model_doubts() {
    if (!is_noted(NoteKind::units)) {
      for (DataNote& note : notes_on_channel_units(dataset(data_, readings_used()), nominal_)) {
        result_.notes.push_back(std::move(note));
      }
    }
    if (is_noted(NoteKind::not_as_pulled)) return;
    if (auto note = note_on_other_direction(data_, readings_used(), nominal_)) {
      result_.notes.push_back(std::move(*note));
    }
  }

  void note_too_few() {
    too_few_ = true;
    result_.notes.push_back(
        {NoteKind::not_compared,
         fmt::format("{:.0f} independent readings in the training runs are too few to say "
                     "anything: expected at least {:.0f}",
                     sample_.training.degrees_of_freedom(), too_few_degrees),
         {}});
  }

  ExplanationOptions explanation_options() const {
    return {options_.alpha, options_.replicates, options_.most_causes, options_.mounting_scatter,
            options_.seed};
  }

  bool find_causes() {
    auto found = explain(sample_.training, nominal_, candidates_, explanation_options(), workers_,
                         [this](const char* stage) { return stopped(stage); });
    if (!found) return false;
    found_ = std::move(*found);
    return true;
  }

  // No smaller chance than the replicates could tell of a cause.
  double resolved(double p_value) const {
    return std::max(p_value, 1 / static_cast<double>(options_.replicates + 1));
  }

  void take_over_found() {
    result_.noise = found_.scatter.noise;
    result_.mounting = found_.scatter.mounting;
    result_.model = found_.model;
    result_.p_value = found_.p_value;
    result_.most_causes = found_.most_causes;
    result_.not_confirmed = found_.not_confirmed;
    result_.not_sure = found_.not_sure;
    for (const Calibration& calibration : found_.calibrations) {
      CalibratedCoefficient coefficient{effect_name(calibration.effect),
                                        estimated(calibration.effect, 0, calibration.interval,
                                                  nominal_.hardware, force_scale(data_)),
                                        resolved(calibration.p_value), calibration.differs};
      if (coefficient.differs) {
        result_.causes.push_back(named_cause(calibration.effect, coefficient.p_value));
        result_.p_value = std::min(result_.p_value, coefficient.p_value);
      }
      result_.calibration.push_back(std::move(coefficient));
    }
    for (const AcceptedCause& accepted : found_.accepted) {
      result_.causes.push_back(named_cause(accepted.effect, accepted.p_value));
    }
  }

  bool weigh_rivals() {
    const Dataset all =
        sample_.held_out.cells.empty() ? Dataset{} : dataset(data_, readings_used());
    auto found = aliases({found_.problem, all, found_.scatter, result_.model, candidates_},
                         applied(result_.causes), workers_,
                         [this] { return stopped("weighing other causes"); });
    if (!found) return false;
    aliases_ = std::move(*found);
    for (std::size_t c = 0; c < result_.causes.size(); ++c) {
      const std::vector<Rival>& others = aliases_.rivals[c];
      if (others.empty()) continue;
      result_.causes[c].runner_up = RunnerUp{others.front().name, others.front().deficit};
    }
    return true;
  }

  void confirm() {
    Confirmation confirmed = confirmation(found_.problem, found_.scatter, nominal_, result_.model,
                                          applied(result_.causes), aliases_.rivals,
                                          sample_.held_out, options_.seed, workers_);
    for (std::size_t c = 0; c < result_.causes.size(); ++c) {
      result_.causes[c].held_out = confirmed.of_causes[c];
    }
    result_.held_out = confirmed.together;
    result_.weighed = std::move(confirmed.weighed);
    result_.noise_limit = confirmed.noise_limit;
    result_.run_gains = std::move(confirmed.run_gains);
  }

  void check_residual_structure() {
    const ResidualStructure left = residual_structure(
        found_.problem, result_.model, found_.scatter.mounting, options_.alpha,
        {streams::seed_of_residual_structure(options_.seed), options_.replicates}, workers_,
        [this] { return stopped("checking what is left"); });
    result_.row_scatter = left.row_scatter;
    result_.structure = left.structure.findings;
    result_.structure_p_value = left.structure.p_value;
    if (!stop_ && left.structure.p_value < structure_share_of_alpha * options_.alpha) {
      result_.unexplained = {left.structure.findings.front().about, left.structure.where,
                             left.structure.p_value};
    }
  }

  void check_far_readings() {
    std::optional<Problem> unseen;
    if (!sample_.held_out.cells.empty()) {
      unseen = problem(sample_.held_out, found_.scatter, result_.model, workers_);
    }
    const OutlierReadings far = outlier_readings_together(
        {found_.problem,
         unseen ? &*unseen : nullptr,
         result_.model,
         result_.noise,
         result_.mounting,
         options_.alpha,
         {streams::seed_of_residual_structure(options_.seed), options_.replicates}},
        workers_, [this] { return stopped("looking for readings far off"); });
    if (stop_) return;
    for (const OutlierGroups& together : far.together) {
      result_.notes.push_back(note_on(together, far, data_, options_.alpha));
      if (result_.unexplained || !follow_something(together, options_.alpha)) continue;
      result_.unexplained = {"channel and run", where_text(together, data_),
                             resolved(together.p_value)};
    }
  }

  void plan_measurements() {
    const MeasurementPlan plan = measurement_plan(data_, options_.routings, result_.noise);
    for (const Indistinguishable& group : aliases_.groups) {
      result_.indistinguishable.push_back(group.names);
    }
    if (!aliases_.groups.empty()) {
      const Indistinguishable& group = aliases_.groups.front();
      result_.separating_measurement = separating_measurement(plan, group.models, group.names);
      result_.next_measurement = result_.separating_measurement;
    } else if (!result_.causes.empty()) {
      const NamedCause& cause = result_.causes.front();
      result_.next_measurement = shrinking_measurement(plan, found_.problem, result_.model,
                                                       place(result_.model, cause.effect));
    }
  }

  void decide() {
    if (too_few_) {
      result_.verdict = Verdict::too_few;
    } else if (result_.unexplained) {
      result_.verdict = Verdict::unexplained;
    } else if (!aliases_.groups.empty()) {
      result_.verdict = Verdict::indistinguishable;
    } else {
      result_.verdict = result_.causes.empty() ? Verdict::none : Verdict::cause;
    }
  }

  std::vector<std::size_t> readings_used() const {
    std::vector<std::size_t> readings;
    for (const Dataset* part : {&sample_.training, &sample_.held_out}) {
      for (const DatasetRow& row : part->rows) readings.push_back(row.reading);
    }
    std::sort(readings.begin(), readings.end());
    return readings;
  }

  // Whether some coefficient or cause differs between them.
  bool groups_differ(const Model& model) {
    result_.by_group = estimates_by_group(data_, readings_used(), model, found_.scatter,
                                          found_.mounting_degrees(), options_.alpha, workers_);
    const double share = structure_share_of_alpha * options_.alpha;
    double least = share;
    for (const EstimatesByGroup& of : result_.by_group) {
      const double p_value = resolved(of.p_value);
      if (p_value >= least) continue;
      least = p_value;
      result_.unexplained = {"group", of.cause + " in " + data_.groups[of.farthest], p_value};
    }
    return least < share;
  }

  // Also where nothing is named: what groups have in common may be as the hardware says. One model
  // of all groups explains none that differs from the others.
  void compare_groups() {
    const bool found_some = !found_.model.effects.empty();
    if (!groups_differ(found_some ? found_.model : found_.base)) return;
    if (found_some) {
      groups_differ(found_.base);
      result_.notes.push_back(
          {NoteKind::groups_differ,
           "no cause is named for groups that differ, though some were found in all of them "
           "together: each group by itself may tell",
           {}});
    }
    name_nothing_of_all_groups();
  }

  // What was found in all groups together may stand in for the difference between them: a drift, if
  // they follow each other.
  void name_nothing_of_all_groups() {
    result_.causes.clear();
    result_.withdrawn.clear();
    result_.withdrawn_held_out.reset();
    result_.held_out.reset();
    result_.run_gains.clear();
    result_.weighed.clear();
    result_.row_scatter.reset();
    aliases_.groups.clear();
    result_.model = found_.base;
  }

  // After every decision: it says what each run contributed to it.
  void leave_out_runs() {
    const std::vector<std::size_t> readings = readings_used();
    result_.left_out = left_out_runs(data_, readings, result_.model, found_.scatter, workers_);
  }

  const MeasuredData& data_;
  const DiagnoseOptions& options_;
  Workers workers_;
  Sample sample_;
  bool stop_ = false;
  bool too_few_ = false;
  Model nominal_;
  Explanation found_;
  std::vector<Candidate> candidates_;
  Aliases aliases_;
  DiagnosisResult result_;
};

}  // namespace

std::optional<DiagnosisResult> diagnose_until(const MeasuredData& data, const Hardware& hardware,
                                              const DiagnoseOptions& options) {
  require_some_tension(data);
  try {
    return Diagnosis(data, hardware, options).run();
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

DiagnosisResult diagnose(const MeasuredData& data, const Hardware& hardware,
                         const DiagnoseOptions& options) {
  return *diagnose_until(data, hardware, options);
}

}  // namespace reeve::diagnosis
