#include "diagnosis/diagnose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "diagnosis/data/sample.hpp"
#include "diagnosis/model/fit.hpp"
#include "diagnosis/model/intervals.hpp"
#include "diagnosis/model/left_noise.hpp"
#include "diagnosis/model/null_model.hpp"
#include "diagnosis/model/problem.hpp"
#include "diagnosis/search/candidates.hpp"
#include "diagnosis/search/cause_search.hpp"
#include "diagnosis/search/cross_validation.hpp"
#include "diagnosis/search/rivals.hpp"
#include "diagnosis/search/weighed.hpp"
#include "numerics/streams.hpp"

namespace reeve::diagnosis {
namespace {

// A second name has to stand against a smaller chance than the first.
constexpr double further_share_of_alpha = 0.5;
// A cause with two parameters and noise that nothing else tells would leave six.
constexpr double too_few_degrees = 8;
// Left-out gain, in log-likelihood, below which the training runs speak against a cause. About 0
// they say nothing: what they know of it may all stand in one run.
constexpr double refuted = -2;

class Diagnosis {
 public:
  Diagnosis(const MeasuredData& data, const Hardware& hardware, const DiagnoseOptions& options)
      : data_(data),
        options_(options),
        workers_(options.threads),
        sample_(sample(data, options.hold_out, options.seed)) {
    nominal_.hardware = hardware;
    result_.model = nominal_;
    take_over_counts();
  }

  std::optional<DiagnosisResult> run() {
    estimate_noise();
    if (sample_.training.degrees_of_freedom() < too_few_degrees) {
      note_too_few();
    } else {
      if (!find_causes()) return std::nullopt;
      if (!drop_unconfirmed()) return std::nullopt;
      if (!weigh_rivals()) return std::nullopt;
      confirm();
      if (!stopped("checking what is left")) check_what_is_left();
    }
    if (stop_) return std::nullopt;
    describe_causes();
    decide();
    if (stopped("choosing the next measurement")) return std::nullopt;
    plan_measurements();
    if (stopped("leaving out one run after the other")) return std::nullopt;
    leave_out_runs();
    result_.cells =
        compared_cells(sample_, nominal_, result_.model, result_.noise, result_.left_out);
    result_.share_errors = share_errors(data_, result_.cells);
    result_.losses = losses(data_, result_.model, result_.cells);
    result_.without_apart =
        without_apart(data_, result_.model, result_.noise, result_.cells, result_.losses);
    return std::move(result_);
  }

