#include "diagnosis/search/term_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "causes/library.hpp"

namespace reeve::diagnosis {
namespace {

// Independent readings that each cause takes, and more causes than anybody would believe.
constexpr double readings_of_a_term = 12;
constexpr double most_terms = 6;
// Nats by which another term has to be likelier to take a place.
constexpr double clearly_likelier = 0.5;

std::size_t carried_terms(const Dataset& dataset) {
  const double carried = std::floor(dataset.degrees_of_freedom() / readings_of_a_term);
  return static_cast<std::size_t>(std::clamp(carried, 1.0, most_terms));
}

// How many terms get a fit in a step.
struct Effort {
  std::size_t causes = 7;
  std::size_t faults = 3;  // causes without a size
  std::size_t laws = 6;
  // A search on more readings has been made: readings are seen at the level of what it found, and
  // without weighing alternatives.
  std::optional<ScatterLevel> level{};
  // True if causes without a size are tried beside the hardware's coefficients, too.
  bool beside_hardware = true;
};

// A term that may join a model, with the problem that it is fitted by.
struct Contender {
  Effect effect;
  std::vector<std::vector<double>> starts;
  double price = 0;
  const Likelihood* seen_by = nullptr;
};

struct Scored {
  Model model;
  Likelihood likelihood;
  double evidence = -std::numeric_limits<double>::infinity();
  AcceptedTerm term;  // the term that was added
};

class Searching {
 public:
  Searching(const Dataset& dataset, const Model& nominal,
            const std::vector<Candidate>& coefficients, const std::vector<Candidate>& causes,
            const TermSearchOptions& options, const Effort& effort, Workers& workers,
            const std::function<const Screened&(const Model&, std::size_t)>& screened)
      : dataset_(dataset),
        nominal_(nominal),
        coefficients_(coefficients),
        causes_(causes),
        options_(options),
        effort_(effort),
        workers_(workers),
        screened_(screened) {
    result_.most_causes = options.most_causes.value_or(carried_terms(dataset));
  }

  void calibrate() {
    result_.base = nominal_;
    // The rounds fit what readings weigh, and then what fits them.
    for (int round = 0; round < 2; ++round) {
      reshape(result_.base);
      result_.base = calibrated(now_.likelihood.problem, nominal_, coefficients_, workers_);
    }
    reshape(result_.base);
  }

  bool find(const std::function<bool(const char*)>& stop) {
    std::set<std::set<std::string>> met;  // a term may be accepted and lose its place at once
    while (result_.accepted.size() < result_.most_causes && met.insert(names()).second) {
      if (stop("searching for causes")) return false;
      if (!accept_best()) break;
      drop_superfluous();
    }
    if (effort_.level) {
      state_evidence();
      return true;
    }
    for (std::size_t c = 0; c < result_.accepted.size(); ++c) {
      if (stop("weighing other causes")) return false;
      defend(c);
    }
    drop_superfluous();
    state_evidence();
    return true;
  }

  Explanation take() {
    judge_coefficients();
    return std::move(result_);
  }

  Explanation take_with_alternatives() {
    judge_coefficients();
    for (std::size_t i = 0; i < result_.calibrations.size(); ++i) {
      if (result_.calibrations[i].differs) {
        result_.instead[i] = instead_of(result_.calibrations[i].effect);
      }
    }
    return std::move(result_);
  }

  const ScatterLevel& level() const { return now_.likelihood.level; }

  void compare_with(const Model& model, const std::vector<AcceptedTerm>& accepted) {
    const double all = evidence_of(model, accepted);
    for (std::size_t c = 0; c < accepted.size(); ++c) {
      std::vector<AcceptedTerm> less = accepted;
      less.erase(less.begin() + static_cast<std::ptrdiff_t>(c));
      const Model without_it = without(model, place(model, accepted[c].effect));
      result_.holds.push_back(all >= now_.evidence - least_evidence &&
                              all >= evidence_of(without_it, less));
    }
  }

