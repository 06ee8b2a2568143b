#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "diagnosis/search/law_families.hpp"
#include "diagnosis/search/law_forms.hpp"

namespace reeve::diagnosis {
namespace {

constexpr std::size_t most_bends = 10;
constexpr std::size_t most_knots = 12;

// A step that parts one run from all others says no more than that this run stands apart, which is
// screened by itself (law_families.cpp).
bool parts_one_run(const LawColumns& columns, std::size_t l, const RowLaw& step) {
  const RowCovariate& x = columns.covariate(columns.lever(l), step.x);
  if (!columns.is_whole(l) || step.form != Form::step || step.x == columns.load()) return false;
  const Dataset& all = *columns.table().all;
  std::set<std::size_t> below, above;
  for (std::size_t r = 0; r < all.rows.size(); ++r) {
    const bool is_above = x.by_row[static_cast<Eigen::Index>(r)] > step.values[1];
    (is_above ? above : below).insert(all.data->readings[all.rows[r].reading].run);
  }
  const auto is_single = [](const std::set<std::size_t>& one, const std::set<std::size_t>& other) {
    return one.size() == 1 && !other.contains(*one.begin());
  };
  return (is_single(below, above) || is_single(above, below)) &&
         below.size() + above.size() >= few_runs;
}

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
    if (parts_one_run(columns, l, laws[j])) continue;
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
  std::ranges::stable_sort(bends, std::greater{}, &Bend::evidence);
  bends.resize(std::min(most_bends, bends.size()));
  for (const Bend& at : bends) {
    const Lever& lever = columns.lever(at.lever);
    const RowCovariate& x = columns.covariate(lever, at.covariate);
    // A motor's sensor that bends smoothly has a gain that follows its tension.
    if (!x.is_motor) {
      keep_bent(columns, at.lever, smooth_bends(at.covariate, x.covariate.seen), found);
    }
    screen_knots(columns, at, Form::hinge, 1, found);
    screen_knots(columns, at, Form::step, 0, found);
  }
}

}  // namespace reeve::diagnosis