 private:
  bool stopped(const char* stage) {
    if (options_.stage && options_.stage(stage)) stop_ = true;
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

  void note_too_few() {
    too_few_ = true;
    result_.notes.push_back(
        {NoteKind::not_compared,
         fmt::format("{:.0f} independent readings in the training runs are too few to say "
                     "anything: expected at least {:.0f}",
                     sample_.training.degrees_of_freedom(), too_few_degrees),
         {}});
  }

  void estimate_noise() {
    const std::optional<Noise> measured = noise_without_model(sample_.training);
    noise_is_measured_ = measured.has_value();
    result_.noise = measured ? *measured : noise_left_by(sample_.training, nominal_);
    problem_ = problem(sample_.training, deviations_under(sample_.training, nominal_));
  }

  Eigen::VectorXd deviations_under(const Dataset& part, const Model& model) const {
    return deviations(part, result_.noise, forecast(part, model).reading_N);
  }

  void update_noise(Problem& problem, const Model& model) {
    if (!noise_is_measured_) result_.noise = noise_left_by(sample_.training, model);
    problem.deviation_N = deviations_under(sample_.training, model);
  }

  bool find_causes() {
    candidates_ = candidates(survey(data_), nominal_.hardware);
    const CauseSearchOptions options{options_.alpha, further_share_of_alpha * options_.alpha,
                                     options_.replicates, options_.most_causes, options_.seed};
    auto found = search_causes(
        problem_, nominal_, candidates_, options, workers_,
        [this](Problem& problem, const Model& model) { update_noise(problem, model); },
        [this] { return stopped("searching for causes"); });
    if (!found) return false;
    result_.model = found->model;
    result_.p_value =
        found->accepted.empty() ? found->p_value_of_next : found->accepted.front().p_value;
    for (const AcceptedCause& accepted : found->accepted) {
      NamedCause cause;
      cause.effect = accepted.effect;
      cause.name = effect_name(accepted.effect);
      cause.p_value = accepted.p_value;
      result_.causes.push_back(std::move(cause));
    }
    return true;
  }

  // Decided by the training runs, each forecast from the others: what the held-out runs say of the
  // named causes is then no choice of theirs. The weakest goes first, since it may have stood in
  // the others' way.
  bool drop_unconfirmed() {
    while (!result_.causes.empty()) {
      if (stopped("confirming the causes")) return false;
      const LeftOutMisfits with_all = left_out_misfits(problem_, result_.model);
      double least = refuted;
      std::size_t weakest = result_.causes.size();
      Model kept;
      for (std::size_t c = 0; c < result_.causes.size(); ++c) {
        const std::size_t at = place(result_.model, result_.causes[c].effect);
        const Model before = fit(problem_, without(result_.model, at)).model;
        const double gain = left_out_gain(left_out_misfits(problem_, before), with_all);
        if (gain >= least) continue;
        least = gain;
        weakest = c;
        kept = before;
      }
      if (weakest == result_.causes.size()) return true;
      result_.not_confirmed.push_back(result_.causes[weakest].name);
      result_.model = kept;
      update_noise(problem_, result_.model);
      result_.causes.erase(result_.causes.begin() + static_cast<std::ptrdiff_t>(weakest));
    }
    return true;
  }

  bool weigh_rivals() {
    for (NamedCause& cause : result_.causes) {
      if (stopped("weighing other causes")) return false;
      rivals_.push_back(rivals(problem_, result_.model, place(result_.model, cause.effect),
                               candidates_, workers_));
      const std::vector<Rival>& others = rivals_.back();
      if (!others.empty()) cause.runner_up = RunnerUp{others.front().name, others.front().deficit};
      Indistinguishable group = indistinguishable(cause.name, result_.model, others);
      if (group.names.size() > 1) indistinguishable_.push_back(std::move(group));
    }
    return true;
  }

  // The held-out runs are opened here, once: every number that needs them is taken now.
  void confirm() {
    std::vector<std::string> names;
    for (const NamedCause& cause : result_.causes) names.push_back(cause.name);
    const auto weighed = weighed_models(problem_, nominal_, result_.model, names, rivals_);
    for (const WeighedModel& model : weighed) {
      result_.weighed.push_back({model.causes, model.gain, std::nullopt});
    }
    if (sample_.held_out.cells.empty()) return;
    const Problem unseen =
        problem(sample_.held_out, deviations_under(sample_.held_out, result_.model));
    for (std::size_t c = 0; c < result_.causes.size(); ++c) {
      NamedCause& cause = result_.causes[c];
      const Fit before = fit(problem_, without(result_.model, place(result_.model, cause.effect)));
      cause.held_out = held_out_gain(unseen, before.model, result_.model, options_.seed + c);
    }
    for (std::size_t i = 0; i < weighed.size(); ++i) {
      // In some held-out row it may have no tensions: nothing to weigh it by.
      if (!try_forecast(sample_.held_out, weighed[i].model)) continue;
      result_.weighed[i].held_out =
          held_out_gain(unseen, nominal_, weighed[i].model, options_.seed);
    }
    result_.noise_limit = noise_limit(unseen, nominal_);
    result_.run_gains = run_gains(unseen, nominal_, result_.model);
    if (!result_.causes.empty()) {
      result_.held_out = held_out_gain(unseen, nominal_, result_.model, options_.seed);
    }
  }

  void check_what_is_left() {
    const Forecast at = forecast(sample_.training, result_.model);
    const Projection projection(problem_, result_.model, at);
    const Eigen::VectorXd left = projection.taken_out(residuals(problem_, at));
    const NullModel null_model(problem_, projection, at,
                               streams::seed_of_what_is_left(options_.seed), options_.replicates);
    const auto tests = structure_tests(problem_, at, projection);
    const StructureResult found = find_structure(problem_, tests, left, null_model, workers_);
    result_.structure = found.findings;
    result_.structure_p_value = found.p_value;
    if (found.p_value < structure_share_of_alpha * options_.alpha) {
      result_.unexplained = {found.findings.front().about, found.where, found.p_value};
    }
  }

  void describe_causes() {
    const auto intervals = parameter_intervals(problem_, result_.model);
    for (NamedCause& cause : result_.causes) {
      const std::size_t e = place(result_.model, cause.effect);
      cause.effect = result_.model.effects[e];
      cause.meaning = cause.effect.cause->meaning();
      cause.detail = detail(cause.effect);
      const auto parameters = cause.effect.cause->parameters(nominal_.hardware);
      for (std::size_t p = 0; p < parameters.size(); ++p) {
        cause.parameters.push_back({parameters[p].name, parameters[p].unit, cause.effect.values[p],
                                    intervals[e][p].low, intervals[e][p].high,
                                    parameters[p].nominal, parameters[p].literature});
      }
    }
  }

  // The data's routings first: what is on the rig is easiest to measure again.
  MeasurementPlan plan() const {
    MeasurementPlan plan{&data_, {}, result_.noise};
    const auto add = [&](const MeasurableRouting& routing) {
      const bool known =
          std::any_of(plan.routings.begin(), plan.routings.end(),
                      [&](const MeasurableRouting& other) { return other.word == routing.word; });
      if (!known) plan.routings.push_back(routing);
    };
    for (const MeasuredRouting& measured : data_.routings) add({measured.word, measured.routing});
    for (const MeasurableRouting& routing : options_.routings) add(routing);
    return plan;
  }

  void plan_measurements() {
    const MeasurementPlan plan = this->plan();
    for (const Indistinguishable& group : indistinguishable_) {
      result_.indistinguishable.push_back(group.names);
    }
    if (!indistinguishable_.empty()) {
      const Indistinguishable& group = indistinguishable_.front();
      result_.separating_measurement = separating_measurement(plan, group.models[0], group.names[0],
                                                              group.models[1], group.names[1]);
      result_.next_measurement = result_.separating_measurement;
    } else if (!result_.causes.empty()) {
      const NamedCause& cause = result_.causes.front();
      result_.next_measurement =
          shrinking_measurement(plan, problem_, result_.model, place(result_.model, cause.effect));
    }
  }

  void decide() {
    if (too_few_) {
      result_.verdict = Verdict::too_few;
    } else if (result_.unexplained) {
      result_.verdict = Verdict::unexplained;
    } else if (!indistinguishable_.empty()) {
      result_.verdict = Verdict::indistinguishable;
    } else {
      result_.verdict = result_.causes.empty() ? Verdict::none : Verdict::cause;
    }
  }

  // After every decision: it says what each run contributed to it.
  void leave_out_runs() {
    std::vector<std::size_t> readings;
    for (const Dataset* part : {&sample_.training, &sample_.held_out}) {
      for (const DatasetRow& row : part->rows) readings.push_back(row.reading);
    }
    std::sort(readings.begin(), readings.end());
    result_.left_out = left_out_runs(data_, readings, result_.model, result_.noise, workers_);
  }

  const MeasuredData& data_;
  const DiagnoseOptions& options_;
  Workers workers_;
  Sample sample_;
  bool stop_ = false;
  bool too_few_ = false;
  bool noise_is_measured_ = false;
  Model nominal_;
  Problem problem_;
  std::vector<Candidate> candidates_;
  std::vector<Indistinguishable> indistinguishable_;
  std::vector<std::vector<Rival>> rivals_;  // parallel to the causes
  DiagnosisResult result_;
};

}  // namespace

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::none:
      return "none";
    case Verdict::cause:
      return "cause";
    case Verdict::unexplained:
      return "unexplained";
    case Verdict::indistinguishable:
      return "indistinguishable";
    case Verdict::too_few:
      return "too_few";
  }
  return "";
}

std::optional<DiagnosisResult> diagnose_until(const MeasuredData& data, const Hardware& hardware,
                                              const DiagnoseOptions& options) {
  return Diagnosis(data, hardware, options).run();
}

DiagnosisResult diagnose(const MeasuredData& data, const Hardware& hardware,
                         const DiagnoseOptions& options) {
  return *diagnose_until(data, hardware, options);
}

}  // namespace reeve::diagnosis