  // Takes up what was found before, but for one cause.
  void go_on_without(const Explanation& found, std::size_t cause) {
    result_ = found;
    const Effect effect = found.accepted[cause].effect;
    result_.accepted.erase(result_.accepted.begin() + static_cast<std::ptrdiff_t>(cause));
    settle(without(found.model, place(found.model, effect)));
    settle(Model(now_.model));
  }

 private:
  void judge_coefficients() {
    result_.model = now_.model;
    result_.problem = now_.likelihood.problem;
    result_.scatter = fitted_scatter(result_.shape, now_.likelihood);
    result_.calibrations =
        calibrations(result_.problem, result_.model, result_.mounting_degrees(), options_.alpha);
    result_.instead.resize(result_.calibrations.size());
  }

  // Returns the terms that explain the readings hardly less if this coefficient is as the hardware
  // says.
  std::vector<Alternative> instead_of(const Effect& coefficient) const {
    const Model pinned = without(now_.model, place(now_.model, coefficient));
    const Scored less = scored(fit(now_.likelihood.problem, pinned).model);
    std::vector<Alternative> result;
    for (Scored& way : ways_on(less, {now_.likelihood}, result_.accepted.size())) {
      if (term_of(*way.term.effect.cause) != nullptr) continue;
      const double deficit = now_.likelihood.value - way.likelihood.value +
                             (static_cast<double>(way.term.parameters) - 1) * price_of_parameter();
      if (!(deficit < least_evidence)) continue;
      result.push_back({effect_name(way.term.effect), std::move(way.model), deficit});
    }
    return result;
  }

  std::set<std::string> names() const {
    std::set<std::string> result;
    for (const AcceptedTerm& cause : result_.accepted) result.insert(effect_name(cause.effect));
    return result;
  }

  double description(const std::vector<AcceptedTerm>& terms) const {
    double sum = 0;
    for (const AcceptedTerm& cause : terms) sum += cost(cause);
    return sum;
  }
  // The evidence is that of a model of these terms, as it fits.
  double evidence_of(const Model& model, const std::vector<AcceptedTerm>& terms) const {
    const Fit fitted = fit(now_.likelihood.problem, model, Precision::to_compare);
    if (!has_tensions(fitted)) return -std::numeric_limits<double>::infinity();
    return scored(fitted.model).likelihood.value - description(terms);
  }
  double price_of_parameter() const { return std::log(dataset_.degrees_of_freedom()) / 2; }
  double cost(const AcceptedTerm& cause) const {
    return cause.price + static_cast<double>(cause.parameters) * price_of_parameter();
  }

  // The model is scored at the likeliest level of scatter, or at this one.
  Scored scored(Model model, std::optional<ScatterLevel> level = {}) const {
    Scored result;
    const auto at = try_forecast(dataset_, model);
    if (!at) return result;
    result.model = std::move(model);
    result.likelihood = level ? likelihood(dataset_, result_.shape, *at, *level)
                              : likelihood(dataset_, result_.shape, *at);
    result.evidence = result.likelihood.value - description(result_.accepted);
    return result;
  }

  // The readings' weights depend on the model, and the best fit depends on the weights.
  void reshape(const Model& model) {
    result_.shape = scatter_shape(dataset_, model, options_.mounting_scatter, workers_);
    now_ = scored(model);
  }
  void settle(const Model& model) {
    reshape(model);
    reshape(fit(now_.likelihood.problem, model).model);
  }

