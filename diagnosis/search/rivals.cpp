#include "diagnosis/search/rivals.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/search/screened_causes.hpp"

namespace reeve::diagnosis {

std::vector<Rival> rivals(const Problem& problem, const Model& model, std::size_t effect,
                          const std::vector<Candidate>& candidates, Workers& workers) {
  constexpr std::size_t most = 10;  // those that the screening puts first; a fit each
  const std::string accepted = effect_name(model.effects[effect]);
  std::vector<Candidate> others;
  for (const Candidate& candidate : candidates) {
    if (candidate.name != accepted) others.push_back(candidate);
  }
  const Fit base = fit(problem, without(model, effect));
  const ScreenedCauses screened(problem, base.model, others, workers);
  const auto which = screened.contenders(most, ScreenedCauses::Laws::always);
  const std::vector<Fit> fits = screened.fit_each(which);
  const double now = misfit(problem, model);
  const double degrees = problem.dataset->degrees_of_freedom();
  const auto merit = [&](double left, const Model& by) {
    return gain_from_misfits(base.misfit, left, degrees) -
           static_cast<double>(parameter_count(by)) * std::log(degrees) / 2;
  };
  std::vector<Rival> result;
  for (std::size_t i = 0; i < which.size(); ++i) {
    if (!has_tensions(fits[i])) continue;
    const double deficit = merit(now, model) - merit(fits[i].misfit, fits[i].model);
    result.push_back({screened.candidates()[which[i]].name, fits[i], deficit});
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Rival& a, const Rival& b) { return a.deficit < b.deficit; });
  return result;
}

Indistinguishable indistinguishable(const std::string& name, const Model& model,
                                    const std::vector<Rival>& rivals) {
  Indistinguishable group{{name}, {model}};
  for (const Rival& rival : rivals) {
    const bool known =
        std::find(group.names.begin(), group.names.end(), rival.name) != group.names.end();
    if (rival.deficit >= alias_margin || known) continue;
    group.names.push_back(rival.name);
    group.models.push_back(rival.fit.model);
  }
  return group;
}

}  // namespace reeve::diagnosis
