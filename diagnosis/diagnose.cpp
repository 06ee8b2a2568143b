#include "diagnosis/diagnose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "causes/term.hpp"
#include "core/error.hpp"
#include "diagnosis/chosen_readings.hpp"
#include "diagnosis/diagnosis_result.hpp"
#include "diagnosis/fit/intervals.hpp"
#include "diagnosis/fit/problem.hpp"
#include "diagnosis/fit/set_readings.hpp"
#include "diagnosis/plan/next_measurement.hpp"
#include "diagnosis/search/candidates.hpp"
#include "diagnosis/verdict/confirmation.hpp"
#include "diagnosis/verdict/explained.hpp"
#include "diagnosis/verdict/model_doubts.hpp"
#include "diagnosis/verdict/outlier_forecasts.hpp"
#include "diagnosis/verdict/outlier_groups.hpp"
#include "diagnosis/verdict/run_words.hpp"
#include "diagnosis/whole_columns.hpp"
#include "numerics/streams.hpp"

namespace reeve::diagnosis {
namespace {

void require_some_tension(const MeasuredData& data) {
  const std::vector<bool> dead = reads_zero_alone(data);
  if (std::ranges::find(dead, false) != dead.end()) return;
  throw InputError({.what = "every tension in the data",
                    .value = "0",
                    .expected = "a sensor that reads something"});
}

// A term that is of a column, a sensor or a contact that the readings lack would be looked for in
// vain.
void require_terms_to_show(const std::vector<Effect>& terms, const Dataset& readings,
                           const Model& nominal) {
  const Forecast without_it = forecast(readings, nominal);
  for (const Effect& term : terms) {
    Model with_it = nominal;
    add_effect(with_it, term);
    const auto at = try_forecast(readings, with_it);
    if (at && at->reading_N != without_it.reading_N) continue;
    throw InputError({.what = effect_name(term) + " changes no tension of the readings",
                      .expected = "a site and a covariate of theirs, and a value a other than 0"});
  }
}

bool is_of_a_group(const Effect& effect) {
  const causes::Term* term = causes::term_of(*effect.cause);
  return term != nullptr && !term->site.group.empty();
}

// A cause with two parameters and noise that nothing else tells would leave six.
constexpr double too_few_degrees = 8;

class Diagnosis {
 public:
  Diagnosis(const MeasuredData& data, const Hardware& hardware, const DiagnoseOptions& options)
      : whole_(whole_columns(data)),
        data_(whole_.data),
        options_(options),
        workers_(options.threads, options.stop),
        sample_(sample(data_, options.hold_out, options.seed, whole_.incomplete)) {
    nominal_.hardware = hardware;
    result_.model = nominal_;
    const SampleCounts& counts = sample_;
    static_cast<SampleCounts&>(result_) = counts;
    note_what_the_model_doubts();
  }

