#include <algorithm>
#include <vector>

#include "diagnosis/search/law_families.hpp"
#include "diagnosis/search/law_forms.hpp"

namespace reeve::diagnosis {
namespace {

constexpr std::size_t most_bends = 8;
constexpr std::size_t most_knots = 12;

// Returns which of the laws gains most.
std::size_t keep_bent(const LawColumns& columns, std::size_t l, const std::vector<RowLaw>& laws,
                      FoundLaws& found) {
  const Eigen::MatrixXd seen = columns.columns(columns.lever(l), laws);
  std::size_t best = 0;
  double greatest = 0;
  for (std::size_t j = 0; j < laws.size(); ++j) {
    const LawFamily bent = columns.family(seen, {static_cast<Eigen::Index>(j)});
    if (!(bent.gain > 0)) continue;
    if (bent.gain > greatest) {
      greatest = bent.gain;
      best = j;
    }
    found.keep(found.law(l, laws[j]), bent.gain, {bent.size[0], laws[j].values[1]});
  }
  return best;
}

// Screens a hinge or a step between any two neighbours of the recorded values: a few over the range
// first, then all about the best. No fit would move a step, and next to its place another run pays.
void screen_knots(const LawColumns& columns, const Bend& at, Form form, std::size_t first,
                  FoundLaws& found) {
  const std::vector<double>& values =
      columns.covariate(columns.lever(at.lever), at.covariate).distinct;
  const std::size_t stride = std::max<std::size_t>(1, values.size() / most_knots);
  const auto between = [&](std::size_t k) {
    return RowLaw{form, at.covariate, 0, {1, (values[k] + values[k + 1]) / 2}};
  };
  std::vector<RowLaw> laws;
  for (std::size_t k = first; k + 1 < values.size(); k += stride) laws.push_back(between(k));
  if (laws.empty()) return;
  const std::size_t best = first + stride * keep_bent(columns, at.lever, laws, found);
  laws.clear();
  const std::size_t last = std::min(best + stride, values.size() - 1);
  for (std::size_t k = std::max(best, first + stride) - stride + 1; k < last; ++k) {
    if (k != best) laws.push_back(between(k));
  }
  if (!laws.empty()) keep_bent(columns, at.lever, laws, found);
}

}  // namespace

void screen_bent(const LawColumns& columns, std::vector<Bend> bends, FoundLaws& found) {
  std::stable_sort(bends.begin(), bends.end(),
                   [](const Bend& a, const Bend& b) { return a.evidence > b.evidence; });
  bends.resize(std::min(most_bends, bends.size()));
  for (const Bend& at : bends) {
    const Lever& lever = columns.lever(at.lever);
    const Range& seen = columns.covariate(lever, at.covariate).covariate.seen;
    keep_bent(columns, at.lever, smooth_bends(at.covariate, seen), found);
    screen_knots(columns, at, Form::hinge, 1, found);
    screen_knots(columns, at, Form::step, 0, found);
  }
}

}  // namespace reeve::diagnosis
