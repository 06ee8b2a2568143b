#include "diagnosis/search/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "diagnosis/fit/left_noise.hpp"
#include "diagnosis/search/cross_validation.hpp"

namespace reeve::diagnosis {
namespace {

// A second name has to stand against a smaller chance than the first.
constexpr double further_share_of_alpha = 0.5;
// Independent readings that each cause takes, and more causes than anybody would believe.
constexpr double readings_of_a_cause = 12;
constexpr double most_believed = 6;
// Left-out gain, in log-likelihood, below which the training runs speak against a cause. About 0
// they say nothing: what they know of it may all stand in one run.
constexpr double refuted = -2;

std::size_t carried_causes(const Dataset& training) {
  const double carried = std::floor(training.degrees_of_freedom() / readings_of_a_cause);
  return static_cast<std::size_t>(std::clamp(carried, 1.0, most_believed));
}

class Explaining {
 public:
  Explaining(const Dataset& training, const Model& nominal,
             const std::vector<Candidate>& candidates, const ExplanationOptions& options,
             Workers& workers)
      : training_(training), nominal_(nominal), options_(options), workers_(workers) {
    for (const Candidate& candidate : candidates) {
      const bool is_open = is_open_coefficient(candidate.effect, nominal.hardware);
      (is_open ? coefficients_ : causes_).push_back(candidate);
    }
    result_.most_causes = options.most_causes.value_or(carried_causes(training));
  }

  void calibrate() {
    measured_ = noise_without_model(training_);
    result_.base = nominal_;
    // What readings weigh, and what fits them, in turn.
    for (int round = 0; round < 2; ++round) {
      rescatter(result_.problem, result_.base);
      result_.base = calibrated(result_.problem, nominal_, coefficients_, workers_);
    }
    rescatter(result_.problem, result_.base);
    result_.model = result_.base;
  }

  // More scatter than mountings of any rig have is believed only where causes that are found
  // without it are no likelier.
  bool find(const std::function<bool(const char*)>& stop) {
    const Explanation before = result_;
    if (!search(stop)) return false;
    if (!is_beyond_belief(result_.scatter.mounting)) return true;
    const Explanation unbounded = std::exchange(result_, before);
    is_bounded_ = true;
    rescatter(result_.problem, result_.base);
    result_.base = calibrated(result_.problem, nominal_, coefficients_, workers_);
    result_.model = result_.base;
    if (!search(stop)) return false;
    if (unlikelihood(result_) < unlikelihood(unbounded)) return true;
    is_bounded_ = false;
    result_ = unbounded;
    return true;
  }

  bool search(const std::function<bool(const char*)>& stop) {
    const CauseSearchOptions options{options_.alpha, further_share_of_alpha * options_.alpha,
                                     options_.replicates, result_.most_causes, options_.seed};
    auto found = search_causes(
        result_.problem, result_.base, causes_, options, result_.scatter.mounting, workers_,
        [this](Problem& problem, const Model& model) { rescatter(problem, model); },
        [&] { return stop("searching for causes"); });
    if (!found) return false;
    result_.model = std::move(found->model);
    result_.accepted = std::move(found->accepted);
    result_.p_value =
        result_.accepted.empty() ? found->p_value_of_next : result_.accepted.front().p_value;
    return true;
  }

  // Decided by the training runs, each forecast from the others: what the held-out runs say of the
  // named causes is then no choice of theirs. The weakest goes first, since it may have stood in
  // the others' way.
  bool drop_unconfirmed(const std::function<bool(const char*)>& stop) {
    while (!result_.accepted.empty()) {
      if (stop("confirming the causes")) return false;
      const LeftOutMisfits with_all = left_out_misfits(result_.problem, result_.model);
      double least = refuted;
      std::size_t weakest = result_.accepted.size();
      for (std::size_t c = 0; c < result_.accepted.size(); ++c) {
        const Model before = without_cause(c);
        const double gain = left_out_gain(left_out_misfits(result_.problem, before), with_all);
        if (gain >= least) continue;
        least = gain;
        weakest = c;
      }
      if (weakest == result_.accepted.size()) return true;
      drop(weakest, result_.not_confirmed);
    }
    return true;
  }

  // An interval that holds the nominal size, or a size at the end of what was searched, says that
  // the cause may be none, or another.
  void drop_unsure() {
    for (std::size_t c = 0; c < result_.accepted.size();) {
      if (is_sure(result_.accepted[c])) {
        ++c;
      } else {
        drop(c, result_.not_sure);
        c = 0;
      }
    }
  }

  void judge_coefficients() {
    result_.calibrations =
        calibrations(result_.problem, result_.model, result_.mounting_degrees(), options_.alpha);
    result_.alpha = options_.alpha;
  }

  Explanation take() { return std::move(result_); }

 private:
  // What a model leaves of many mountings contains what differs between them; of a few it cannot.
  bool noise_contains_mountings() const {
    constexpr std::size_t few = 4;
    return mountings(training_).size() >= few;
  }

  // Where the readings follow something that no smooth law says, what a law leaves is no noise: a
  // model that leaves clearly less knows better.
  bool leaves_less(const Noise& within, const Forecast& at) const {
    constexpr double clearly = 0.85;
    const Eigen::VectorXd left = deviations(training_, within, at.reading_N);
    const Eigen::VectorXd smooth = deviations(training_, *measured_, at.reading_N);
    return (left.array() / smooth.array()).log().mean() < std::log(clearly);
  }

