#include "diagnosis/search/term_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "causes/term.hpp"
#include "diagnosis/search/defence.hpp"
#include "diagnosis/search/law_reference.hpp"

namespace reeve::diagnosis {
namespace {

// Independent readings that each cause takes, and more causes than anybody would believe.
constexpr double readings_of_a_term = 12;
constexpr double most_terms = 6;

std::size_t carried_terms(const Dataset& dataset) {
  const double carried = std::floor(dataset.degrees_of_freedom() / readings_of_a_term);
  return static_cast<std::size_t>(std::clamp(carried, 1.0, most_terms));
}

std::set<std::string> names(const std::vector<AcceptedTerm>& terms) {
  std::set<std::string> result;
  for (const AcceptedTerm& term : terms) result.insert(effect_name(term.effect));
  return result;
}

class Searching {
 public:
  Searching(const Dataset& dataset, const Vocabulary& words, const TermSearchOptions& options,
            Workers& workers)
      : words_(words), alpha_(options.alpha), search_{dataset, workers, options.mounting_scatter} {
    result_.most_causes = options.most_causes.value_or(carried_terms(dataset));
  }

  void calibrate(const Model& nominal, const std::vector<Effect>& coefficients) {
    result_.base = nominal;
    // The rounds fit what readings weigh, and then what fits them.
    for (int round = 0; round < 2; ++round) {
      search_.reshape(result_.base);
      result_.base =
          calibrated(search_.now.likelihood.problem, nominal, coefficients, search_.workers);
    }
    search_.reshape(result_.base);
  }

  void find(const std::function<void(const char*)>& stage) {
    std::set<std::set<std::string>> met;  // a term may be accepted and lose its place at once
    while (accepted().size() < result_.most_causes && met.insert(names(accepted())).second) {
      stage("searching for causes");
      if (!accept_best()) break;
      drop_superfluous(search_);
      for (std::size_t c = 0; c + 1 < accepted().size() && !words_.effort.level; ++c) {
        stage("weighing other causes");
        defend(search_, words_, c);
      }
      move_steps();
      if (!words_.effort.level) put_one_for_several();
    }
    for (std::size_t c = 0; c < accepted().size() && !words_.effort.level; ++c) {
      stage("weighing other causes");
      defend(search_, words_, c);
    }
    if (!words_.effort.level) drop_superfluous(search_);
    for (std::size_t c = 0; c < accepted().size(); ++c) {
      accepted()[c].evidence = search_.now.evidence - search_.without_term(c).evidence;
    }
  }

  Explanation take() {
    record();
    if (put_laws_on_the_hardware()) record();
    result_.instead.resize(result_.calibrations.size());
    return std::move(result_);
  }

  // A term that explains the readings instead of all coefficients that differ does so instead of
  // each: wear makes sheaths and tubes rougher in one proportion.
  Explanation take_with_alternatives() {
    Explanation result = take();
    std::vector<Effect> differing;
    for (std::size_t i = 0; i < result.calibrations.size(); ++i) {
      const Calibration& calibration = result.calibrations[i];
      if (!calibration.differs) continue;
      differing.push_back(calibration.effect);
      result.instead[i] = instead_of({calibration.effect});
    }
    if (differing.size() < 2) return result;
    const std::vector<Alternative> of_all = instead_of(differing);
    for (std::size_t i = 0; i < result.calibrations.size(); ++i) {
      if (!result.calibrations[i].differs) continue;
      result.instead[i].insert(result.instead[i].end(), of_all.begin(), of_all.end());
    }
    return result;
  }

  double evidence() const { return search_.now.evidence; }
  std::size_t terms() const { return search_.accepted.size(); }

  bool has_laws() const {
    return std::ranges::any_of(
        search_.accepted, [](const auto& term) { return term_of(*term.effect.cause) != nullptr; });
  }

  const ScatterLevel& level() const { return search_.now.likelihood.level; }

  // What was accepted on more readings takes the place of what was found here if that is hardly
  // more evident and each of its terms is evident here: more readings tell apart what these cannot.
  void compare_with(const Model& model, const std::vector<AcceptedTerm>& of_more) {
    const double all = search_.evidence_of(model, of_more);
    const bool fits = all >= search_.now.evidence - least_evidence;
    bool shows = fits && !of_more.empty();
    for (std::size_t c = 0; c < of_more.size(); ++c) {
      std::vector<AcceptedTerm> less = of_more;
      less.erase(less.begin() + static_cast<std::ptrdiff_t>(c));
      const Model without_it = without(model, place(model, of_more[c].effect));
      const double rise = all - search_.evidence_of(without_it, less);
      result_.holds.push_back(fits && rise >= 0);
      shows = shows && rise >= least_evidence;
    }
    if (!shows || names(of_more) == names(accepted())) return;
    accepted() = of_more;
    search_.settle(model);
  }

