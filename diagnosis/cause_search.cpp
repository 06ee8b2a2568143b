#include "diagnosis/cause_search.hpp"

#include <algorithm>

#include "diagnosis/null_model.hpp"
#include "diagnosis/outlook.hpp"

namespace reeve {
namespace {

constexpr std::size_t most_contenders = 10;
constexpr std::size_t most_rivals = 6;

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
    return std::move(result_);
  }

 private:
  bool accept_one() {
    const Outlook outlook(problem_, result_.model, candidates_, workers_);
    if (outlook.candidates().empty()) return false;
    const NullModel null_model(problem_, outlook.projection(), outlook.at(),
                               options_.seed + 7919 * result_.accepted.size(), options_.replicates);
    std::vector<double> greatest(null_model.replicates());
    null_model.for_each(workers_, [&](std::size_t replicate, const Eigen::VectorXd& drawn) {
      greatest[replicate] = outlook.screening().greatest_gain(drawn);
    });
    result_.p_value_of_next =
        p_value(outlook.screening().greatest_gain(outlook.residuals()), greatest);
    const double alpha = result_.accepted.empty() ? options_.alpha : options_.further_alpha;
    std::sort(greatest.begin(), greatest.end());
    critical_gain_ =
        greatest[static_cast<std::size_t>((1 - alpha) * static_cast<double>(greatest.size() - 1))];
    if (result_.p_value_of_next > alpha || stop_()) return false;
    const auto which = outlook.contenders(most_contenders, Outlook::Laws::always);
    std::vector<Fit> fits = outlook.fit_each(which);
    const std::size_t best = least_misfit(fits);
    if (gain(misfit(problem_, result_.model), fits[best].misfit) < critical_gain_) return false;
    const Effect effect = outlook.candidates()[which[best]].effect;
    result_.model = std::move(fits[best].model);
    result_.accepted.push_back({effect, result_.p_value_of_next});
    changed_(problem_, result_.model);
    return true;
  }

  double gain(double before, double after) const {
    return gain_from_misfits(before, after, problem_.dataset->degrees_of_freedom());
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
    const Fit base = fit(
        problem_, without(result_.model, place(result_.model, result_.accepted[accepted].effect)));
    const Outlook outlook(problem_, base.model, candidates_, workers_);
    const auto which = outlook.contenders(most_rivals, Outlook::Laws::by_gain);
    std::vector<Fit> fits = outlook.fit_each(which);
    const std::size_t best = fits.empty() ? 0 : least_misfit(fits);
    if (!fits.empty() && gain(now, fits[best].misfit) > clearly) {
      result_.model = std::move(fits[best].model);
      result_.accepted[accepted].effect = outlook.candidates()[which[best]].effect;
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

}  // namespace reeve
