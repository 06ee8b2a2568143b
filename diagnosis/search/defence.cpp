#include "diagnosis/search/defence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "causes/term.hpp"

namespace reeve::diagnosis {
namespace {

bool says_when(const causes::Covariate& covariate) {
  return covariate.kind == causes::CovariateKind::column &&
         (covariate.column == "order" || covariate.column == "run");
}

// Each coefficient gains what the model would lose with the hardware's value in its place.
double cost_of_coefficients(const SearchedModel& search, const Model& model) {
  const Problem& problem = search.now.likelihood.problem;
  const double fitted = misfit(problem, model);
  std::vector<double> gains;
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    if (!is_open_coefficient(model.effects[e], model.hardware)) continue;
    const Fit held = fit(problem, without(model, e), Precision::to_compare);
    gains.push_back(std::max((held.misfit - fitted) / 2, 0.0));
  }
  const double most = search.price_of_parameter() + std::log(static_cast<double>(gains.size()));
  double sum = 0;
  for (const double gain : gains) sum += std::min(gain, most);
  return sum;
}

// Takes the shortest of the forms of one law that are hardly less likely. Returns its evidence.
double take_simplest(SearchedModel& search, const std::vector<Scored>& ways, std::size_t c,
                     double evidence) {
  const Effect own = search.accepted[c].effect;
  const Scored* simplest = nullptr;
  for (const Scored& way : ways) {
    if (!(evidence - way.evidence < least_evidence)) break;
    if (!is_kin(way.term.effect, own)) continue;
    const AcceptedTerm& so_far = simplest == nullptr ? search.accepted[c] : simplest->term;
    if (search.cost(way.term) < search.cost(so_far)) simplest = &way;
  }
  if (simplest == nullptr) return evidence;
  search.accepted[c] = simplest->term;
  search.settle(simplest->model);
  return search.now.evidence - cost_of_coefficients(search, search.now.model);
}

// A cause of the library has precedence over a law that equals it.
bool is_a_law_of_its_name(const SearchedModel& search, const Scored& way, const Effect& accepted) {
  constexpr double same = 1;  // in units of the noise, of all readings together
  if (term_of(*way.term.effect.cause) == nullptr || term_of(*accepted.cause) != nullptr) {
    return false;
  }
  const Eigen::VectorXd apart_N = forecast(search.dataset, way.model).reading_N -
                                  forecast(search.dataset, search.now.model).reading_N;
  return apart_N.cwiseQuotient(search.now.likelihood.problem.deviation_N).norm() <= same;
}

// Where all groups differ, the one that the others are compared with could be any.
bool compares_with_another_group(const SearchedModel& search, const Effect& way,
                                 const Effect& accepted) {
  const auto differing = std::ranges::count_if(search.accepted, [&](const AcceptedTerm& other) {
    return differ_in_group(other.effect, way);
  });
  return differ_in_group(way, accepted) &&
         static_cast<std::size_t>(differing) + 1 == search.dataset.data->groups.size();
}

// The place in the file and the number of the run both say when a reading was taken.
std::string follows(const causes::Covariate& covariate) {
  return says_when(covariate) ? "when" : covariate_name(covariate);
}

// Foresight says what a law tells of readings in other files.
enum class Foresight : std::uint8_t { of_some_runs, of_when, of_recorded };

Foresight foresight(const Term& term) {
  if (term.site.runs.size() > 1) return Foresight::of_some_runs;
  return says_when(term.x) ? Foresight::of_when : Foresight::of_recorded;
}

// A law that says more of other files takes the place of one that is hardly likelier. Returns its
// evidence.
double take_foreseeing(SearchedModel& search, const std::vector<Scored>& ways, std::size_t c,
                       double evidence) {
  const Term* own = term_of(*search.accepted[c].effect.cause);
  if (own == nullptr || foresight(*own) == Foresight::of_recorded) return evidence;
  const Scored* best = nullptr;
  for (const Scored& way : ways) {
    if (!(evidence - way.evidence < least_evidence)) break;
    const Effect& so_far = best == nullptr ? search.accepted[c].effect : best->term.effect;
    if (!acts_alike(way.term.effect, so_far)) continue;
    const Term& law = *term_of(*way.term.effect.cause);
    if (law.form == Form::constant) continue;
    if (foresight(law) > foresight(*term_of(*so_far.cause))) best = &way;
  }
  if (best == nullptr) return evidence;
  search.accepted[c] = best->term;
  search.settle(best->model);
  return search.now.evidence - cost_of_coefficients(search, search.now.model);
}

// A way that is of some runs says less than an accepted law of all of them.
bool is_of_its_runs(const Effect& way, const Effect& accepted) {
  return acts_alike(way, accepted) && term_of(*accepted.cause)->form != Form::constant &&
         foresight(*term_of(*way.cause)) == Foresight::of_some_runs;
}

// Charges the ways that could be as likely as the accepted term, and puts the likeliest first.
void weigh_coefficients(const SearchedModel& search, std::vector<Scored>& ways) {
  constexpr double most = 20;  // no coefficients cost more nats
  for (Scored& way : ways) {
    if (!(search.now.evidence - way.evidence < most)) break;
    way.evidence -= cost_of_coefficients(search, way.model);
  }
  most_evident_first(ways);
}

}  // namespace