  // Takes up what was found before, but for one cause.
  void go_on_without(const Explanation& found, std::size_t cause) {
    result_ = found;
    accepted() = found.accepted;
    accepted().erase(accepted().begin() + static_cast<std::ptrdiff_t>(cause));
    search_.settle(without(found.model, place(found.model, found.accepted[cause].effect)));
    search_.settle(search_.now.model);
  }

 private:
  std::vector<AcceptedTerm>& accepted() { return search_.accepted; }

  // Returns the terms that explain the readings hardly less if these coefficients are as the
  // hardware says. A term has no merit by having fewer parameters than they are: that several
  // coefficients differ is no rarer than that one does.
  std::vector<Alternative> instead_of(const std::vector<Effect>& coefficients) const {
    const Scored& now = search_.now;
    Model as_hardware = now.model;
    for (const Effect& coefficient : coefficients) {
      as_hardware = without(as_hardware, place(as_hardware, coefficient));
    }
    const Scored less = search_.fitted(as_hardware);
    std::vector<Alternative> result;
    for (const Scored& way :
         ways_on(search_, words_, less, {now.likelihood}, search_.accepted.size())) {
      if (term_of(*way.term.effect.cause) != nullptr) continue;
      const double more = std::max(
          static_cast<double>(way.term.parameters) - static_cast<double>(coefficients.size()), 0.0);
      const double deficit =
          now.likelihood.value - way.likelihood.value + more * search_.price_of_parameter();
      if (!(deficit < least_evidence)) continue;
      result.push_back({way.term.effect, deficit, coefficients});
    }
    return result;
  }

  // Accepts the likeliest term that is likely with the scatter that it leaves, too.
  bool accept_best() {
    constexpr std::size_t tried = 3;
    const std::vector<Scored> ways =
        ways_on(search_, words_, search_.now, views(search_, words_.effort), accepted().size());
    const ScatterShape shape = search_.shape;
    const Scored before = search_.now;
    for (std::size_t i = 0; i < std::min(tried, ways.size()); ++i) {
      const double rise = ways[i].evidence - before.evidence;
      if (!(rise >= least_evidence)) {
        result_.best_refused = std::max(result_.best_refused, rise);
        return false;
      }
      accepted().push_back(ways[i].term);
      search_.settle(ways[i].model);
      if (search_.now.evidence >= before.evidence + least_evidence) {
        look_again({ways.begin() + static_cast<std::ptrdiff_t>(i), ways.end()}, before.evidence);
        free_crossing();
        return true;
      }
      accepted().pop_back();
      search_.shape = shape;
      search_.now = before;
    }
    return false;
  }

  // Seen with the scatter that the accepted term leaves, a near one may be likelier: where a
  // contact rubs more than was thought, its mountings differ more, too.
  void look_again(const std::vector<Scored>& ways, double from) {
    constexpr std::size_t looked_at = 5;
    constexpr double hardly = 0.01;  // scatter of the ends of fits
    for (std::size_t i = 1; i < std::min(looked_at, ways.size()); ++i) {
      if (!is_near(ways[i].evidence, ways[0].evidence, from)) return;
      const AcceptedTerm own = std::exchange(accepted().back(), ways[i].term);
      Scored other = search_.fitted(ways[i].model);
      if (other.evidence > search_.now.evidence + hardly) {
        search_.settle(other.model);
      } else {
        accepted().back() = own;
      }
    }
  }

  // Fits the zero of a law again with its own readings' scatter. Before, that scatter included what
  // the law leaves unexplained, and further terms would explain the cost of that.
  void free_crossing() {
    const AcceptedTerm own = accepted().back();
    const Term* term = term_of(*own.effect.cause);
    if (term == nullptr || !causes::has_crossing(*term)) return;
    Effect free{&causes::law_with_free_crossing(*term), {}, own.effect.values};
    free.values.push_back(term->x.middle);
    if (term->form == Form::product) free.values.push_back(term->y.middle);
    const Model& now = search_.now.model;
    const Extended with = extended(without(now, place(now, own.effect)), free);
    const Fit best = fit(search_.now.likelihood.problem, with.model);
    if (!has_tensions(best)) return;
    const Effect held = causes::with_crossing_held(best.model.effects[with.effect]);
    Model moved = without(best.model, with.effect);
    add_effect(moved, held);
    accepted().back() = {held, own.price, free.values.size(), 0, 1, {}, {}};
    Scored freed = search_.scored(std::move(moved));
    if (freed.evidence > search_.now.evidence + clearly_likelier) {
      search_.settle(freed.model);
    } else {
      accepted().back() = own;
    }
  }