  // How the current model's readings are seen: as is likeliest, and with mountings that hardly
  // differ and with a motor that does not scatter, so that a term can explain what they would.
  std::vector<Likelihood> views(const Scored& from) const {
    const ScatterLevel& own = from.likelihood.level;
    const auto seen_at = [&](const ScatterLevel& level) {
      return likelihood(dataset_, result_.shape, forecast(dataset_, from.model), level);
    };
    if (effort_.level) {
      const ScatterLevel level{std::min(own.mounting, effort_.level->mounting),
                               std::min(own.motor, effort_.level->motor)};
      const bool is_own = level.mounting == own.mounting && level.motor == own.motor;
      return {is_own ? from.likelihood : seen_at(level)};
    }
    std::vector<Likelihood> result{from.likelihood};
    const double least = result_.shape.levels.back().mounting;
    if (own.mounting > least) result.push_back(seen_at({least, own.motor}));
    if (own.motor > 0) result.push_back(seen_at({least, 0}));
    return result;
  }

  double price_of(const Candidate& candidate) const {
    const auto alike = std::count_if(causes_.begin(), causes_.end(), [&](const Candidate& other) {
      return other.effect.cause == candidate.effect.cause;
    });
    return price_of_name() + std::log(static_cast<double>(alike));
  }

  double price_of_name() const {
    return std::log(static_cast<double>(causes::cause_library().size() + options_.terms.size()));
  }

  static bool has(const Model& model, const Effect& effect) {
    return std::any_of(model.effects.begin(), model.effects.end(), [&](const Effect& other) {
      return effect_name(other) == effect_name(effect);
    });
  }

  // A cause without a size may seem to gain nothing because the coefficients have been drawn
  // towards it. Returns the few that leave the least misfit beside the hardware's own coefficients.
  std::vector<Effect> likeliest_beside_the_hardware(const Scored& from) const {
    constexpr std::size_t few = 2;
    std::vector<std::size_t> whether;
    for (std::size_t c = 0; c < causes_.size(); ++c) {
      if (!causes_[c].has_size() && !has(from.model, causes_[c].effect)) whether.push_back(c);
    }
    std::vector<std::pair<double, std::size_t>> left(whether.size());
    workers_.for_each_block(whether.size(), 1, [&](const IndexBlock& block) {
      const Extended with = extended(from.model, causes_[whether[block.begin]].effect);
      left[block.begin] = {misfit(from.likelihood.problem, with_hardware_coefficients(with.model)),
                           whether[block.begin]};
    });
    std::sort(left.begin(), left.end());
    std::vector<Effect> result;
    for (std::size_t i = 0; i < std::min(few, left.size()); ++i) {
      result.push_back(causes_[left[i].second].effect);
    }
    return result;
  }

  std::vector<Contender> contenders(const Scored& from, const std::vector<Likelihood>& views,
                                    std::size_t step) const {
    const Screened& screened = screened_(from.model, step);
    const Forecast at = forecast(dataset_, from.model);
    std::vector<Contender> result;
    const auto add = [&](Contender contender) {
      if (!has(from.model, contender.effect)) result.push_back(std::move(contender));
    };
    if (effort_.beside_hardware) {
      for (Effect& effect : likeliest_beside_the_hardware(from)) {
        const std::vector<double> values = effect.values;
        const double price = price_of({effect, {}, effect_name(effect)});
        add({std::move(effect), {values}, price, &views.front()});
      }
    }
    for (const Likelihood& view : views) {
      const Projection projection(view.problem, from.model, at);
      const Eigen::VectorXd left = projection.taken_out(residuals(view.problem, at));
      std::size_t sizes = effort_.causes;
      std::size_t faults = effort_.faults;
      for (const ScreenedCause& cause : screened.causes.run(view.problem, at, projection, left)) {
        const Candidate& candidate = causes_[cause.candidate];
        std::size_t& more = candidate.has_size() ? sizes : faults;
        if (more == 0) continue;
        --more;
        add({candidate.effect, cause.starts, price_of(candidate), &view});
      }
      for (const Effect& term : options_.terms) {
        add({term, {term.values}, price_of_name(), &view});
      }
      for (ScreenedLaw& law :
           best_laws(screened.laws, view.problem, at, projection, left, effort_.laws)) {
        const std::vector<double> values = law.effect.values;
        add({std::move(law.effect), {values}, law.price, &view});
      }
    }
    return result;
  }

