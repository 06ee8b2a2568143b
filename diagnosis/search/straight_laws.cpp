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

// The library or the hardware has a name for the constant: friction, bearing_drag.
bool is_library_constant(const Lever& lever) {
  if (lever.site.place != SitePlace::contacts) return true;
  return lever.breadth == Breadth::whole &&
         (lever.target == Target::exponent || lever.site.kind == ContactKind::bearing);
}

class StraightLaws {
 public:
  StraightLaws(const LawColumns& columns, FoundLaws& found) : columns_(columns), found_(found) {
    const std::size_t count = columns.table().covariates.size();
    for (std::size_t c = 0; c < count; ++c) {
      linear_.push_back(static_cast<Index>(laws_.size()));
      laws_.push_back({Form::linear, c});
    }
    for (std::size_t c = 0; c < count; ++c) {
      log_.push_back(static_cast<Index>(laws_.size()));
      if (is_logarithmic(c)) laws_.push_back({Form::log, c});
    }
    for (std::size_t c = 0; c < count; ++c) {
      laws_.push_back({Form::quadratic, c, 0, {1, columns.covariate(c).covariate.middle}});
    }
    of_one_ = laws_.size();
    list_products();
    values_ = columns.values(laws_);
  }

  void screen(std::size_t l) {
    const Lever& lever = columns_.lever(l);
    const std::size_t count = columns_.is_whole(l) ? laws_.size() : of_one_;
    const MatrixXd seen = columns_.columns(lever, values_.leftCols(static_cast<Index>(count)));
    if (lever.by_load) keep_load(l, seen);
    for (std::size_t j = 0; j < count; ++j) {
      const RowLaw& of = laws_[j];
      const auto own = static_cast<Index>(j);
      if (!may_follow(lever, of)) continue;
      if (of.form == Form::quadratic) {
        note_bend(l, of.x, columns_.family(seen, {linear_[of.x], own}).gain);
      } else if (of.form == Form::product) {
        keep(found_.law(l, of), seen, own,
             {of.x_logarithmic ? log_[of.x] : linear_[of.x],
              of.y_logarithmic ? log_[of.y] : linear_[of.y]});
      } else if (of.form != Form::constant) {
        keep(found_.law(l, of), seen, own,
             lever.by_load ? std::vector<Index>{} : std::vector<Index>{0});
      } else if (!lever.by_load && !is_library_constant(lever)) {
        keep(found_.law(l, of), seen, own, {});
      }
    }
  }

  std::vector<Bend> bends() { return std::move(bends_); }

 private:
  void list_products() {
    for (std::size_t x = 0; x < linear_.size(); ++x) {
      for (std::size_t y = 0; y < x; ++y) {
        if (columns_.covariate(x).is_place || columns_.covariate(y).is_place) continue;
        if (columns_.is_of_noise(x) || columns_.is_of_noise(y)) continue;
        laws_.push_back({Form::product, x, y});
        if (is_logarithmic(x)) laws_.push_back({Form::product, x, y, {1}, true});
        if (is_logarithmic(y)) laws_.push_back({Form::product, x, y, {1}, false, true});
      }
    }
  }

  bool is_logarithmic(std::size_t c) const {
    constexpr double wide = 1.5;
    const Range& seen = columns_.covariate(c).covariate.seen;
    return seen.low > 0 && seen.high > wide * seen.low && !columns_.covariate(c).is_motor;
  }

  bool may_follow(const Lever& lever, const RowLaw& law) const {
    if (law.form == Form::constant) return true;
    const bool is_product = law.form == Form::product;
    // An offset in proportion to the motor tension is a gain, which has laws of its own.
    const bool of_motor =
        columns_.covariate(law.x).is_motor || (is_product && columns_.covariate(law.y).is_motor);
    if (of_motor && lever.target == Target::offset &&
        (is_product || lever.site.place == SitePlace::motor)) {
      return false;
    }
    if (lever.by_load && law.form != Form::linear) return false;
    return !columns_.is_of_noise(law.x);
  }

  void note_bend(std::size_t l, std::size_t c, double gain) {
    if (!(gain > 0) || columns_.covariate(c).is_motor) return;
    const double evidence = found_.bent_evidence(l, c, gain);
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

  // The law of a load, alone or with the constant of the same site.
  void keep_load(std::size_t l, const MatrixXd& columns) {
    std::size_t plain = l;
    while (columns_.lever(plain).by_load) --plain;
    MatrixXd both(columns.rows(), 2);
    both << columns_.columns(columns_.lever(plain), values_.leftCols(1)), columns.col(0);
    keep(found_.law(l, {}), both, 1, {0});
  }

  const LawColumns& columns_;
  FoundLaws& found_;
  std::vector<RowLaw> laws_{{}};     // constant, linear, log, quadratic, products
  std::size_t of_one_ = 0;           // number of laws but products
  std::vector<Index> linear_, log_;  // column of each covariate
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
