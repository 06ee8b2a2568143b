#include "diagnosis/search/law_families.hpp"

#include <map>
#include <string>
#include <vector>

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr std::size_t few_groups = 2;

// Cells of each run or each group, by its name.
using Parts = std::map<std::size_t, std::vector<Index>>;

void screen(const LawColumns& columns, const Parts& parts, const std::vector<std::string>& names,
            std::string Site::*restricted, FoundLaws& found) {
  MatrixXd values = MatrixXd::Zero(static_cast<Index>(columns.dataset().cells.size()),
                                   static_cast<Index>(parts.size()));
  Index own = 0;
  for (const auto& [part, cells] : parts) values.col(own++)(cells).setOnes();
  for (std::size_t l = 0; l < columns.table().levers.size(); ++l) {
    if (!columns.is_whole(l)) continue;
    const MatrixXd seen = columns.columns(columns.lever(l), values);
    own = 0;
    for (const auto& [part, cells] : parts) {
      const LawFamily of = columns.family(seen, {own++});
      if (!(of.gain > 0)) continue;
      LeverLaw law = found.law_of_part(l, parts.size(), restricted == &Site::run);
      law.term.site.*restricted = names[part];
      found.keep(law, of.gain, {of.size[0]});
    }
  }
}

}  // namespace

void screen_parts(const LawColumns& columns, FoundLaws& found) {
  Parts runs, groups;
  const MeasuredData& data = *columns.dataset().data;
  for (std::size_t i = 0; i < columns.dataset().cells.size(); ++i) {
    const Reading& reading = data.readings[columns.dataset().cells[i].reading];
    runs[reading.run].push_back(static_cast<Index>(i));
    if (reading.group) groups[*reading.group].push_back(static_cast<Index>(i));
  }
  if (runs.size() >= few_runs) screen(columns, runs, data.runs, &Site::run, found);
  if (groups.size() >= few_groups) screen(columns, groups, data.groups, &Site::group, found);
}

std::vector<ScreenedLaw> best_laws(const LawTable& table, const Problem& problem,
                                   const Forecast& at, const Projection& projection,
                                   const Eigen::VectorXd& residuals, std::size_t most) {
  if (most == 0) return {};
  const LawColumns columns(table, problem, at, projection, residuals);
  FoundLaws found(columns);
  const std::vector<Bend> bends = screen_straight(columns, found);
  screen_waves(columns, found);
  screen_parts(columns, found);
  screen_tensions(columns, found);
  screen_bent(columns, bends, found);
  return found.best(most);
}

}  // namespace reeve::diagnosis
