#include "diagnosis/search/cause_search.hpp"

#include <algorithm>

#include "diagnosis/fit/null_model.hpp"
#include "diagnosis/search/calibration.hpp"
#include "diagnosis/search/rivals.hpp"
#include "diagnosis/search/screened_causes.hpp"
#include "numerics/streams.hpp"

namespace reeve::diagnosis {
namespace {

// A full fit takes some hundred forecasts: how many causes get one in a step, and how many whenever
// an accepted cause defends its place.
constexpr std::size_t most_contenders = 10;
constexpr std::size_t most_rivals = 6;
// Times what chance gains at most when mountings are drawn to second order: what they do beyond it
// was seen to gain ten times as much.
constexpr double beyond_chance = 30;
constexpr double least_advantage = 0.5;  // in log-likelihood, to take another cause's place

class Search {
 public:
  Search(Problem& problem, const Model& base, const std::vector<Candidate>& candidates,
         const CauseSearchOptions& options, const MountingScatter& mounting, Workers& workers,
         const std::function<void(Problem&, const Model&)>& changed,
         const std::function<bool()>& stop)
      : problem_(problem),
        candidates_(candidates),
        options_(options),
        mounting_(mounting),
        workers_(workers),
        changed_(changed),
        stop_(stop) {
    result_.model = base;
  }

  std::optional<CauseSearchResult> run() {
    while (result_.accepted.size() < options_.most_causes && !exhausted_ && !stop_()) {
      if (!accept_one()) break;
      if (stop_()) break;
      defend();
      note_repetition();
      if (result_.accepted.size() > 2) shrink();
    }
    if (stop_()) return std::nullopt;
    return std::move(result_);
  }

 private:
  bool accept_one() {
    const ScreenedCauses screened(problem_, result_.model, candidates_, workers_);
    if (screened.candidates().empty()) return false;
    std::vector<double> greatest = greatest_by_chance(screened, nullptr);
    if (stop_()) return false;
    const auto which = screened.contenders(most_contenders, ScreenedCauses::Laws::always);
    std::vector<Fit> fits(which.size());
    const auto is_no_line = [](const Candidate& candidate) {
      return candidate.effect.cause->reach() == Reach::hardware || !candidate.has_size();
    };
    const auto fit_those = [&](bool no_line) {
      std::vector<std::size_t> places, candidates;
      for (std::size_t i = 0; i < which.size(); ++i) {
        if (is_no_line(screened.candidates()[which[i]]) != no_line) continue;
        places.push_back(i);
        candidates.push_back(which[i]);
      }
      std::vector<Fit> fitted = screened.fit_each(candidates);
      for (std::size_t i = 0; i < places.size(); ++i) fits[places[i]] = std::move(fitted[i]);
      return places;
    };
    const double before = misfit(problem_, result_.model);
    // What is wrong with the hardware may be so far from what it says of itself, and what is there
    // or not is so much at once, that the first order sees little of the gain.
    double observed = screened.screening().greatest_gain(screened.residuals());
    for (const std::size_t i : fit_those(true)) {
      observed = std::max(observed, gain(before, fits[i].misfit));
    }
    const double alpha = result_.accepted.empty() ? options_.alpha : options_.further_alpha;
    judge(observed, alpha, greatest);
    if (result_.p_value_of_next <= alpha && !problem_.shared.empty() &&
        observed < beyond_chance * greatest.back()) {
      const MountedDraws mounted(*problem_.dataset, result_.model, mounting_);
      greatest = greatest_by_chance(screened, &mounted);
      judge(observed, alpha, greatest);
    }
    if (result_.p_value_of_next > alpha || stop_()) return false;
    fit_those(false);
    const std::size_t best = likeliest(problem_, fits);
    if (gain(before, fits[best].misfit) < critical_gain_) return false;
    const Effect effect = screened.candidates()[which[best]].effect;
    result_.model = std::move(fits[best].model);
    result_.accepted.push_back({effect, result_.p_value_of_next});
    settle();
    return true;
  }

  std::vector<double> greatest_by_chance(const ScreenedCauses& screened,
                                         const MountedDraws* mounted) const {
    const NullModel null_model(problem_, screened.projection(), screened.at(),
                               streams::seed_of_step(options_.seed, result_.accepted.size()),
                               options_.replicates, mounted);
    std::vector<double> greatest(null_model.replicates());
    null_model.for_each(
        workers_,
        [&](std::size_t first, const Eigen::MatrixXd& drawn) {
          const std::vector<double> gains = screened.screening().greatest_gains(drawn);
          std::copy(gains.begin(), gains.end(),
                    greatest.begin() + static_cast<std::ptrdiff_t>(first));
        },
        stop_);
    return greatest;
  }

  // Sorts the gains of chance.
  void judge(double observed, double alpha, std::vector<double>& greatest) {
    result_.p_value_of_next = p_value(observed, greatest);
    std::sort(greatest.begin(), greatest.end());
    critical_gain_ =
        greatest[static_cast<std::size_t>((1 - alpha) * static_cast<double>(greatest.size() - 1))];
  }