bool is_kin(const Effect& a, const Effect& b) {
  const Term* x = term_of(*a.cause);
  const Term* y = term_of(*b.cause);
  if (x == nullptr || y == nullptr || x->target != y->target) return false;
  Site site = x->site;
  const bool are_beside_a_coefficient =
      x->target == causes::Target::exponent && site.direction && y->site.direction;
  if (are_beside_a_coefficient && x->form == Form::constant && y->form == Form::constant) {
    site.direction = y->site.direction;
  }
  if (causes::site_name(site) != causes::site_name(y->site)) return false;
  return x->form == Form::constant || y->form == Form::constant ||
         (follows(x->x) == follows(y->x) && follows(x->y) == follows(y->y));
}

bool acts_alike(const Effect& a, const Effect& b) {
  const Term* x = term_of(*a.cause);
  const Term* y = term_of(*b.cause);
  if (x == nullptr || y == nullptr || x->target != y->target) return false;
  Site site = x->site;
  site.runs = y->site.runs;
  return site == y->site;
}

bool differ_in_group(const Effect& a, const Effect& b) {
  const Term* x = term_of(*a.cause);
  const Term* y = term_of(*b.cause);
  if (x == nullptr || y == nullptr) return false;
  if (x->site.group.empty() || y->site.group.empty()) return false;
  Term of_its_group = *y;
  of_its_group.site.group = x->site.group;
  return of_its_group == *x;
}

namespace {

bool says_no_more(const SearchedModel& search, const Scored& way, const Effect& accepted) {
  const Effect& other = way.term.effect;
  return same_effect(other, accepted) || is_kin(other, accepted) ||
         is_of_its_runs(other, accepted) || is_a_law_of_its_name(search, way, accepted) ||
         compares_with_another_group(search, other, accepted);
}

}  // namespace

void drop_superfluous(SearchedModel& search) {
  for (std::size_t c = 0; c < search.accepted.size();) {
    Scored less = search.without_term(c);
    if (search.now.evidence - less.evidence >= least_evidence) {
      ++c;
      continue;
    }
    search.accepted.erase(search.accepted.begin() + static_cast<std::ptrdiff_t>(c));
    search.settle(less.model);
    c = 0;
  }
}

void defend(SearchedModel& search, const Vocabulary& words, std::size_t c) {
  const Scored less = search.without_term(c);
  const AcceptedTerm own = search.accepted[c];
  const auto at = static_cast<std::ptrdiff_t>(c);
  search.accepted.erase(search.accepted.begin() + at);
  // Rivals are seen with the scatter that is left, as the accepted term is.
  std::vector<Scored> ways =
      ways_on(search, words, less, {search.now.likelihood}, search.accepted.size());
  search.accepted.insert(search.accepted.begin() + at, own);
  if (ways.empty()) return;
  double evidence = search.now.evidence - cost_of_coefficients(search, search.now.model);
  weigh_coefficients(search, ways);
  if (ways.front().evidence > evidence + clearly_likelier &&
      !same_effect(ways.front().term.effect, own.effect)) {
    search.accepted[c] = ways.front().term;
    evidence = ways.front().evidence;
    search.settle(ways.front().model);
  }
  evidence = take_foreseeing(search, ways, c, take_simplest(search, ways, c, evidence));
  AcceptedTerm& accepted = search.accepted[c];
  accepted.alternatives.clear();
  double odds = 1;
  for (const Scored& way : ways) {
    const double deficit = evidence - way.evidence;
    if (!(deficit < least_evidence)) break;
    if (says_no_more(search, way, accepted.effect)) continue;
    odds += std::exp(-deficit);
    accepted.alternatives.push_back({way.term.effect, deficit, {accepted.effect}});
  }
  accepted.probability = 1 / odds;
}

}  // namespace reeve::diagnosis
