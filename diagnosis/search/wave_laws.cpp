// Waves are most of all laws. A row's cells have one value of a wave, so that all projections on
// the residuals take one product by rows; the few that promise most beside their raw lengths are
// then seen as all other laws are.
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

// Sines and cosines of the same periods, and their values by row. Their squares add up to 1.
struct Waves {
  std::vector<RowLaw> sines, cosines;
  MatrixXd sine, cosine, sine_squared;
};

Waves waves_of(const LawColumns& columns) {
  Waves result;
  for (std::size_t c = 0; c < columns.table().covariates.size(); ++c) {
    const RowCovariate& of = columns.covariate(c);
    const int values = static_cast<int>(of.distinct.size());
    if (of.distinct.size() < enough_values || of.is_motor || columns.is_of_noise(of)) continue;
    const double span = of.covariate.seen.high - of.covariate.seen.low;
    for (int k = 2; k <= std::min(most_waves, values / 2); ++k) {
      result.sines.push_back({Form::sine, c, 0, {1, 0, 2 * span / k}});
      result.cosines.push_back({Form::sine, c, 0, {0, 1, 2 * span / k}});
    }
  }
  const LawTable& table = columns.table();
  const auto rows = static_cast<Index>(table.all->rows.size());
  result.sine = values_by_row(table.covariates, result.sines, rows);
  result.cosine = values_by_row(table.covariates, result.cosines, rows);
  result.sine_squared = result.sine.cwiseAbs2();
  return result;
}

std::vector<std::size_t> most_promising(const Waves& waves, const LawColumns& columns,
                                        const VectorXd& by_value) {
  constexpr double tiny = std::numeric_limits<double>::min();
  const VectorXd residual = columns.by_row(by_value.cwiseProduct(columns.pulled_back()));
  const VectorXd square = columns.by_row(by_value.cwiseAbs2());
  const VectorXd of_sine = waves.sine_squared.transpose() * square;
  const VectorXd of_cosine = square.sum() - of_sine.array();
  const VectorXd promised =
      (waves.sine.transpose() * residual).cwiseAbs2().cwiseQuotient(of_sine.cwiseMax(tiny)) +
      (waves.cosine.transpose() * residual).cwiseAbs2().cwiseQuotient(of_cosine.cwiseMax(tiny));
  std::vector<std::pair<double, std::size_t>> promises;
  for (std::size_t w = 0; w < waves.sines.size(); ++w) {
    promises.emplace_back(promised[static_cast<Index>(w)], w);
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
  const std::vector<std::size_t> few = most_promising(waves, columns, columns.in_noise(lever));
  std::vector<RowLaw> chosen;
  for (const std::size_t w : few) {
    chosen.push_back(waves.sines[w]);
    chosen.push_back(waves.cosines[w]);
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
    screen(columns, waves, l, found);
  }
}

}  // namespace reeve::diagnosis