  void record() {
    result_.accepted = search_.accepted;
    result_.model = search_.now.model;
    result_.problem = search_.now.likelihood.problem;
    result_.scatter = fitted_scatter(search_.shape, search_.now.likelihood);
    result_.calibrations =
        calibrations(result_.problem, result_.model, result_.mounting_degrees(), alpha_);
  }

  // A coefficient that differs and a law of the same contacts are one law of the hardware's own.
  bool put_laws_on_the_hardware() {
    bool changed = false;
    for (const Calibration& coefficient : result_.calibrations) {
      for (AcceptedTerm& term : accepted()) {
        const Term* law = term_of(*term.effect.cause);
        if (!coefficient.differs || law == nullptr || !is_law_of(*law, coefficient.effect))
          continue;
        changed |= put_on_the_hardware(term, coefficient.effect);
      }
    }
    return changed;
  }

  bool put_on_the_hardware(AcceptedTerm& term, const Effect& coefficient) {
    Model model = search_.now.model;
    Effect& own = model.effects[place(model, coefficient)];
    Effect& law = model.effects[place(model, term.effect)];
    const double nominal = *coefficient.cause->parameters(model.hardware).front().nominal;
    const auto of_hardware = law_from(nominal, own.values.front(), law);
    if (!of_hardware) return false;
    own.values.front() = nominal;
    law = term.effect = *of_hardware;
    for (Alternative& other : term.alternatives) other.instead_of = {term.effect};
    ++term.parameters;  // x0
    search_.settle(model);
    return true;
  }

  // Parts that were accepted one after the other, each beside fewer terms, may be one law: of the
  // same site and target, in whatever runs.
  void put_one_for_several() {
    for (std::size_t c = 0; c + 1 < accepted().size(); ++c) {
      const Effect first = accepted()[c].effect;
      const SearchedModel before = search_;
      std::erase_if(accepted(),
                    [&](const AcceptedTerm& term) { return acts_alike(term.effect, first); });
      if (before.accepted.size() - accepted().size() > 1 && find_one_like(first, before)) continue;
      restore(before);
    }
  }

  // Returns false if it has less evidence than the parts have.
  bool find_one_like(const Effect& part, const SearchedModel& before) {
    Model model = before.now.model;
    std::erase_if(model.effects, [&](const Effect& other) { return acts_alike(other, part); });
    search_.settle(model);
    for (const Scored& way :
         ways_on(search_, words_, search_.now, views(search_, words_.effort), accepted().size())) {
      if (!acts_alike(way.term.effect, part)) continue;
      accepted().push_back(way.term);
      search_.settle(way.model);
      return search_.now.evidence > before.now.evidence + clearly_likelier;
    }
    return false;
  }

  void restore(const SearchedModel& before) {
    search_.accepted = before.accepted;
    search_.shape = before.shape;
    search_.now = before.now;
  }

  // Moves accepted steps to likelier places between neighbours of the recorded values: no fit moves
  // a step, and each was screened beside fewer terms.
  void move_steps() {
    const auto& covariates = words_.screened(search_.now.model, accepted().size()).laws.covariates;
    const auto name = [](const RowCovariate& x) { return causes::covariate_name(x.covariate); };
    const std::vector<AcceptedTerm> terms = accepted();
    for (const AcceptedTerm& term : terms) {
      const Term* law = term_of(*term.effect.cause);
      if (law == nullptr || law->form != Form::step) continue;
      const auto x = std::ranges::find(covariates, causes::covariate_name(law->x), name);
      if (x != covariates.end()) move_step(term.effect, x->distinct);
    }
  }

  void move_step(const Effect& step, const std::vector<double>& seen) {
    const auto from = std::ranges::upper_bound(seen, step.values[1]) - seen.begin();
    for (const std::ptrdiff_t by : {-1, 1}) {
      for (auto to = from + by; to > 0 && to < std::ssize(seen); to += by) {
        const auto k = static_cast<std::size_t>(to);
        if (!place_step(step, (seen[k - 1] + seen[k]) / 2)) break;
      }
    }
  }