  DiagnosisResult run() {
    require_terms_to_show(options_.terms, sample_.training, nominal_);
    candidates_ = candidates(survey(data_), nominal_.hardware, force_scale(data_));
    if (sample_.training.degrees_of_freedom() < too_few_degrees) note_too_few();
    const bool is_shifted = is_noted(NoteKind::shifted_rows);
    // Coefficients fitted to motor tensions of other rows are of no use.
    if (is_shifted) candidates_.clear();
    if (too_few_ || is_shifted) {
      found_ = nothing_explained(sample_.training, nominal_, candidates_, options_, workers_);
      take_over_found();
    } else {
      find_causes();
      take_over_found();
      state_gains();
      begin("checking what is left");
      check_residual_structure();
      begin("looking for readings far off");
      check_far_readings();
      begin("comparing groups");
      compare_groups();
    }
    const auto intervals =
        parameter_intervals(found_.problem, found_.model, found_.mounting_degrees());
    const bool bends_are_recorded = std::ranges::any_of(data_.readings, [](const Reading& reading) {
      return reading.sheath_angle_rad.has_value();
    });
    describe(result_.causes, found_.model, nominal_.hardware, intervals, force_scale(data_),
             bends_are_recorded);
    add_partial_residuals(intervals);
    note_runs_apart();
    note_shifted_rows();
    begin("looking for leads");
    find_leads();
    // If nothing is named, the hardware file stands, and its coefficients with it.
    if (result_.causes.empty()) {
      result_.model = nominal_;
      result_.residual_after_N = result_.residual_before_N;
    } else {
      result_.model.conditions = typical_conditions(data_, readings_used());
    }
    decide();
    begin("choosing the next measurement");
    plan_measurements();
    begin("leaving out one run after the other");
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
  // Throws Stopped once the options' `stop` is set.
  void begin(const char* stage) {
    if (options_.stage) options_.stage(stage);
    workers_.go_on();
  }

  bool is_noted(NoteKind kind) const {
    return std::ranges::any_of(result_.notes,
                               [&](const DataNote& note) { return note.kind == kind; });
  }

  // Before anything is fitted, and where the tensions alone have not said it.
  void note_what_the_model_doubts() {
    if (!is_noted(NoteKind::units)) {
      for (DataNote& note : notes_on_channel_units(dataset(data_, readings_used()), nominal_)) {
        result_.notes.push_back(std::move(note));
      }
    }
    if (auto note = note_on_shifted_rows(data_, readings_used(), nominal_)) {
      result_.notes.push_back(std::move(*note));
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

  void find_causes() {
    TermSearch search(sample_.training, nominal_, candidates_, options_, workers_);
    found_ = search.run([this](const char* stage) { begin(stage); });
    begin("repeating the search by folds");
    std::vector<Fold> folds =
        cross_validated(data_, readings_in(sample_.training), nominal_, search, workers_);
    result_.folds = folds.size();
    confirmation_.emplace(sample_.training, nominal_, options_, std::move(folds), found_, workers_);
    result_.not_confirmed = confirmation_->remove_the_others();
  }

  // No smaller chance than the replicates could tell of a cause.
  double resolved(double p_value) const {
    return std::max(p_value, 1 / static_cast<double>(options_.replicates + 1));
  }

  void take_over_found() {
    result_.noise = found_.scatter.noise;
    result_.mounting = found_.scatter.mounting;
    result_.model = found_.model;
    result_.p_value = std::min(1.0, std::exp(-found_.best_refused));
    result_.most_causes = found_.most_causes;
    std::vector<NamedWithOthers> named;
    for (std::size_t i = 0; i < found_.calibrations.size(); ++i) {
      const Calibration& calibration = found_.calibrations[i];
      CalibratedCoefficient coefficient{effect_name(calibration.effect),
                                        estimated(calibration.effect, 0, calibration.interval,
                                                  nominal_.hardware, force_scale(data_)),
                                        resolved(calibration.p_value), calibration.differs};
      if (coefficient.differs) {
        named.push_back({named_cause(calibration.effect, coefficient.p_value), &found_.instead[i]});
        result_.p_value = std::min(result_.p_value, coefficient.p_value);
      }
      result_.calibration.push_back(std::move(coefficient));
    }
    for (const AcceptedTerm& accepted : found_.accepted) take_over(accepted, named);
    weigh_by_residuals(named);
    for (NamedWithOthers& each : named) {
      note_alternatives(each.cause, *each.others);
      result_.causes.push_back(std::move(each.cause));
    }
  }

  struct NamedWithOthers {
    NamedCause cause;
    const std::vector<Alternative>* others;
  };

  // Sorts the causes by the residuals that they explain, the greatest share first.
  void weigh_by_residuals(std::vector<NamedWithOthers>& named) {
    std::vector<Effect> terms;
    for (const NamedWithOthers& each : named) terms.push_back(each.cause.effect);
    std::vector<Effect> apart;
    for (const RunsApart& runs : result_.apart) apart.push_back(runs.effect);
    const ExplainedResiduals by =
        explained_residuals(sample_, found_.problem, nominal_, result_.model, terms, apart);
    result_.residual_before_N = by.before_N;
    result_.residual_after_N = by.after_N;
    for (std::size_t i = 0; i < named.size(); ++i) named[i].cause.explained = by.terms[i];
    std::ranges::stable_sort(named, [](const NamedWithOthers& a, const NamedWithOthers& b) {
      return a.cause.explained.share > b.cause.explained.share;
    });
  }

  // Over what each named term follows, beside its fitted law.
  void add_partial_residuals(const std::vector<std::vector<ParameterInterval>>& intervals) {
    if (result_.causes.empty()) return;
    const auto spreads = effect_spreads(found_.problem, found_.model, intervals);
    for (NamedCause& cause : result_.causes) {
      cause.partial = partial_residuals(sample_, result_.model, found_.scatter,
                                        place(result_.model, cause.effect),
                                        spreads[place(found_.model, cause.effect)], workers_);
    }
  }

  void find_leads() {
    const bool is_asked = result_.unexplained || !result_.not_confirmed.empty() ||
                          result_.structure_p_value <= options_.alpha;
    if (too_few_ || is_noted(NoteKind::shifted_rows) || !is_asked) return;
    result_.leads = leads(sample_, found_.problem, found_.model, found_.scatter, workers_);
  }

  void take_over(const AcceptedTerm& accepted, std::vector<NamedWithOthers>& named) {
    if (const auto runs = runs_apart(accepted); !runs.empty()) {
      result_.apart.push_back({runs, accepted.effect, accepted.evidence, what_differs(accepted)});
      result_.model = without(result_.model, place(result_.model, accepted.effect));
      return;
    }
    NamedCause cause = named_cause(accepted.effect, resolved(std::exp(-accepted.evidence)));
    result_.p_value = std::min(result_.p_value, cause.p_value);
    cause.evidence = accepted.evidence;
    cause.probability = accepted.probability;
    cause.folds = accepted.folds;
    named.push_back({std::move(cause), &accepted.alternatives});
  }

  void note_alternatives(NamedCause& cause, const std::vector<Alternative>& alternatives) {
    std::vector<std::string> names{cause.name};
    std::vector<Model> models{found_.model};
    for (const Alternative& other : alternatives) {
      const std::string name = other.name();
      if (std::ranges::find(names, name) != names.end()) continue;
      if (!cause.runner_up) cause.runner_up = RunnerUp{name, other.deficit};
      names.push_back(name);
      if (alias_models_.empty()) models.push_back(with(other));
    }
    if (names.size() > 1) {
      result_.indistinguishable.push_back(names);
      if (alias_models_.empty()) alias_models_ = std::move(models);
    }
  }

  // The model that the answer states, with the alternative.
  Model with(const Alternative& other) const {
    Model model = found_.model;
    for (const Effect& effect : other.instead_of) model = without(model, place(model, effect));
    add_effect(model, other.effect);
    return fit(found_.problem, model).model;
  }

  // Computes the gains of the named causes on held-out runs.
  void state_gains() {
    const bool is_sealed = !sample_.held_out.cells.empty();
    const std::vector<Fold>& folds = confirmation_->folds();
    if (!is_sealed && folds.empty()) return;
    const Model& after = found_.model;
    const Dataset& part = is_sealed ? sample_.held_out : sample_.training;
    const Problem unseen = problem(part, found_.scatter, after, workers_);
    const Forecast first =
        is_sealed ? forecast(part, nominal_) : joined(folds, part, &Fold::nominal);
    const Forecast second =
        is_sealed ? forecast(part, after) : joined(folds, part, &Fold::forecast);
    if (!is_sealed) result_.held_out_runs = result_.runs;
    result_.noise_limit = noise_limit(unseen, first);
    result_.run_gains = run_gains(unseen, first, second);
    if (result_.causes.empty()) return;
    bool can_gain = is_sealed;
    for (std::size_t c = 0; c < result_.causes.size(); ++c) {
      NamedCause& cause = result_.causes[c];
      if (!is_sealed) cause.only_run = only_run(cause);
      if (!cause.only_run.empty()) continue;
      can_gain = true;
      cause.held_out = gain_of(cause, unseen, second, c);
    }
    if (can_gain) result_.held_out = held_out_gain(unseen, first, second, options_.seed);
    weigh(misfit(found_.problem, nominal_) - misfit(found_.problem, after));
  }

  // The run that has all readings that the cause changes; empty if several have some.
  std::string only_run(const NamedCause& cause) const {
    const Model less = without(found_.model, place(found_.model, cause.effect));
    const Forecast with_it = forecast(sample_.training, found_.model);
    const auto without_it = try_forecast(sample_.training, less);
    if (!without_it) return {};
    std::set<std::size_t> runs;
    for (std::size_t i = 0; i < sample_.training.cells.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (with_it.reading_N[k] == without_it->reading_N[k]) continue;
      runs.insert(data_.readings[sample_.training.cells[i].reading].run);
    }
    return runs.size() == 1 ? data_.runs[*runs.begin()] : "";
  }

  // `gain` is twice that of the named causes in log-likelihood.
  void weigh(double gain) {
    std::vector<std::string> names;
    for (const NamedCause& cause : result_.causes) names.push_back(cause.name);
    result_.weighed.push_back({names, gain / 2, result_.held_out});
    for (const AcceptedTerm& accepted : found_.accepted) {
      const std::string own = effect_name(accepted.effect);
      for (const Alternative& other : accepted.alternatives) {
        std::vector<std::string> instead = names;
        std::ranges::replace(instead, own, other.name());
        result_.weighed.push_back({std::move(instead), gain / 2 - other.deficit, std::nullopt});
      }
    }
  }

  // The gain is of one cause, with all others kept.
  HeldOut gain_of(const NamedCause& cause, const Problem& unseen, const Forecast& after,
                  std::size_t c) {
    const bool is_sealed = !sample_.held_out.cells.empty();
    const Forecast less =
        is_sealed
            ? forecast(sample_.held_out, fitted_without(found_.problem, found_.model, cause.name))
            : confirmation_->without(cause.name);
    return held_out_gain(unseen, less, after, options_.seed + c);
  }

  void check_residual_structure() {
    result_.row_scatter = row_scatter(found_.problem, forecast(sample_.training, found_.model));
    const StructureResult left = residual_structure(
        found_.problem, found_.model, found_.scatter.mounting, options_.alpha,
        {streams::seed_of_residual_structure(options_.seed), options_.replicates}, workers_);
    result_.structure = left.findings;
    result_.structure_p_value = left.p_value;
    const bool is_chance = left.p_value >= structure_share_of_alpha * options_.alpha;
    if (!is_chance && leaves_more_than_noise()) {
      result_.unexplained = {left.findings.front().about, left.where, left.p_value};
    }
  }

  // True if the residuals clearly exceed the scatter of readings that no smooth law explains, and
  // matter in size. Effects of mountings may follow anything.
  bool leaves_more_than_noise() const {
    constexpr double clearly = 1.2;
    constexpr double matters = 0.002;  // share of the readings
    const Dataset& dataset = sample_.training;
    const Forecast at = forecast(dataset, found_.model);
    const Eigen::VectorXd left =
        own_residuals(found_.problem, at).cwiseProduct(found_.problem.deviation_N);
    if (left.norm() < matters * found_.problem.measured_N.norm()) return false;
    const auto measured = noise_without_model(dataset);
    if (const auto set = set_readings(dataset)) return !set->several;
    if (!measured) return true;
    const Eigen::VectorXd fitted = deviations_if_near(dataset, result_.noise, at.reading_N);
    const Eigen::VectorXd smooth = deviations_if_near(dataset, *measured, at.reading_N);
    return (fitted.array() / smooth.array()).log().mean() > std::log(clearly);
  }

  void check_far_readings() {
    std::optional<Problem> unseen;
    if (!sample_.held_out.cells.empty()) {
      unseen = problem(sample_.held_out, found_.scatter, found_.model, workers_);
    }
    const OutlierReadings far = outlier_readings_together(
        {found_.problem,
         unseen ? &*unseen : nullptr,
         found_.model,
         result_.noise,
         result_.mounting,
         options_.alpha,
         {streams::seed_of_residual_structure(options_.seed), options_.replicates}},
        workers_);
    for (const OutlierGroups& together : far.together) {
      result_.notes.push_back(note_on(together, far, data_, options_.alpha));
      if (result_.unexplained || !follow_something(together, options_.alpha)) continue;
      result_.unexplained = {"channel and run", where_text(together, data_),
                             resolved(together.p_value)};
    }
  }

  void plan_measurements() {
    const MeasurementPlan plan =
        measurement_plan(*found_.problem.dataset, options_.routings, found_.scatter);
    if (!alias_models_.empty()) {
      result_.separating_measurement =
          separating_measurement(plan, alias_models_, result_.indistinguishable.front());
      result_.next_measurement = result_.separating_measurement;
    } else if (!result_.causes.empty()) {
      const NamedCause& cause = result_.causes.front();
      result_.next_measurement = shrinking_measurement(plan, found_.problem, found_.model,
                                                       place(found_.model, cause.effect));
    }
  }

  // No chance makes the row beside it fit so much better.
  void note_shifted_rows() {
    if (!is_noted(NoteKind::shifted_rows)) return;
    result_.unexplained = {"row", "motor_tension_N", resolved(0)};
  }

  void decide() {
    if (too_few_) {
      result_.verdict = Verdict::too_few;
    } else if (result_.unexplained) {
      result_.verdict = Verdict::unexplained;
    } else if (!result_.indistinguishable.empty()) {
      result_.verdict = Verdict::indistinguishable;
    } else {
      result_.verdict = result_.causes.empty() ? Verdict::none : Verdict::cause;
    }
  }

  void note_runs_apart() {
    if (result_.apart.empty() || result_.unexplained) return;
    const RunsApart& first = result_.apart.front();
    result_.unexplained = {"run", first.text, resolved(std::exp(-first.evidence))};
  }

  std::vector<std::size_t> readings_used() const {
    std::vector<std::size_t> readings;
    for (const Dataset* part : {&sample_.training, &sample_.held_out}) {
      for (const DatasetRow& row : part->rows) readings.push_back(row.reading);
    }
    std::ranges::sort(readings);
    return readings;
  }

  // A difference that a term of one group states is explained by it. The sizes are told without
  // it, each group's own beside the others'.
  void compare_groups() {
    Model alike = found_.model.effects.empty() ? found_.base : found_.model;
    const std::size_t terms = alike.effects.size();
    std::erase_if(alike.effects, is_of_a_group);
    result_.by_group = estimates_by_group(data_, readings_used(), alike, found_.scatter,
                                          found_.mounting_degrees(), options_.alpha, workers_);
    if (result_.unexplained || alike.effects.size() < terms) return;
    double least = structure_share_of_alpha * options_.alpha;
    for (const EstimatesByGroup& of : result_.by_group) {
      const double p_value = resolved(of.p_value);
      if (p_value >= least) continue;
      least = p_value;
      result_.unexplained = {"group", of.cause + " in " + data_.groups[of.farthest], p_value};
    }
  }

  // After every decision: it says what each run contributed to it.
  void leave_out_runs() {
    const std::vector<std::size_t> readings = readings_used();
    result_.left_out = left_out_runs(data_, readings, result_.model, found_.scatter, workers_);
  }

  const WholeColumns whole_;
  const MeasuredData& data_;
  const DiagnoseOptions& options_;
  Workers workers_;
  Sample sample_;
  bool too_few_ = false;
  Model nominal_;
  Explanation found_;
  std::vector<Effect> candidates_;
  std::optional<Confirmation> confirmation_;
  std::vector<Model> alias_models_;  // models of the first causes that cannot be told apart
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
