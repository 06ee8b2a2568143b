#include "diagnosis/cause_search.hpp"

#include <algorithm>
#include <numeric>

#include "diagnosis/null_model.hpp"
#include "diagnosis/screening.hpp"

namespace reeve {
namespace {

constexpr std::size_t contenders_by_gain = 10;
constexpr std::size_t rivals_by_gain = 6;

// Far from nominal a law is no straight line, and what the screening says of it is too little: the
// laws of friction are always fitted.
bool is_law_of_friction(const Candidate& candidate) {
  const Reach reach = candidate.effect.cause->reach();
  return reach == Reach::hardware || reach == Reach::conditions || reach == Reach::load;
}

// A model seen to first order.
struct Outlook {
  Outlook(const Problem& problem, const Model& model, const std::vector<Candidate>& candidates,
          Workers& workers)
      : at(forecast(*problem.dataset, model)),
        projection(problem, model, at),
        residuals(projection.taken_out(reeve::residuals(problem, at))),
        screening(problem, model, at, projection, candidates, workers) {}

  Forecast at;
  Projection projection;
  Eigen::VectorXd residuals;
  Screening screening;
};

std::vector<Candidate> not_in(const Model& model, const std::vector<Candidate>& candidates) {
  std::vector<Candidate> result;
  for (const Candidate& candidate : candidates) {
    const bool taken =
        std::any_of(model.effects.begin(), model.effects.end(),
                    [&](const Effect& effect) { return name(effect) == candidate.name; });
    if (!taken) result.push_back(candidate);
  }
  return result;
}

std::vector<std::size_t> contenders(const std::vector<Candidate>& candidates,
                                    const std::vector<double>& gains, std::size_t by_gain,
                                    bool with_laws) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return gains[a] > gains[b]; });
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool promising = i < by_gain && gains[order[i]] > 0;
    if (promising || (with_laws && is_law_of_friction(candidates[order[i]]))) {
      result.push_back(order[i]);
    }
  }
  return result;
}

// Each contender fitted together with the model's effects; parallel to `which`.
std::vector<Fit> fit_each(const Problem& problem, const Model& model,
                          const std::vector<Candidate>& candidates,
                          const std::vector<std::size_t>& which, const Outlook& outlook,
                          Workers& workers) {
  std::vector<Fit> fits(which.size());
  workers.for_each_block(which.size(), 1, [&](const IndexBlock& block) {
    const std::size_t c = which[block.begin];
    const Extended with = extended(model, candidates[c].effect);
    fits[block.begin] =
        fit(problem, with.model, with.effect, outlook.screening.starts(c, outlook.residuals));
  });
  return fits;
}

std::size_t least_misfit(const std::vector<Fit>& fits) {
  const auto best = std::min_element(
      fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.misfit < b.misfit; });
  return static_cast<std::size_t>(best - fits.begin());
}

class Search {
 public:
  Search(Problem& problem, const Model& nominal, const std::vector<Candidate>& candidates,
         const CauseSearchOptions& options, Workers& workers,
         const std::function<void(Problem&, const Model&)>& changed,
         const std::function<bool()>& stop)
      : problem_(problem),
        candidates_(candidates),
        options_(options),
        workers_(workers),
        changed_(changed),
        stop_(stop) {
    result_.model = nominal;
  }

  std::optional<CauseSearchResult> run() {
    while (result_.accepted.size() < options_.most_causes && !stop_()) {
      if (!accept_one()) break;
      if (stop_()) break;
      defend();
    }
    if (stop_()) return std::nullopt;
    result_.misfit = misfit(problem_, result_.model);
    result_.degrees_of_freedom = problem_.dataset->degrees_of_freedom() -
                                 static_cast<double>(parameter_count(result_.model));
    return std::move(result_);
  }

