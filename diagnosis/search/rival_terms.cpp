#include "diagnosis/search/rival_terms.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "causes/library.hpp"
#include "diagnosis/search/calibration.hpp"
#include "diagnosis/search/law_forms.hpp"

namespace reeve::diagnosis {
namespace {

// A term that may join a model, with the problem that it is fitted by.
struct Contender {
  Effect effect;
  std::vector<std::vector<double>> starts;
  double price = 0;
  const Likelihood* seen_by = nullptr;
};

bool has(const Model& model, const Effect& effect) {
  return std::ranges::any_of(model.effects, [&](const Effect& other) {
    return effect_name(other) == effect_name(effect);
  });
}

class RivalTerms {
 public:
  RivalTerms(const SearchedModel& search, const Vocabulary& words, const Scored& from)
      : search_(search), words_(words), from_(from) {}

  std::vector<Scored> run(const std::vector<Likelihood>& views, std::size_t accepted) const {
    std::vector<Scored> result = fitted(contenders(views, accepted));
    most_evident_first(result);
    std::vector<Scored> forms = fitted(forms_of_the_best_law(result));
    result.insert(result.end(), std::make_move_iterator(forms.begin()),
                  std::make_move_iterator(forms.end()));
    most_evident_first(result);
    see_at_all_levels(result);
    most_evident_first(result);
    // The same term, as other views have fitted it, is no other one.
    std::vector<Scored> ways;
    for (Scored& way : result) {
      if (way.term.effect.cause == nullptr) continue;
      const bool again = std::ranges::any_of(ways, [&](const Scored& other) {
        return same_effect(other.term.effect, way.term.effect);
      });
      if (!again) ways.push_back(std::move(way));
    }
    return ways;
  }

 private:
  double price_of(const Effect& candidate) const {
    const auto alike = std::ranges::count(words_.causes, candidate.cause, &Effect::cause);
    return price_of_name() + std::log(static_cast<double>(alike));
  }

  double price_of_name() const {
    return std::log(static_cast<double>(causes::cause_library().size() + words_.terms.size()));
  }

  // A cause without a size may seem to gain nothing because the coefficients have been drawn
  // towards it. Returns the few that leave the least misfit beside the hardware's own coefficients.
  std::vector<Effect> likeliest_beside_the_hardware() const {
    constexpr std::size_t few = 2;
    std::vector<std::size_t> whether;
    for (std::size_t c = 0; c < words_.causes.size(); ++c) {
      const Effect& cause = words_.causes[c];
      if (cause.values.empty() && !has(from_.model, cause)) whether.push_back(c);
    }
    std::vector<std::pair<double, std::size_t>> left(whether.size());
    search_.workers.for_each_block(whether.size(), 1, [&](const IndexBlock& block) {
      const Extended with = extended(from_.model, words_.causes[whether[block.begin]]);
      left[block.begin] = {misfit(from_.likelihood.problem, with_hardware_coefficients(with.model)),
                           whether[block.begin]};
    });
    std::ranges::sort(left);
    std::vector<Effect> result;
    for (std::size_t i = 0; i < std::min(few, left.size()); ++i) {
      result.push_back(words_.causes[left[i].second]);
    }
    return result;
  }

  std::vector<Contender> contenders(const std::vector<Likelihood>& views,
                                    std::size_t accepted) const {
    const Screened& screened = words_.screened(from_.model, accepted);
    const Forecast at = forecast(search_.dataset, from_.model);
    std::vector<Contender> result;
    const auto add = [&](Contender contender) {
      if (!has(from_.model, contender.effect)) result.push_back(std::move(contender));
    };
    if (words_.effort.beside_hardware) {
      for (const Effect& effect : likeliest_beside_the_hardware()) {
        add({effect, {effect.values}, price_of(effect), &views.front()});
      }
    }
    for (const Likelihood& view : views) {
      const Projection projection(view.problem, from_.model, at);
      const Eigen::VectorXd left = projection.taken_out(residuals(view.problem, at));
      std::size_t sizes = words_.effort.causes;
      std::size_t faults = words_.effort.faults;
      for (const ScreenedCause& cause : screened.causes.run(view.problem, at, projection, left)) {
        const Effect& candidate = words_.causes[cause.candidate];
        std::size_t& more = candidate.values.empty() ? faults : sizes;
        if (more == 0) continue;
        --more;
        add({candidate, cause.starts, price_of(candidate), &view});
      }
      for (const Effect& term : words_.terms) {
        add({term, {term.values}, price_of_name(), &view});
      }
      for (const ScreenedLaw& law :
           best_laws(screened.laws, view.problem, at, projection, left, words_.effort.laws)) {
        add({law.effect, {law.effect.values}, law.price, &view});
      }
    }
    return result;
  }