  Scored fitted(const Model& model, const Contender& contender) const {
    const Extended with = extended(model, contender.effect);
    const Problem& problem = contender.seen_by->problem;
    Fit best = fit(problem, with.model, with.effect, contender.starts, Precision::to_compare);
    if (contender.effect.values.empty() && parameter_count(model) > 0) {
      Fit other = fit(problem, with_hardware_coefficients(with.model), Precision::to_compare);
      if (other.misfit < best.misfit) best = std::move(other);
    }
    if (!has_tensions(best)) return {};
    Effect& effect = best.model.effects[with.effect];
    if (!shows(effect)) return {};
    const std::size_t parameters = effect.values.size();
    const Effect held = causes::with_crossing_held(effect);
    best.model = without(best.model, with.effect);
    add_effect(best.model, held);
    Scored result = scored(std::move(best.model), contender.seen_by->level);
    result.term = {held, contender.price, parameters, 0, 1, {}, {}};
    result.evidence -= cost(result.term);
    return result;
  }

  // A term that no reading could show stands for something else.
  bool shows(const Effect& effect) const {
    if (!effect.subject.channel) return true;
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const Cell& cell : dataset_.cells) {
      if (dataset_.data->channels[cell.channel].segment != *effect.subject.channel) continue;
      least = std::min(least, cell.measured_N);
      greatest = std::max(greatest, cell.measured_N);
    }
    return effect.cause->shows_between(least, greatest, effect);
  }

  static void likeliest_first(std::vector<Scored>& ways) {
    std::stable_sort(ways.begin(), ways.end(),
                     [](const Scored& a, const Scored& b) { return a.evidence > b.evidence; });
  }

  // Scores those again that could be the likeliest, or hardly less likely.
  void see_at_all_levels(std::vector<Scored>& ways, double before) const {
    constexpr std::size_t at_least = 4;
    constexpr double near = 0.2;
    constexpr double nats = 10;
    if (ways.empty()) return;
    const double best = ways.front().evidence;
    const double least = best - std::max(nats, near * (best - before));
    workers_.for_each_block(ways.size(), 1, [&](const IndexBlock& block) {
      Scored& way = ways[block.begin];
      if (way.term.effect.cause == nullptr) return;
      if (block.begin >= at_least && way.evidence < least) return;
      Scored seen = scored(std::move(way.model));
      seen.evidence -= cost(way.term);
      seen.term = std::move(way.term);
      way = std::move(seen);
    });
  }

  // The most evident first.
  std::vector<Scored> ways_on(const Scored& from, const std::vector<Likelihood>& seen,
                              std::size_t step) const {
    const std::vector<Contender> who = contenders(from, seen, step);
    std::vector<Scored> result(who.size());
    workers_.for_each_block(who.size(), 1, [&](const IndexBlock& block) {
      result[block.begin] = fitted(from.model, who[block.begin]);
    });
    likeliest_first(result);
    see_at_all_levels(result, from.evidence);
    likeliest_first(result);
    // The same term, as other views have fitted it, is no other one.
    std::vector<Scored> ways;
    for (Scored& way : result) {
      if (way.term.effect.cause == nullptr) continue;
      const bool again = std::any_of(ways.begin(), ways.end(), [&](const Scored& other) {
        return same_effect(other.term.effect, way.term.effect);
      });
      if (!again) ways.push_back(std::move(way));
    }
    return ways;
  }