 private:
  bool accept_one() {
    const std::vector<Candidate> free = not_in(result_.model, candidates_);
    if (free.empty()) return false;
    const Outlook outlook(problem_, result_.model, free, workers_);
    const NullModel null_model(problem_, outlook.projection, outlook.at,
                               options_.seed + 7919 * result_.accepted.size(), options_.replicates);
    std::vector<double> greatest(null_model.replicates());
    null_model.for_each(workers_, [&](std::size_t replicate, const Eigen::VectorXd& drawn) {
      greatest[replicate] = outlook.screening.greatest_gain(drawn);
    });
    const std::vector<double> gains = outlook.screening.gains(outlook.residuals);
    result_.p_value_of_next = p_value(*std::max_element(gains.begin(), gains.end()), greatest);
    const double alpha = result_.accepted.empty() ? options_.alpha : options_.further_alpha;
    std::sort(greatest.begin(), greatest.end());
    critical_gain_ =
        greatest[static_cast<std::size_t>((1 - alpha) * static_cast<double>(greatest.size() - 1))];
    if (result_.p_value_of_next > alpha || stop_()) return false;
    const auto which = contenders(free, gains, contenders_by_gain, true);
    std::vector<Fit> fits = fit_each(problem_, result_.model, free, which, outlook, workers_);
    const std::size_t best = least_misfit(fits);
    if (gain(misfit(problem_, result_.model), fits[best].misfit) < critical_gain_) return false;
    result_.model = std::move(fits[best].model);
    result_.accepted.push_back({free[which[best]].effect, result_.p_value_of_next});
    changed_(problem_, result_.model);
    return true;
  }

  double gain(double before, double after) const {
    return gain_from_misfits(before, after, problem_.dataset->degrees_of_freedom());
  }

  std::size_t place(const Effect& effect) const {
    std::size_t i = 0;
    while (!same_effect(result_.model.effects[i], effect)) ++i;
    return i;
  }

  void defend() {
    constexpr int rounds = 3;
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
    constexpr double clearly = 0.5;
    const double now = misfit(problem_, result_.model);
    const Fit base =
        fit(problem_, without(result_.model, place(result_.accepted[accepted].effect)));
    const std::vector<Candidate> free = not_in(result_.model, candidates_);
    const Outlook outlook(problem_, base.model, free, workers_);
    const std::vector<double> gains = outlook.screening.gains(outlook.residuals);
    const auto which = contenders(free, gains, rivals_by_gain, false);
    std::vector<Fit> fits = fit_each(problem_, base.model, free, which, outlook, workers_);
    const std::size_t best = fits.empty() ? 0 : least_misfit(fits);
    if (!fits.empty() && gain(now, fits[best].misfit) > clearly) {
      result_.model = std::move(fits[best].model);
      result_.accepted[accepted].effect = free[which[best]].effect;
      changed_(problem_, result_.model);
      return true;
    }
    if (gain(base.misfit, now) >= critical_gain_) return false;
    result_.model = base.model;
    result_.accepted.erase(result_.accepted.begin() + static_cast<std::ptrdiff_t>(accepted));
    changed_(problem_, result_.model);
    return true;
  }

  Problem& problem_;
  const std::vector<Candidate>& candidates_;
  const CauseSearchOptions& options_;
  Workers& workers_;
  const std::function<void(Problem&, const Model&)>& changed_;
  const std::function<bool()>& stop_;
  CauseSearchResult result_;
  double critical_gain_ = 0;
};

}  // namespace

std::optional<CauseSearchResult> search_causes(
    Problem& problem, const Model& nominal, const std::vector<Candidate>& candidates,
    const CauseSearchOptions& options, Workers& workers,
    const std::function<void(Problem&, const Model&)>& changed, const std::function<bool()>& stop) {
  return Search(problem, nominal, candidates, options, workers, changed, stop).run();
}

std::vector<Alternative> alternatives(const Problem& problem, const Model& model,
                                      std::size_t effect, const std::vector<Candidate>& candidates,
                                      Workers& workers) {
  const Fit base = fit(problem, without(model, effect));
  const std::vector<Candidate> free = not_in(model, candidates);
  const Outlook outlook(problem, base.model, free, workers);
  const std::vector<double> gains = outlook.screening.gains(outlook.residuals);
  const auto which = contenders(free, gains, contenders_by_gain, true);
  const std::vector<Fit> fits = fit_each(problem, base.model, free, which, outlook, workers);
  const double degrees = problem.dataset->degrees_of_freedom();
  const double gain = gain_from_misfits(base.misfit, misfit(problem, model), degrees);
  std::vector<Alternative> result;
  for (std::size_t i = 0; i < which.size(); ++i) {
    const double other = gain_from_misfits(base.misfit, fits[i].misfit, degrees);
    const Candidate& candidate = free[which[i]];
    result.push_back({candidate.effect, candidate.name, fits[i], other, gain - other});
  }
  std::stable_sort(result.begin(), result.end(), [](const Alternative& a, const Alternative& b) {
    return a.deficit < b.deficit;
  });
  return result;
}

}  // namespace reeve