  // If a law is the most evident term or near it, its other forms are tried, too.
  std::vector<Contender> forms_of_the_best_law(const std::vector<Scored>& ways) const {
    std::vector<Contender> result;
    for (const Scored& way : ways) {
      if (way.term.effect.cause == nullptr || !result.empty() ||
          !is_near(way.evidence, ways.front().evidence, from_.evidence)) {
        break;
      }
      for (LawForm& form : other_forms(way.term.effect)) {
        result.push_back({std::move(form.effect), std::move(form.starts),
                          way.term.price + form.more_price, &way.likelihood});
      }
    }
    return result;
  }

  std::vector<Scored> fitted(const std::vector<Contender>& who) const {
    std::vector<Scored> result(who.size());
    search_.workers.for_each_block(who.size(), 1, [&](const IndexBlock& block) {
      result[block.begin] = fitted(who[block.begin]);
    });
    return result;
  }

  Scored fitted(const Contender& contender) const {
    const Extended with = extended(from_.model, contender.effect);
    const Problem& problem = contender.seen_by->problem;
    Fit best = fit(problem, with.model, with.effect, contender.starts, Precision::to_compare);
    if (contender.effect.values.empty() && parameter_count(from_.model) > 0) {
      Fit other = fit(problem, with_hardware_coefficients(with.model), Precision::to_compare);
      if (other.misfit < best.misfit) best = std::move(other);
    }
    if (!has_tensions(best)) return {};
    Effect& effect = best.model.effects[with.effect];
    if (!shows(effect)) return {};
    const std::size_t parameters = effect.values.size();
    const Effect held = causes::with_crossing_held(effect);
    const Term* law = causes::term_of(*held.cause);
    if (law != nullptr && !is_possible(*law, held.values)) return {};
    best.model = without(best.model, with.effect);
    add_effect(best.model, held);
    Scored result = search_.scored(std::move(best.model), contender.seen_by->level);
    result.term = {held, contender.price, parameters, 0, 1, {}, {}};
    result.evidence -= search_.cost(result.term);
    return result;
  }

  // A term that no reading could show stands for something else.
  bool shows(const Effect& effect) const {
    if (!effect.subject.channel) return true;
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    for (const Cell& cell : search_.dataset.cells) {
      if (search_.dataset.data->channels[cell.channel].segment != *effect.subject.channel) continue;
      least = std::min(least, cell.measured_N);
      greatest = std::max(greatest, cell.measured_N);
    }
    return effect.cause->shows_between(least, greatest, effect);
  }

  void see_at_all_levels(std::vector<Scored>& ways) const {
    constexpr std::size_t at_least = 4;  // of each view: what explains mountings is far off in one
    if (ways.empty()) return;
    const double best = ways.front().evidence;
    std::map<std::pair<double, double>, std::size_t> of_view;
    std::vector<std::size_t> place;
    for (const Scored& way : ways) {
      place.push_back(of_view[{way.likelihood.level.mounting, way.likelihood.level.motor}]++);
    }
    search_.workers.for_each_block(ways.size(), 1, [&](const IndexBlock& block) {
      Scored& way = ways[block.begin];
      if (way.term.effect.cause == nullptr) return;
      if (place[block.begin] >= at_least && !is_near(way.evidence, best, from_.evidence)) return;
      Scored seen = search_.scored(std::move(way.model));
      seen.evidence -= search_.cost(way.term);
      seen.term = std::move(way.term);
      way = std::move(seen);
    });
  }

  const SearchedModel& search_;
  const Vocabulary& words_;
  const Scored& from_;
};

}  // namespace

void most_evident_first(std::vector<Scored>& ways) {
  std::ranges::stable_sort(ways, std::greater{}, &Scored::evidence);
}

bool is_near(double evidence, double best, double from) {
  constexpr double near = 0.2;
  constexpr double nats = 10;
  return evidence >= best - std::max(nats, near * (best - from));
}

std::vector<Likelihood> views(const SearchedModel& search, const Effort& effort) {
  const Scored& now = search.now;
  const ScatterLevel& own = now.likelihood.level;
  const auto seen_at = [&](const ScatterLevel& level) {
    return likelihood(search.dataset, search.shape, forecast(search.dataset, now.model), level);
  };
  if (effort.level) {
    const ScatterLevel level{std::min(own.mounting, effort.level->mounting),
                             std::min(own.motor, effort.level->motor)};
    const bool is_own = level.mounting == own.mounting && level.motor == own.motor;
    return {is_own ? now.likelihood : seen_at(level)};
  }
  std::vector<Likelihood> result{now.likelihood};
  const double least = search.shape.levels.back().mounting;
  if (own.mounting > least) result.push_back(seen_at({least, own.motor}));
  if (own.motor > 0) result.push_back(seen_at({least, 0}));
  return result;
}

std::vector<Scored> ways_on(const SearchedModel& search, const Vocabulary& words,
                            const Scored& from, const std::vector<Likelihood>& views,
                            std::size_t accepted) {
  return RivalTerms(search, words, from).run(views, accepted);
}

}  // namespace reeve::diagnosis
