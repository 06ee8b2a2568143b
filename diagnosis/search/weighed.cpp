#include "diagnosis/search/weighed.hpp"

#include <algorithm>
#include <utility>

#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

std::vector<WeighedModel> weighed_models(const Problem& problem, const Model& nominal,
                                         const Model& extended,
                                         const std::vector<std::string>& causes,
                                         const std::vector<std::vector<Rival>>& rivals) {
  std::vector<WeighedModel> weighed;
  if (causes.empty()) return weighed;
  const double nothing = misfit(problem, nominal);
  const auto add = [&](std::vector<std::string> names, const Model& model, double misfit) {
    const bool known = std::any_of(weighed.begin(), weighed.end(), [&](const WeighedModel& other) {
      return other.causes == names;
    });
    if (!known) weighed.push_back({std::move(names), model, (nothing - misfit) / 2});
  };
  add(causes, extended, misfit(problem, extended));
  for (std::size_t c = 0; c < causes.size(); ++c) {
    for (const Rival& other : rivals[c]) {
      std::vector<std::string> names = causes;
      names.erase(names.begin() + static_cast<std::ptrdiff_t>(c));
      names.insert(names.begin(), other.name);
      add(std::move(names), other.fit.model, other.fit.misfit);
    }
  }
  return weighed;
}

}  // namespace reeve::diagnosis