  // Whether the noise is that of readings of one mounting.
  bool estimate_noise(const Model& model, const MountingModes& modes, const Forecast& at) {
    Noise& noise = result_.scatter.noise;
    const auto within = noise_left_within_mountings(training_, model, modes);
    const bool measured_within = measured_ && measured_->within_mountings;
    if (within && (!measured_within || leaves_less(*within, at))) {
      noise = *within;
      return true;
    }
    if (measured_within) {
      noise = *measured_;
      return true;
    }
    noise = measured_ ? *measured_ : noise_left_by(training_, model);
    return !noise_contains_mountings();
  }

  // What is not explained yet may look as if mountings differed.
  void rescatter(Problem& problem, const Model& model) {
    Scatter& scatter = result_.scatter;
    const Forecast at = forecast(training_, model);
    const MountingModes modes = mounting_modes(training_, model, workers_);
    const bool knows_mountings = estimate_noise(model, modes, at);
    problem = diagnosis::problem(training_, deviations(training_, scatter.noise, at.reading_N));
    settle_motor_deviations(problem, at);
    scatter.mounting = {};
    if (!knows_mountings) return;
    scatter.mounting = mounting_scatter(problem, at, modes, options_.mounting_scatter);
    if (is_bounded_) scatter.mounting = believed(scatter.mounting);
    share_scatter(problem, modes, scatter.mounting.relative, at);
  }

  // Twice the negative log-likelihood, each parameter counted with half the logarithm of the number
  // of readings (G. Schwarz, Annals of Statistics 6, 1978).
  double unlikelihood(const Explanation& explanation) const {
    return misfit(explanation.problem, explanation.model) + log_determinant(explanation.problem) +
           static_cast<double>(parameter_count(explanation.model)) *
               std::log(training_.degrees_of_freedom());
  }

  Model without_cause(std::size_t cause) const {
    const std::size_t at = place(result_.model, result_.accepted[cause].effect);
    return fit(result_.problem, without(result_.model, at)).model;
  }

  void drop(std::size_t cause, std::vector<std::string>& to) {
    to.push_back(effect_name(result_.accepted[cause].effect));
    result_.model = without_cause(cause);
    rescatter(result_.problem, result_.model);
    result_.model = fit(result_.problem, result_.model).model;
    result_.accepted.erase(result_.accepted.begin() + static_cast<std::ptrdiff_t>(cause));
  }

  bool is_sure(const AcceptedCause& accepted) const {
    constexpr double near = 1e-3;  // of the range
    const std::size_t e = place(result_.model, accepted.effect);
    const Effect& effect = result_.model.effects[e];
    const auto parameters =
        searched_parameters(*effect.cause, nominal_.hardware, result_.problem.force_scale);
    if (parameters.empty()) return true;
    const ParameterInterval size =
        parameter_intervals(result_.problem, result_.model, result_.mounting_degrees())[e].front();
    const Range range = parameters.front().range;
    const double nominal = *parameters.front().nominal;
    const double margin = near * (range.high - range.low);
    const double value = effect.values.front();
    const bool at_end = value <= range.low + margin || value >= range.high - margin;
    return (size.low > nominal || size.high < nominal) &&
           (!at_end || parameters.front().ends_by_nature);
  }

  const Dataset& training_;
  const Model& nominal_;
  const ExplanationOptions& options_;
  Workers& workers_;
  std::vector<Candidate> coefficients_;
  std::vector<Candidate> causes_;
  std::optional<Noise> measured_;
  bool is_bounded_ = false;  // the scatter of mountings, to what is believed of rigs
  Explanation result_;
};

}  // namespace

double Explanation::mounting_degrees() const {
  double degrees = 0;
  for (const Mounted kind : {Mounted::sheath, Mounted::tube, Mounted::bearing}) {
    if (is_told(scatter.mounting, kind)) {
      degrees += scatter.mounting.told_by[static_cast<std::size_t>(kind)];
    }
  }
  return degrees > 0 ? degrees : std::numeric_limits<double>::infinity();
}

Explanation nothing_explained(const Dataset& training, const Model& nominal,
                              const ExplanationOptions& options, Workers& workers) {
  Explaining explaining(training, nominal, {}, options, workers);
  explaining.calibrate();
  return explaining.take();
}

std::optional<Explanation> explain(const Dataset& training, const Model& nominal,
                                   const std::vector<Candidate>& candidates,
                                   const ExplanationOptions& options, Workers& workers,
                                   const std::function<bool(const char*)>& stop) {
  Explaining explaining(training, nominal, candidates, options, workers);
  if (stop("calibrating coefficients")) return std::nullopt;
  explaining.calibrate();
  if (!explaining.find(stop)) return std::nullopt;
  if (!explaining.drop_unconfirmed(stop)) return std::nullopt;
  explaining.drop_unsure();
  explaining.judge_coefficients();
  return explaining.take();
}

void take_back_last(Explanation& explanation, Workers& workers) {
  const Effect last = explanation.accepted.back().effect;
  explanation.accepted.pop_back();
  explanation.model =
      fit(explanation.problem, without(explanation.model, place(explanation.model, last))).model;
  if (explanation.accepted.empty()) explanation.model = explanation.base;
  explanation.problem =
      problem(*explanation.problem.dataset, explanation.scatter, explanation.model, workers);
  explanation.calibrations = calibrations(explanation.problem, explanation.model,
                                          explanation.mounting_degrees(), explanation.alpha);
}

}  // namespace reeve::diagnosis
