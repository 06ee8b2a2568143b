#include "diagnosis/search/law_screening.hpp"

#include "diagnosis/search/law_families.hpp"

namespace reeve::diagnosis {

std::vector<ScreenedLaw> best_laws(const LawTable& table, const Problem& problem,
                                   const Forecast& at, const Projection& projection,
                                   const Eigen::VectorXd& residuals, std::size_t most) {
  if (most == 0) return {};
  const LawColumns columns(table, problem, at, projection, residuals);
  FoundLaws found(columns);
  const std::vector<Bend> bends = screen_straight(columns, found);
  screen_waves(columns, found);
  screen_parts(columns, found);
  screen_bent(columns, bends, found);
  return found.best(most);
}

}  // namespace reeve::diagnosis
