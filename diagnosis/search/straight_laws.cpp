#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "diagnosis/search/law_families.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// x0 at which a straight law with this slope, beside this constant, is zero.
std::optional<double> crossing(const Covariate& x, bool is_logarithmic, double constant,
                               double slope) {
  const double span = x.seen.high - x.seen.low;
  const double at =
      is_logarithmic ? x.middle * std::exp(-constant / slope) : x.middle - constant / slope;
  if (!(at > x.seen.low - 3 * span && at < x.seen.high + 3 * span)) return std::nullopt;
  if (is_logarithmic && !(at > 0)) return std::nullopt;
  return at;
}

// The first of two groups has less of what the other has more.
bool is_first_of_two(const Lever& lever, const std::vector<std::string>& groups) {
  return groups.size() == 2 && lever.site.group == groups.front();
}

// The library or the hardware has a name for the constant: friction, bearing_drag.
bool is_library_constant(const Lever& lever) {
  if (lever.site.place != SitePlace::contacts) return lever.breadth == Breadth::whole;
  return lever.breadth == Breadth::whole &&
         (lever.target == Target::exponent
              ? lever.has_coefficient
              : lever.site.kind == ContactKind::bearing || lever.site.with_sheaths);
}

class StraightLaws {
 public:
  StraightLaws(const LawColumns& columns, FoundLaws& found) : columns_(columns), found_(found) {
    for (std::size_t c = 0; c < columns.load(); ++c) add_laws_of(columns.covariate(c), c, laws_);
    of_one_ = laws_.size();
    for (std::size_t x = 0; x < columns.load(); ++x) add_products(columns.covariate(x), x, laws_);
    values_ = columns.values(laws_);
  }

  void screen(std::size_t l) {
    const Lever& lever = columns_.lever(l);
    const bool is_whole = columns_.is_whole(l);
    std::vector<RowLaw> laws = laws_;
    if (!is_whole) laws.resize(of_one_);
    MatrixXd seen = columns_.columns(lever, values_.leftCols(static_cast<Index>(laws.size())));
    if (lever.load) {
      std::vector<RowLaw> own;
      add_laws_of(*lever.load, columns_.load(), own);
      if (is_whole) add_products(*lever.load, columns_.load(), own);
      laws.insert(laws.end(), own.begin(), own.end());
      MatrixXd rows_and_load(seen.rows(), static_cast<Index>(laws.size()));
      rows_and_load << seen, columns_.columns(lever, own);
      seen = std::move(rows_and_load);
    }
    for (std::size_t j = 0; j < laws.size(); ++j) screen(l, laws, j, seen);
  }

  std::vector<Bend> bends() { return std::move(bends_); }

 private:
  void add_laws_of(const RowCovariate& x, std::size_t c, std::vector<RowLaw>& laws) const {
    if (columns_.is_of_noise(x)) return;
    laws.push_back({Form::linear, c});
    if (is_logarithmic(x)) laws.push_back({Form::log, c});
    laws.push_back({Form::quadratic, c, 0, {1, x.covariate.middle}});
  }

  // The products with each of the covariates before this one.
  void add_products(const RowCovariate& of, std::size_t x, std::vector<RowLaw>& laws) const {
    const auto is_factor = [&](const RowCovariate& factor) {
      return !factor.is_place && !columns_.is_of_noise(factor);
    };
    for (std::size_t y = 0; y < x && is_factor(of); ++y) {
      if (!is_factor(columns_.covariate(y))) continue;
      laws.push_back({Form::product, x, y});
      if (is_logarithmic(of)) laws.push_back({Form::product, x, y, {1}, true});
      if (is_logarithmic(columns_.covariate(y))) {
        laws.push_back({Form::product, x, y, {1}, false, true});
      }
    }
  }

  static bool is_logarithmic(const RowCovariate& x) {
    constexpr double wide = 1.5;
    const Range& seen = x.covariate.seen;
    return seen.low > 0 && seen.high > wide * seen.low && !x.is_motor;
  }