  // Where a cause is accepted and loses its place at once, the next step would do the same again.
  void note_repetition() {
    const auto same = [](const AcceptedCause& a, const AcceptedCause& b) {
      return same_effect(a.effect, b.effect);
    };
    const auto is_here = [&](const std::vector<AcceptedCause>& others) {
      return std::is_permutation(others.begin(), others.end(), result_.accepted.begin(),
                                 result_.accepted.end(), same);
    };
    exhausted_ |= std::any_of(met_.begin(), met_.end(), is_here);
    met_.push_back(result_.accepted);
  }

  // What readings weigh depends on the model, and what fits them best on what they weigh.
  void settle() {
    changed_(problem_, result_.model);
    Fit here, afresh;
    workers_.for_each_block(2, 1, [&](const IndexBlock& block) {
      if (block.begin == 0) {
        here = fit(problem_, result_.model);
      } else {
        afresh = fit(problem_, with_hardware_coefficients(result_.model));
      }
    });
    result_.model = std::move((afresh.misfit < here.misfit ? afresh : here).model);
    changed_(problem_, result_.model);
  }

  bool is_accepted(const Effect& effect) const {
    return std::any_of(
        result_.accepted.begin(), result_.accepted.end(),
        [&](const AcceptedCause& other) { return same_effect(other.effect, effect); });
  }

  double gain(double before, double after) const {
    return gain_from_misfits(before, after, problem_.dataset->degrees_of_freedom());
  }

  void defend() {
    constexpr int rounds = 3;  // two causes can take each other's places in turn
    for (int round = 0; round < rounds; ++round) {
      bool changed = false;
      for (std::size_t a = 0; a < result_.accepted.size() && result_.accepted.size() > 1; ++a) {
        if (stop_()) return;
        changed |= defend_one(a);
      }
      if (!changed) return;
    }
  }

  // Whether the cause lost its place.
  bool defend_one(std::size_t accepted) {
    const double now = misfit(problem_, result_.model);
    const Fit base = fit(
        problem_, without(result_.model, place(result_.model, result_.accepted[accepted].effect)));
    const ScreenedCauses screened(problem_, base.model, candidates_, workers_);
    const auto which = screened.contenders(most_rivals, ScreenedCauses::Laws::by_gain);
    std::vector<Fit> fits = screened.fit_each(which);
    const std::size_t best = fits.empty() ? 0 : likeliest(problem_, fits);
    if (!fits.empty() && gain(now, fits[best].misfit) > least_advantage) {
      result_.model = std::move(fits[best].model);
      result_.accepted[accepted].effect = screened.candidates()[which[best]].effect;
      settle();
      return true;
    }
    if (gain(base.misfit, now) >= critical_gain_) return false;
    result_.model = base.model;
    result_.accepted.erase(result_.accepted.begin() + static_cast<std::ptrdiff_t>(accepted));
    settle();
    return true;
  }

  // Accepted one by one, three causes may say in a roundabout way what two others say at once: of
  // all models that have one of them and one other cause, the best takes over if that costs less
  // than a third cause has to gain.
  void shrink() {
    const double now = misfit(problem_, result_.model);
    Fit best;
    AcceptedCause kept, taken;
    for (const AcceptedCause& accepted : result_.accepted) {
      if (stop_()) return;
      Model alone = result_.model;
      std::erase_if(alone.effects, [&](const Effect& effect) {
        return is_accepted(effect) && !same_effect(effect, accepted.effect);
      });
      const Fit base = fit(problem_, alone);
      const ScreenedCauses screened(problem_, base.model, candidates_, workers_);
      const auto which = screened.contenders(most_rivals, ScreenedCauses::Laws::always);
      std::vector<Fit> fits = screened.fit_each(which);
      const std::size_t i = likeliest(problem_, fits);
      if (fits.empty() || (best.misfit > 0 && fits[i].misfit >= best.misfit)) continue;
      best = std::move(fits[i]);
      kept = accepted;
      taken = {screened.candidates()[which[i]].effect, accepted.p_value};
    }
    if (best.model.effects.empty() || gain(best.misfit, now) >= critical_gain_) return;
    result_.model = std::move(best.model);
    result_.accepted = {kept, taken};
    settle();
    exhausted_ = true;
  }

  Problem& problem_;
  const std::vector<Candidate>& candidates_;
  const CauseSearchOptions& options_;
  const MountingScatter& mounting_;
  Workers& workers_;
  const std::function<void(Problem&, const Model&)>& changed_;
  const std::function<bool()>& stop_;
  CauseSearchResult result_;
  double critical_gain_ = 0;
  std::vector<std::vector<AcceptedCause>> met_ = {{}};  // after each step, and before the first
  bool exhausted_ = false;  // two causes do what a third was accepted for, or a step is repeated
};

}  // namespace

std::optional<CauseSearchResult> search_causes(
    Problem& problem, const Model& base, const std::vector<Candidate>& candidates,
    const CauseSearchOptions& options, const MountingScatter& mounting, Workers& workers,
    const std::function<void(Problem&, const Model&)>& changed, const std::function<bool()>& stop) {
  return Search(problem, base, candidates, options, mounting, workers, changed, stop).run();
}

}  // namespace reeve::diagnosis
