#include "diagnosis/verdict/aliases.hpp"

#include <utility>

namespace reeve::diagnosis {
namespace {

Indistinguishable alike_by_all_readings(const AliasSearch& search, const AppliedCause& cause,
                                        Workers& workers) {
  const Problem whole = problem(search.all, search.scatter, search.extended, workers);
  const Model model = fit(whole, search.extended).model;
  const std::size_t effect = place(model, cause.effect);
  return indistinguishable(cause.name, model,
                           rivals(whole, model, effect, search.candidates, workers));
}

}  // namespace

std::optional<Aliases> aliases(const AliasSearch& search, const std::vector<AppliedCause>& causes,
                               Workers& workers, const std::function<bool()>& stop) {
  Aliases result;
  for (const AppliedCause& cause : causes) {
    if (stop()) return std::nullopt;
    result.rivals.push_back(rivals(search.training, search.extended,
                                   place(search.extended, cause.effect), search.candidates,
                                   workers));
    const std::vector<Rival>& others = result.rivals.back();
    if (others.empty() || others.front().deficit >= outlier_margin) continue;
    Indistinguishable group = search.all.cells.empty()
                                  ? indistinguishable(cause.name, search.extended, others)
                                  : alike_by_all_readings(search, cause, workers);
    if (group.names.size() > 1) result.groups.push_back(std::move(group));
  }
  return result;
}

}  // namespace reeve::diagnosis
