// Waves are most of all laws. All their projections on the residuals take one product; the few that
// promise most beside their raw lengths are then seen as all other laws are.
#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "diagnosis/search/law_families.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t enough_values = 8;
constexpr int most_waves = 64;               // half periods over the range
constexpr std::size_t waves_of_a_lever = 8;  // number of waves fitted closely

struct Waves {
  std::vector<RowLaw> sines;
  MatrixXd values;  // of sine and cosine side by side
  MatrixXd squares;
};

Waves waves_of(const LawColumns& columns) {
  Waves result;
  std::vector<RowLaw> laws;
  for (std::size_t c = 0; c < columns.table().covariates.size(); ++c) {
    const RowCovariate& of = columns.covariate(c);
    const int values = static_cast<int>(of.distinct.size());
    if (of.distinct.size() < enough_values || of.is_motor || columns.is_of_noise(of)) continue;
    const double span = of.covariate.seen.high - of.covariate.seen.low;
    for (int k = 2; k <= std::min(most_waves, values / 2); ++k) {
      result.sines.push_back({Form::sine, c, 0, {1, 0, 2 * span / k}});
      laws.push_back(result.sines.back());
      laws.push_back({Form::sine, c, 0, {0, 1, 2 * span / k}});
    }
  }
  result.values = columns.values(laws);
  result.squares = result.values.cwiseAbs2();
  return result;
}

std::vector<std::size_t> most_promising(const Waves& waves, const VectorXd& by_value,
                                        const VectorXd& pulled_back) {
  constexpr double tiny = std::numeric_limits<double>::min();
  const VectorXd along = waves.values.transpose() * by_value.cwiseProduct(pulled_back);
  const VectorXd squares = waves.squares.transpose() * by_value.cwiseAbs2();
  const VectorXd promise = along.cwiseAbs2().cwiseQuotient(squares.cwiseMax(tiny));
  std::vector<std::pair<double, std::size_t>> promises;
  for (std::size_t w = 0; w < waves.sines.size(); ++w) {
    promises.emplace_back(promise.segment<2>(static_cast<Index>(2 * w)).sum(), w);
  }
  const std::size_t few = std::min(waves_of_a_lever, promises.size());
  std::partial_sort(promises.begin(), promises.begin() + static_cast<std::ptrdiff_t>(few),
                    promises.end(), std::greater<>());
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < few; ++i) result.push_back(promises[i].second);
  return result;
}

void screen(const LawColumns& columns, const Waves& waves, std::size_t l, FoundLaws& found) {
  const Lever& lever = columns.lever(l);
  const std::vector<std::size_t> few =
      most_promising(waves, columns.in_noise(lever), columns.pulled_back());
  MatrixXd chosen(waves.values.rows(), static_cast<Index>(2 * few.size()));
  for (std::size_t i = 0; i < few.size(); ++i) {
    chosen.middleCols<2>(static_cast<Index>(2 * i)) =
        waves.values.middleCols<2>(static_cast<Index>(2 * few[i]));
  }
  const MatrixXd seen = columns.columns(lever, chosen);
  for (std::size_t i = 0; i < few.size(); ++i) {
    const auto sine = static_cast<Index>(2 * i);
    const LawFamily wave = columns.family(seen, {sine, sine + 1});
    if (!(wave.gain > 0)) continue;
    const RowLaw& of = waves.sines[few[i]];
    found.keep(found.law(l, of), wave.gain, {wave.size[0], wave.size[1], of.values[2]});
  }
}

}  // namespace

void screen_waves(const LawColumns& columns, FoundLaws& found) {
  const Waves waves = waves_of(columns);
  for (std::size_t l = 0; l < columns.table().levers.size() && !waves.sines.empty(); ++l) {
    if (columns.is_whole(l)) screen(columns, waves, l, found);
  }
}

}  // namespace reeve::diagnosis
