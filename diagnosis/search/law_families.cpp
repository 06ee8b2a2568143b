#include "diagnosis/search/law_families.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Cells of each run.
using Parts = std::map<std::size_t, std::vector<Index>>;

// A column for each part: 1 in its cells.
MatrixXd indicators(const LawColumns& columns, const Parts& parts) {
  MatrixXd values = MatrixXd::Zero(static_cast<Index>(columns.dataset().cells.size()),
                                   static_cast<Index>(parts.size()));
  Index own = 0;
  for (const auto& [part, cells] : parts) values.col(own++)(cells).setOnes();
  return values;
}

// A run, and what a lever does there alone.
struct RunChange {
  std::size_t run = 0;
  Index column = 0;
  double size = 0;
};

class RunScreen {
 public:
  RunScreen(const LawColumns& columns, const Parts& runs, FoundLaws& found)
      : columns_(columns), runs_(runs), found_(found), values_(indicators(columns, runs)) {}

  // The likeliest runs that have one change in common are those whose own are at one end of all.
  void screen(std::size_t lever) {
    const MatrixXd seen = columns_.columns(columns_.lever(lever), values_);
    std::vector<RunChange> changes = own_changes(lever, seen);
    std::ranges::stable_sort(changes, {}, &RunChange::size);
    keep_from_the_first(lever, seen, changes);
    std::ranges::reverse(changes);
    keep_from_the_first(lever, seen, changes);
  }

 private:
  std::vector<RunChange> own_changes(std::size_t lever, const MatrixXd& seen) {
    std::vector<RunChange> changes;
    Index column = 0;
    for (const auto& [run, cells] : runs_) {
      const LawFamily of = columns_.family(seen, {column});
      if (of.gain > 0) {
        changes.push_back({run, column, of.size[0]});
        keep(lever, of, {run});
      }
      ++column;
    }
    return changes;
  }

  // Most of the runs are none that stand apart.
  void keep_from_the_first(std::size_t lever, const MatrixXd& seen,
                           const std::vector<RunChange>& changes) {
    MatrixXd together = MatrixXd::Zero(seen.rows(), 1);
    std::vector<std::size_t> runs;
    for (const RunChange& change : std::span(changes).first(changes.size() / 2)) {
      together += seen.col(change.column);
      runs.push_back(change.run);
      if (runs.size() > 1) keep(lever, columns_.family(together, {0}), runs);
    }
  }

  void keep(std::size_t lever, const LawFamily& of, std::vector<std::size_t> runs) {
    if (!(of.gain > 0)) return;
    LeverLaw law = found_.law_of_runs(lever, runs.size(), runs_.size());
    std::ranges::sort(runs);
    for (const std::size_t run : runs) {
      law.term.site.runs.push_back(columns_.dataset().data->runs[run]);
    }
    found_.keep(law, of.gain, {of.size[0]});
  }

  const LawColumns& columns_;
  const Parts& runs_;
  FoundLaws& found_;
  MatrixXd values_;
};

}  // namespace

void screen_runs(const LawColumns& columns, FoundLaws& found) {
  Parts runs;
  for (std::size_t i = 0; i < columns.dataset().cells.size(); ++i) {
    const Reading& reading = columns.dataset().data->readings[columns.dataset().cells[i].reading];
    runs[reading.run].push_back(static_cast<Index>(i));
  }
  if (runs.size() < few_runs) return;
  RunScreen of_runs(columns, runs, found);
  for (std::size_t l = 0; l < columns.table().levers.size(); ++l) {
    if (columns.is_whole(l)) of_runs.screen(l);
  }
}

std::vector<ScreenedLaw> best_laws(const LawTable& table, const Problem& problem,
                                   const Forecast& at, const Projection& projection,
                                   const Eigen::VectorXd& residuals, std::size_t most) {
  if (most == 0) return {};
  const LawColumns columns(table, problem, at, projection, residuals);
  FoundLaws found(columns);
  const std::vector<Bend> bends = screen_straight(columns, found);
  screen_waves(columns, found);
  screen_runs(columns, found);
  screen_tensions(columns, found);
  screen_bent(columns, bends, found);
  return found.best(most);
}

}  // namespace reeve::diagnosis