  // Accepts the likeliest term that is likely with the scatter that it leaves, too.
  bool accept_best() {
    constexpr std::size_t tried = 3;
    const std::vector<Scored> ways = ways_on(now_, views(now_), result_.accepted.size());
    const ScatterShape shape = result_.shape;
    const Scored before = now_;
    for (std::size_t i = 0; i < std::min(tried, ways.size()); ++i) {
      const double rise = ways[i].evidence - before.evidence;
      if (!(rise >= least_evidence)) {
        result_.best_refused = std::max(result_.best_refused, rise);
        return false;
      }
      result_.accepted.push_back(ways[i].term);
      settle(Model(ways[i].model));
      if (now_.evidence >= before.evidence + least_evidence) {
        look_again({ways.begin() + static_cast<std::ptrdiff_t>(i), ways.end()}, rise);
        free_crossing();
        return true;
      }
      result_.accepted.pop_back();
      result_.shape = shape;
      now_ = before;
    }
    return false;
  }

  // Seen with the scatter that the accepted term leaves, a near one may be likelier: where a
  // contact rubs more than was thought, its mountings differ more, too.
  void look_again(const std::vector<Scored>& ways, double rise) {
    constexpr std::size_t looked_at = 5;
    constexpr double near = 0.2;
    constexpr double at_least = 10;
    constexpr double hardly = 0.01;  // scatter of the ends of fits
    for (std::size_t i = 1; i < std::min(looked_at, ways.size()); ++i) {
      if (ways[i].evidence < ways[0].evidence - std::max(at_least, near * rise)) return;
      const AcceptedTerm own = std::exchange(result_.accepted.back(), ways[i].term);
      const Scored other = scored(fit(now_.likelihood.problem, ways[i].model).model);
      if (other.evidence > now_.evidence + hardly) {
        settle(Model(other.model));
      } else {
        result_.accepted.back() = own;
      }
    }
  }

  // Fits the zero of a law again with its own readings' scatter. Before, that scatter included what
  // the law leaves unexplained, and further terms would explain the cost of that.
  void free_crossing() {
    const AcceptedTerm own = result_.accepted.back();
    const Term* term = term_of(*own.effect.cause);
    if (term == nullptr || !causes::has_crossing(*term)) return;
    Effect free{&causes::law_with_free_crossing(*term), {}, own.effect.values};
    free.values.push_back(term->x.middle);
    if (term->form == Form::product) free.values.push_back(term->y.middle);
    const Extended with = extended(without(now_.model, place(now_.model, own.effect)), free);
    const Fit best = fit(now_.likelihood.problem, with.model);
    if (!has_tensions(best)) return;
    const Effect held = causes::with_crossing_held(best.model.effects[with.effect]);
    Model moved = without(best.model, with.effect);
    add_effect(moved, held);
    result_.accepted.back() = {held, own.price, free.values.size(), 0, 1, {}, {}};
    const Scored freed = scored(std::move(moved));
    if (freed.evidence > now_.evidence + clearly_likelier) {
      settle(freed.model);
    } else {
      result_.accepted.back() = own;
    }
  }

  // The model without the accepted cause, fitted, and its evidence with one term less.
  Scored without_cause(std::size_t c) const {
    Model model = without(now_.model, place(now_.model, result_.accepted[c].effect));
    Scored result = scored(fit(now_.likelihood.problem, model).model);
    Scored unshared = scored(fit(result.likelihood.problem, result.model).model);
    if (unshared.evidence > result.evidence) result = std::move(unshared);
    result.evidence += cost(result_.accepted[c]);
    return result;
  }

  void drop_superfluous() {
    for (std::size_t c = 0; c < result_.accepted.size();) {
      Scored less = without_cause(c);
      if (now_.evidence - less.evidence >= least_evidence) {
        ++c;
        continue;
      }
      result_.accepted.erase(result_.accepted.begin() + static_cast<std::ptrdiff_t>(c));
      settle(less.model);
      c = 0;
    }
  }