  // Returns false, and changes nothing, where the step is no likelier there, also without terms
  // that made up for its place.
  bool place_step(const Effect& step, double at) {
    const SearchedModel before = search_;
    if (!names(accepted()).contains(effect_name(step))) return false;
    Model moved = before.now.model;
    moved.effects[place(moved, step)].values[1] = at;
    const Scored other = search_.fitted(moved);
    if (!(other.evidence > before.now.evidence - clearly_likelier)) return false;
    search_.settle(other.model);
    drop_superfluous(search_);
    if (search_.now.evidence > before.now.evidence + clearly_likelier) return true;
    restore(before);
    return false;
  }

  const Vocabulary words_;
  double alpha_;
  SearchedModel search_;
  Explanation result_;
};

// Coefficients that are free in every model, and what is searched.
std::pair<std::vector<Effect>, std::vector<Effect>> parted(const std::vector<Effect>& candidates,
                                                           const Hardware& hardware) {
  std::pair<std::vector<Effect>, std::vector<Effect>> parts;
  for (const Effect& candidate : candidates) {
    const bool is_open = is_open_coefficient(candidate, hardware);
    (is_open ? parts.first : parts.second).push_back(candidate);
  }
  return parts;
}

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

TermSearch::TermSearch(const Dataset& dataset, const Model& nominal,
                       const std::vector<Effect>& candidates, const TermSearchOptions& options,
                       Workers& workers)
    : dataset_(dataset), nominal_(nominal), options_(options), workers_(workers) {
  std::tie(coefficients_, causes_) = parted(candidates, nominal.hardware);
}

Explanation TermSearch::run(const std::function<void(const char*)>& stage) {
  stage("calibrating coefficients");
  screened_.reserve(static_cast<std::size_t>(most_terms) + 2);
  const auto screened = [&](const Model& model, std::size_t step) -> const Screened& {
    if (step >= screened_.size() && screened_.size() < screened_.capacity()) {
      const Forecast at = forecast(dataset_, model);
      screened_.push_back({CauseScreening(dataset_, model, at, causes_, workers_),
                           law_table(dataset_, model, at, workers_)});
    }
    return screened_[std::min(step, screened_.size() - 1)];
  };
  const auto searched = [&](const Effort& effort, const TermSearchOptions& options) {
    auto search = std::make_unique<Searching>(
        dataset_, Vocabulary{causes_, options_.terms, effort, screened}, options, workers_);
    search->calibrate(nominal_, coefficients_);
    search->find(stage);
    return search;
  };
  auto best = searched({}, options_);
  // A law that follows what two causes do together is accepted before either of them. Names that
  // are no more than the terms found are looked for by themselves.
  if (best->has_laws()) {
    TermSearchOptions no_more = options_;
    no_more.most_causes = best->terms();
    auto names = searched({.laws = 0}, no_more);
    if (names->evidence() > best->evidence()) best = std::move(names);
  }
  level_ = best->level();
  Explanation found = best->take_with_alternatives();
  model_ = found.model;
  accepted_ = found.accepted;
  return found;
}

Explanation TermSearch::run_on(const Dataset& part, Workers& workers) const {
  const bool has_a_fault = std::ranges::any_of(
      accepted_, [](const AcceptedTerm& term) { return term.effect.values.empty(); });
  const auto screened = [&](const Model&, std::size_t step) -> const Screened& {
    return screened_[std::min(step, screened_.size() - 1)];
  };
  const Effort quick{4, 2, 3, level_, has_a_fault};
  Searching searching(part, {causes_, options_.terms, quick, screened}, options_, workers);
  searching.calibrate(nominal_, coefficients_);
  searching.find([](const char*) {});
  searching.compare_with(model_, accepted_);
  return searching.take();
}

Explanation nothing_explained(const Dataset& dataset, const Model& nominal,
                              const std::vector<Effect>& candidates,
                              const TermSearchOptions& options, Workers& workers) {
  const auto [coefficients, causes] = parted(candidates, nominal.hardware);
  Searching searching(dataset, {causes, options.terms}, options, workers);
  searching.calibrate(nominal, coefficients);
  return searching.take();
}

Explanation without_term(const Dataset& dataset, const Explanation& found, std::size_t cause,
                         const TermSearchOptions& options, Workers& workers) {
  const std::vector<Effect> none;
  Searching searching(dataset, {none, options.terms}, options, workers);
  searching.go_on_without(found, cause);
  return searching.take();
}

}  // namespace reeve::diagnosis