  // The motor tension bends what is read of it. What it bends elsewhere is a law of the load there.
  bool bends_elsewhere(const Lever& lever, const RowLaw& law) const {
    const bool is_read = lever.site.place == SitePlace::motor && lever.target == Target::offset;
    return law.form == Form::quadratic && law.x != columns_.load() &&
           columns_.covariate(law.x).is_motor && !is_read;
  }

  // An offset in proportion to the motor tension is a gain of the motor, and at channels a tension
  // that they read besides (screen_tensions).
  bool follows_motor(const Lever& lever, const RowLaw& law) const {
    if (lever.target != Target::offset || law.form == Form::constant ||
        law.form == Form::quadratic) {
      return false;
    }
    return columns_.covariate(law.x).is_motor ||
           (law.form == Form::product && columns_.covariate(law.y).is_motor);
  }

  void screen(std::size_t l, const std::vector<RowLaw>& laws, std::size_t j, const MatrixXd& seen) {
    const Lever& lever = columns_.lever(l);
    const RowLaw& of = laws[j];
    const auto own = static_cast<Index>(j);
    const auto column = [&](std::size_t c, bool is_logarithmic) {
      const Form form = is_logarithmic ? Form::log : Form::linear;
      return std::ranges::find_if(
                 laws, [&](const RowLaw& law) { return law.form == form && law.x == c; }) -
             laws.begin();
    };
    if (follows_motor(lever, of) || bends_elsewhere(lever, of)) return;
    if (of.form == Form::quadratic) {
      note_bend(l, of.x, seen, {column(of.x, false), own});
    } else if (of.form == Form::product) {
      keep(found_.law(l, of), seen, own,
           {column(of.x, of.x_logarithmic), column(of.y, of.y_logarithmic)});
    } else if (of.form != Form::constant) {
      keep(found_.law(l, of), seen, own, {0});
    } else if (!is_library_constant(lever) &&
               !is_first_of_two(lever, columns_.dataset().data->groups)) {
      keep(found_.law(l, of), seen, own, {});
    }
  }

  // A law that begins elsewhere than at the middle of the data has a constant beside the parabola.
  void note_bend(std::size_t l, std::size_t c, const MatrixXd& seen, std::vector<Index> parabola) {
    double evidence = 0;
    for (const int parameters : {2, 3}) {
      const double gain = columns_.family(seen, parabola).gain;
      if (gain > 0) {
        evidence = std::max(evidence, found_.bent_evidence(l, c, gain, parameters));
      }
      parabola.push_back(0);
    }
    if (evidence > 0) bends_.push_back({l, c, evidence});
  }

  // Keeps the law alone and, if its crossings of zero are within reach, with these. They follow
  // from the sizes of the columns beside it: a (x - x0) = a x - a x0, and of a product
  // a (x - x0) (y - y0) the columns of x and y, which the crossing of the other multiplies.
  void keep(LeverLaw law, const MatrixXd& columns, Index own, std::vector<Index> beside) {
    const LawFamily alone = columns_.family(columns, {own});
    if (alone.gain > 0) found_.keep(law, alone.gain, {alone.size[0]});
    if (beside.empty()) return;
    beside.push_back(own);
    const LawFamily all = columns_.family(columns, beside);
    if (!(all.gain > 0)) return;
    const Index last = all.size.size() - 1;
    std::vector<double> crossings;
    for (Index i = 0; i < last; ++i) {
      Covariate& x = i == 0 ? law.term.x : law.term.y;
      const auto at = crossing(x, x.logarithmic || law.term.form == Form::log,
                               all.size[last - 1 - i], all.size[last]);
      if (!at) return;
      x.middle = *at;
      crossings.push_back(*at);
    }
    found_.keep(law, all.gain, {all.size[last]}, crossings);
  }

  const LawColumns& columns_;
  FoundLaws& found_;
  std::vector<RowLaw> laws_{{}};  // of the rows: constant, of one covariate, products
  std::size_t of_one_ = 0;        // number of laws but products
  MatrixXd values_;
  std::vector<Bend> bends_;
};

}  // namespace

std::vector<Bend> screen_straight(const LawColumns& columns, FoundLaws& found) {
  StraightLaws laws(columns, found);
  for (std::size_t l = 0; l < columns.table().levers.size(); ++l) laws.screen(l);
  return laws.bends();
}

}  // namespace reeve::diagnosis
