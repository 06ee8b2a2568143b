// Cross-talk: what a channel reads of the tensions of its row, which are columns of the model and
// not of the file.
#include <algorithm>
#include <vector>

#include "diagnosis/search/law_families.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// A law of a motor tension that scatters, or that is the same in all rows, would follow nothing.
bool motor_is_covariate(const LawColumns& columns) {
  return std::ranges::any_of(columns.table().covariates, [&](const RowCovariate& of) {
    return of.is_motor && !columns.is_of_noise(of);
  });
}

// The tensions of each cell's row: those of the channels, and the motor's.
struct RowTensions {
  std::vector<Covariate> covariates;
  MatrixXd tension_N;  // 0 where the row does not have it
};

RowTensions row_tensions(const LawColumns& columns) {
  // Other friction makes other tensions of channels, for which the proportion holds as well.
  constexpr double beyond = 2;
  const Dataset& dataset = columns.dataset();
  const std::vector<Channel>& channels = dataset.data->channels;
  const auto motor = static_cast<Index>(channels.size());
  const bool with_motor = motor_is_covariate(columns);
  RowTensions result;
  result.tension_N = MatrixXd::Zero(static_cast<Index>(dataset.cells.size()), motor + 1);
  for (const DatasetRow& row : dataset.rows) {
    const auto first = static_cast<Index>(row.first);
    const auto size = static_cast<Index>(row.last - row.first);
    for (Index i = first; i < first + size; ++i) {
      const auto channel = static_cast<Index>(dataset.cells[static_cast<std::size_t>(i)].channel);
      result.tension_N.col(channel)
          .segment(first, size)
          .setConstant(columns.forecast().reading_N[i]);
    }
    if (row.has_motor_tension && with_motor) {
      result.tension_N.col(motor).segment(first, size).setConstant(row.conditions.motor_tension_N);
    }
  }
  for (Index c = 0; c <= motor; ++c) {
    Covariate& of = result.covariates.emplace_back();
    of.kind = c == motor ? causes::CovariateKind::motor : causes::CovariateKind::tension;
    if (c != motor) of.segment = channels[static_cast<std::size_t>(c)].segment;
    of.seen = {0, (c == motor ? 1 : beyond) * result.tension_N.col(c).maxCoeff()};
  }
  return result;
}

}  // namespace

void screen_tensions(const LawColumns& columns, FoundLaws& found) {
  const RowTensions tensions = row_tensions(columns);
  for (std::size_t l = 0; l < columns.table().levers.size(); ++l) {
    const Lever& lever = columns.lever(l);
    if (lever.target != Target::offset || lever.site.place == SitePlace::motor) continue;
    const MatrixXd seen = columns.columns(lever, tensions.tension_N);
    for (std::size_t c = 0; c < tensions.covariates.size(); ++c) {
      const Covariate& tension = tensions.covariates[c];
      const bool is_own = lever.site.place == SitePlace::channels
                              ? tension.kind == causes::CovariateKind::tension
                              : tension.segment == lever.site.channel;
      if (is_own) continue;
      const LawFamily of = columns.family(seen, {static_cast<Index>(c)});
      if (!(of.gain > 0)) continue;
      found.keep(found.law_of_tension(l, tension, c, tensions.covariates.size()), of.gain,
                 {of.size[0]});
    }
  }
}

}  // namespace reeve::diagnosis