  // Puts a likelier term in its place, and notes those that are hardly less likely.
  void defend(std::size_t c) {
    const Scored less = without_cause(c);
    const AcceptedTerm own = result_.accepted[c];
    result_.accepted.erase(result_.accepted.begin() + static_cast<std::ptrdiff_t>(c));
    // Rivals are seen with the scatter that is left, as the accepted term is.
    std::vector<Scored> ways = ways_on(less, {now_.likelihood}, result_.accepted.size());
    result_.accepted.insert(result_.accepted.begin() + static_cast<std::ptrdiff_t>(c), own);
    if (ways.empty()) return;
    double evidence = now_.evidence;
    if (ways.front().evidence > evidence + clearly_likelier &&
        !same_effect(ways.front().term.effect, own.effect)) {
      result_.accepted[c] = ways.front().term;
      evidence = ways.front().evidence;
      settle(Model(ways.front().model));
    }
    evidence = take_simplest(ways, c, evidence);
    AcceptedTerm& accepted = result_.accepted[c];
    double odds = 1;
    for (Scored& way : ways) {
      const double deficit = evidence - way.evidence;
      if (!(deficit < least_evidence)) break;
      if (same_effect(way.term.effect, accepted.effect) ||
          is_kin(way.term.effect, accepted.effect) || is_a_law_of_its_name(way, accepted.effect)) {
        continue;
      }
      odds += std::exp(-deficit);
      accepted.alternatives.push_back(
          {effect_name(way.term.effect), std::move(way.model), deficit});
    }
    accepted.probability = 1 / odds;
  }

  // Takes the shortest of the forms of one law that are hardly less likely. Returns its evidence.
  double take_simplest(const std::vector<Scored>& ways, std::size_t c, double evidence) {
    const Effect own = result_.accepted[c].effect;
    const Scored* simplest = nullptr;
    for (const Scored& way : ways) {
      if (!(evidence - way.evidence < least_evidence)) break;
      if (!is_kin(way.term.effect, own)) continue;
      const double most = cost(simplest == nullptr ? result_.accepted[c] : simplest->term);
      if (cost(way.term) < most) simplest = &way;
    }
    if (simplest == nullptr) return evidence;
    result_.accepted[c] = simplest->term;
    settle(Model(simplest->model));
    return now_.evidence;
  }

  // A cause of the library has precedence over a law that equals it.
  bool is_a_law_of_its_name(const Scored& way, const Effect& accepted) const {
    constexpr double same = 1;  // in units of the noise, of all readings together
    if (term_of(*way.term.effect.cause) == nullptr || term_of(*accepted.cause) != nullptr) {
      return false;
    }
    const Problem& seen = now_.likelihood.problem;
    const Eigen::VectorXd apart =
        (forecast(dataset_, way.model).reading_N - forecast(dataset_, now_.model).reading_N)
            .cwiseQuotient(seen.deviation_N);
    return apart.norm() <= same;
  }

  void state_evidence() {
    for (std::size_t c = 0; c < result_.accepted.size(); ++c) {
      result_.accepted[c].evidence = now_.evidence - without_cause(c).evidence;
    }
  }

  const Dataset& dataset_;
  const Model nominal_;
  const std::vector<Candidate>& coefficients_;
  const std::vector<Candidate>& causes_;
  const TermSearchOptions& options_;
  Effort effort_;
  Workers& workers_;
  const std::function<const Screened&(const Model&, std::size_t)>& screened_;
  Scored now_;
  Explanation result_;
};

// Coefficients that are free in every model, and what is searched.
std::pair<std::vector<Candidate>, std::vector<Candidate>> parted(
    const std::vector<Candidate>& candidates, const Hardware& hardware) {
  std::pair<std::vector<Candidate>, std::vector<Candidate>> parts;
  for (const Candidate& candidate : candidates) {
    const bool is_open = is_open_coefficient(candidate.effect, hardware);
    (is_open ? parts.first : parts.second).push_back(candidate);
  }
  return parts;
}

}  // namespace

bool is_kin(const Effect& a, const Effect& b) {
  const Term* x = term_of(*a.cause);
  const Term* y = term_of(*b.cause);
  if (x == nullptr || y == nullptr || x->target != y->target) return false;
  if (causes::site_name(x->site) != causes::site_name(y->site)) return false;
  return x->form == Form::constant || y->form == Form::constant ||
         (covariate_name(x->x) == covariate_name(y->x) &&
          covariate_name(x->y) == covariate_name(y->y));
}

double Explanation::mounting_degrees() const {
  double degrees = 0;
  for (const Mounted kind : {Mounted::sheath, Mounted::tube, Mounted::bearing}) {
    if (is_told(scatter.mounting, kind)) {
      degrees += scatter.mounting.told_by[static_cast<std::size_t>(kind)];
    }
  }
  return degrees > 0 ? degrees : std::numeric_limits<double>::infinity();
}

TermSearch::TermSearch(const Dataset& dataset, const Model& nominal,
                       const std::vector<Candidate>& candidates, const TermSearchOptions& options,
                       Workers& workers)
    : dataset_(dataset), nominal_(nominal), options_(options), workers_(workers) {
  std::tie(coefficients_, causes_) = parted(candidates, nominal.hardware);
}

std::optional<Explanation> TermSearch::run(const std::function<bool(const char*)>& stop) {
  if (stop("calibrating coefficients")) return std::nullopt;
  screened_.reserve(static_cast<std::size_t>(most_terms) + 2);
  const std::function<const Screened&(const Model&, std::size_t)> screened =
      [&](const Model& model, std::size_t step) -> const Screened& {
    if (step >= screened_.size() && screened_.size() < screened_.capacity()) {
      const Forecast at = forecast(dataset_, model);
      screened_.push_back({CauseScreening(dataset_, model, at, causes_, workers_),
                           law_table(dataset_, model, at, workers_)});
    }
    return screened_[std::min(step, screened_.size() - 1)];
  };
  Searching searching(dataset_, nominal_, coefficients_, causes_, options_, {}, workers_, screened);
  searching.calibrate();
  if (!searching.find(stop)) return std::nullopt;
  level_ = searching.level();
  Explanation found = searching.take_with_alternatives();
  model_ = found.model;
  accepted_ = found.accepted;
  return found;
}

Explanation TermSearch::run_on(const Dataset& part, Workers& workers) const {
  const bool has_a_fault =
      std::any_of(accepted_.begin(), accepted_.end(),
                  [](const AcceptedTerm& term) { return term.effect.values.empty(); });
  const Effort quick{4, 2, 3, level_, has_a_fault};
  const std::function<const Screened&(const Model&, std::size_t)> screened =
      [&](const Model&, std::size_t step) -> const Screened& {
    return screened_[std::min(step, screened_.size() - 1)];
  };
  Searching searching(part, nominal_, coefficients_, causes_, options_, quick, workers, screened);
  searching.calibrate();
  searching.find([](const char*) { return false; });
  searching.compare_with(model_, accepted_);
  return searching.take();
}

Explanation nothing_explained(const Dataset& dataset, const Model& nominal,
                              const std::vector<Candidate>& candidates,
                              const TermSearchOptions& options, Workers& workers) {
  const auto [coefficients, causes] = parted(candidates, nominal.hardware);
  const std::function<const Screened&(const Model&, std::size_t)> not_screened;
  Searching searching(dataset, nominal, coefficients, causes, options, {}, workers, not_screened);
  searching.calibrate();
  return searching.take();
}

Explanation without_term(const Dataset& dataset, const Explanation& found, std::size_t cause,
                         const TermSearchOptions& options, Workers& workers) {
  const std::vector<Candidate> none;
  const std::function<const Screened&(const Model&, std::size_t)> not_screened;
  Searching searching(dataset, {}, none, none, options, {}, workers, not_screened);
  searching.go_on_without(found, cause);
  return searching.take();
}

}  // namespace reeve::diagnosis
