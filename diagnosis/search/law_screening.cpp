#include "diagnosis/search/law_screening.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "causes/term.hpp"
#include "diagnosis/fit/evidence.hpp"
#include "diagnosis/search/cause_screening.hpp"
#include "numerics/matrices.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Prices are in nats.
constexpr double price_of_law = 1;  // beside what the library has a name for
constexpr double price_of_bend = 2;
constexpr double price_of_product = 2;
constexpr double price_of_place = 2;
constexpr double price_of_apart = 4;
constexpr double price_of_part = 1;

constexpr std::size_t enough_values = 8;     // for a wave
constexpr int most_waves = 28;               // half periods over the range
constexpr std::size_t waves_of_a_lever = 8;  // number of waves fitted closely
constexpr std::size_t most_bent = 8;         // sites and covariates whose bends are looked at
constexpr std::size_t most_knots = 12;

}  // namespace

// The families of one lever's columns, seen from one problem.
class LawFamilies {
 public:
  LawFamilies(const LawScreening& screening, const Problem& problem, const Forecast& at,
              const Projection& projection, const VectorXd& residuals)
      : screening_(screening),
        problem_(problem),
        at_(at),
        projection_(projection),
        residuals_(residuals),
        are_set_(set_readings(*problem.dataset).has_value()),
        before_(residuals.squaredNorm()),
        degrees_(projection.degrees_of_freedom()) {
    std::map<std::size_t, std::size_t> place;
    for (std::size_t r = 0; r < screening.reading_of_row_.size(); ++r) {
      place[screening.reading_of_row_[r]] = r;
    }
    for (const DatasetRow& row : problem.dataset->rows) {
      const std::size_t whole = place.at(row.reading);
      rows_.push_back(whole);
      for (std::size_t i = row.first; i < row.last; ++i) {
        row_of_cell_.push_back(whole);
        cells_.push_back(static_cast<Index>(screening.first_cell_[whole] + (i - row.first)));
      }
    }
    for (const std::size_t row : rows_) {
      runs_.insert(screening.run_of_row_[row]);
      const std::size_t group = screening.group_of_row_[row];
      if (group < screening.groups_.size()) groups_.insert(group);
    }
    pulled_back_ = residuals;
    whiten(problem.shared, pulled_back_);
    take_out_scales(problem, at, pulled_back_);
  }

  std::vector<ScreenedLaw> run(std::size_t most) {
    list_laws();
    for (std::size_t l = 0; l < screening_.levers_.size(); ++l) screen_straight(l);
    screen_bent();
    std::stable_sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) {
      return a.law.evidence > b.law.evidence;
    });
    std::vector<const Found*> plain(screening_.levers_.size(), nullptr);
    for (const Found& found : found_) {
      if (found.kind == constant_kind && plain[found.lever] == nullptr) plain[found.lever] = &found;
    }
    std::vector<ScreenedLaw> result;
    std::set<std::pair<std::size_t, std::size_t>> seen;
    for (const Found& found : found_) {
      if (result.size() >= most) break;
      if (!seen.insert({found.lever, found.kind}).second) continue;
      result.push_back(found.law);
      // A law that follows something is fitted beside the same law without it.
      const Found* constant = plain[found.lever];
      if (constant != nullptr && seen.insert({found.lever, constant_kind}).second) {
        result.push_back(constant->law);
      }
    }
    return result;
  }

 private:
  static constexpr std::size_t constant_kind = 0;

  struct Found {
    ScreenedLaw law;
    std::size_t lever = 0;
    std::size_t kind = 0;  // index by covariate and by whether it is bent
  };

  const RowCovariate& covariate(std::size_t c) const { return screening_.covariates_[c]; }

  // The values of each law, a row for each cell.
  MatrixXd values(const std::vector<RowLaw>& laws) const {
    const auto rows = static_cast<Index>(screening_.reading_of_row_.size());
    MatrixXd result(static_cast<Index>(cells_.size()), static_cast<Index>(laws.size()));
    for (std::size_t j = 0; j < laws.size(); ++j) {
      result.col(static_cast<Index>(j)) =
          value_by_row(screening_.covariates_, laws[j], rows)(row_of_cell_);
    }
    return result;
  }

  // Columns of a lever times laws of these values.
  MatrixXd columns(const Lever& lever, const Eigen::Ref<const MatrixXd>& values) const {
    return seen(in_noise(lever).asDiagonal() * values);
  }
  VectorXd in_noise(const Lever& lever) const {
    return VectorXd(lever.by_value_N(cells_)).cwiseQuotient(problem_.deviation_N);
  }

  MatrixXd seen(MatrixXd columns) const {
    take_out_scales(problem_, at_, columns);
    whiten(problem_.shared, columns);
    const Eigen::RowVectorXd before = columns.colwise().norm();
    projection_.take_out(columns);
    // If a free coefficient already explains a column, hardly anything is left of it.
    constexpr double hardly = 0.02;
    for (Index j = 0; j < columns.cols(); ++j) {
      if (columns.col(j).norm() < hardly * before[j]) columns.col(j).setZero();
    }
    return columns;
  }

  struct Family {
    double gain = 0;
    VectorXd size;
  };

  Family family(const MatrixXd& columns, const std::vector<Index>& which) const {
    const auto n = static_cast<Index>(which.size());
    MatrixXd square(n, n);
    VectorXd along(n);
    for (Index i = 0; i < n; ++i) {
      const auto a = columns.col(which[static_cast<std::size_t>(i)]);
      along[i] = a.dot(residuals_);
      for (Index j = 0; j <= i; ++j) {
        square(i, j) = square(j, i) = a.dot(columns.col(which[static_cast<std::size_t>(j)]));
      }
    }
    const VectorXd scale = square.diagonal().cwiseSqrt();
    if (!(scale.minCoeff() > 0)) return {};
    const VectorXd inverse = scale.cwiseInverse();
    const MatrixXd normal = inverse.asDiagonal() * square * inverse.asDiagonal();
    constexpr double near_alias = 1e-6;
    if (n > 1 && normal.determinant() < near_alias) return {};
    Family result;
    result.size = inverse.cwiseProduct(solve_symmetric(normal, inverse.cwiseProduct(along)));
    result.gain = gain_from_misfits(before_, before_ - result.size.dot(along), degrees_);
    return result;
  }

  double price(const Lever& lever) const {
    const auto breadth = static_cast<std::size_t>(lever.breadth);
    // Friction is in proportion to the load but for rare cases.
    const double price_of_force = lever.target == Target::force ? 0.5 : 0;
    return price_of_law + price_of_force + std::log(screening_.levers_of_breadth_[breadth]) +
           price_of_part * static_cast<double>(breadth);
  }
  // The load is a covariate, too.
  double price_of_covariate() const {
    return std::log(1.0 + static_cast<double>(screening_.covariates_.size()));
  }
  double price_of(const Lever& lever, std::size_t c) const {
    return price_of_covariate() + (covariate(c).is_place ? price_of_place : 0) +
           price_of_part * static_cast<double>(lever.breadth);
  }
  // The place of a step is one of as many as the column has values, and no fitted parameter.
  double price_of_knot(std::size_t c) const {
    return std::log(static_cast<double>(covariate(c).distinct.size())) - std::log(degrees_) / 2;
  }

  Term term(const Lever& lever, Form form) const {
    Term term;
    term.target = lever.target;
    term.site = lever.site;
    term.form = form;
    return term;
  }

  // A force that contacts take is none that they give.
  static bool is_possible(const Term& term, const std::vector<double>& values) {
    if (term.target != Target::force || term.site.place != SitePlace::contacts) return true;
    constexpr double slack = 0.05;
    constexpr int places = 20;
    double least = 0, greatest = 0;
    for (int i = 0; i <= places; ++i) {
      const double x = term.x.seen.low + (term.x.seen.high - term.x.seen.low) * i / places;
      const double y = term.y.seen.low + (term.y.seen.high - term.y.seen.low) * i / places;
      const double f = causes::law_value(term, x, y, values.data());
      least = std::min(least, f);
      greatest = std::max(greatest, f);
    }
    return -least <= slack * greatest;
  }

  struct Made {
    Term term;
    std::vector<double> values;
    std::vector<double> crossing;  // x of the zero, if it is free
    double price = 0;
    double gain = 0;
    std::size_t kind = 0;
  };

  void keep(std::size_t lever, const Made& made) {
    if (!(made.gain > 0) || causes::fault(made.term) || !is_possible(made.term, made.values)) {
      return;
    }
    const double parameters = static_cast<double>(made.values.size() + made.crossing.size());
    const double cost = price(screening_.levers_[lever]) + made.price;
    const double evidence = made.gain - cost - parameters * std::log(degrees_) / 2;
    if (evidence <= 0) return;
    const Cause& cause =
        made.crossing.empty() ? causes::law(made.term) : causes::law_with_free_crossing(made.term);
    std::vector<double> values = made.values;
    values.insert(values.end(), made.crossing.begin(), made.crossing.end());
    found_.push_back({{{&cause, {}, std::move(values)}, cost, evidence}, lever, made.kind});
  }

  // x0 at which a straight law with this slope, beside this constant, is zero.
  static bool move_crossing(Covariate& x, double constant, double slope) {
    const double span = x.seen.high - x.seen.low;
    const double crossing =
        x.logarithmic ? x.middle * std::exp(-constant / slope) : x.middle - constant / slope;
    if (!(crossing > x.seen.low - 3 * span && crossing < x.seen.high + 3 * span)) return false;
    if (x.logarithmic && !(crossing > 0)) return false;
    x.middle = crossing;
    return true;
  }

  // The library or the hardware has a name for the constant: friction, bearing_drag.
  static bool is_library_constant(const Lever& lever) {
    const Site& site = lever.site;
    if (site.place != SitePlace::contacts) return true;
    return lever.breadth == Breadth::whole &&
           (lever.target == Target::exponent || site.kind == ContactKind::bearing);
  }

  // The laws of all levers, and behind them those of levers of the whole rig.
  void list_laws() {
    const std::size_t count = screening_.covariates_.size();
    std::vector<RowLaw> laws{{}};
    for (std::size_t c = 0; c < count; ++c) laws.push_back({Form::linear, c});
    log_column_.assign(count, 0);
    for (std::size_t c = 0; c < count; ++c) {
      if (!is_logarithmic(c)) continue;
      log_column_[c] = laws.size();
      laws.push_back({Form::log, c});
    }
    first_quadratic_ = laws.size();
    for (std::size_t c = 0; c < count; ++c) {
      laws.push_back({Form::quadratic, c, 0, {1, covariate(c).covariate.middle}});
    }
    first_product_ = laws.size();
    add_products();
    laws.insert(laws.end(), products_.begin(), products_.end());
    values_ = values(laws);
    list_waves();
  }

  void screen_straight(std::size_t l) {
    const Lever& lever = screening_.levers_[l];
    const std::size_t count = screening_.covariates_.size();
    const bool is_whole = lever.breadth == Breadth::whole && !lever.by_load;
    const MatrixXd seen = columns(
        lever, values_.leftCols(is_whole ? values_.cols() : static_cast<Index>(first_product_)));

    if (lever.by_load) {
      keep_load(l, seen);
    } else if (!is_library_constant(lever)) {
      const Family alone = family(seen, {0});
      if (alone.gain > 0) {
        keep(l, {term(lever, Form::constant), {alone.size[0]}, {}, 0, alone.gain, constant_kind});
      }
    }
    for (std::size_t c = 0; c < count; ++c) {
      if (is_of_noise(c)) continue;
      if (is_gain_of_the_motor(lever, c)) continue;
      keep_straight(l, c, seen, static_cast<Index>(1 + c), Form::linear);
      if (log_column_[c] != 0) {
        keep_straight(l, c, seen, static_cast<Index>(log_column_[c]), Form::log);
      }
      note_bend(
          l, c,
          family(seen, {static_cast<Index>(1 + c), static_cast<Index>(first_quadratic_ + c)}));
    }
    if (!is_whole) return;
    screen_waves(l);
    for (std::size_t p = 0; p < products_.size(); ++p) {
      // An offset in proportion to the motor tension is a gain, which has laws of its own.
      const bool with_motor =
          covariate(products_[p].x).is_motor || covariate(products_[p].y).is_motor;
      if (with_motor && lever.target == Target::offset) continue;
      keep_product(l, products_[p], seen, static_cast<Index>(first_product_ + p));
    }
    screen_parts(l);
  }

  // An offset in proportion to what it is added to.
  bool is_gain_of_the_motor(const Lever& lever, std::size_t c) const {
    return lever.target == Target::offset && lever.site.place == SitePlace::motor &&
           covariate(c).is_motor;
  }

  // A motor tension that scatters is no covariate: a law of it would follow its scatter. Nor is the
  // order of readings that were set, which goes with what they were set to.
  bool is_of_noise(std::size_t c) const {
    return (covariate(c).is_motor && problem_.motor_deviation_N.size() > 0) ||
           (covariate(c).is_place && are_set_);
  }

  bool is_logarithmic(std::size_t c) const {
    constexpr double wide = 1.5;
    const auto& x = covariate(c).covariate;
    return x.seen.low > 0 && x.seen.high > wide * x.seen.low && !covariate(c).is_motor;
  }

  // Sine and cosine of each period, side by side.
  void list_waves() {
    std::vector<RowLaw> laws;
    for (std::size_t c = 0; c < screening_.covariates_.size(); ++c) {
      const auto& of = covariate(c);
      if (of.distinct.size() < enough_values || of.is_motor || is_of_noise(c)) continue;
      const double span = of.covariate.seen.high - of.covariate.seen.low;
      for (int k = 2; k <= most_waves && k <= static_cast<int>(of.distinct.size()) / 2; ++k) {
        const double period = 2 * span / k;
        waves_.emplace_back(c, period);
        laws.push_back({Form::sine, c, 0, {1, 0, period}});
        laws.push_back({Form::sine, c, 0, {0, 1, period}});
      }
    }
    wave_values_ = values(laws);
    wave_squares_ = wave_values_.cwiseAbs2();
  }

  // Waves are most of all laws. All their projections on the residuals take one product; the few
  // that promise most beside their raw lengths are then seen as all other laws are.
  void screen_waves(std::size_t l) {
    if (waves_.empty()) return;
    const Lever& lever = screening_.levers_[l];
    const VectorXd by_value = in_noise(lever);
    const VectorXd along = wave_values_.transpose() * by_value.cwiseProduct(pulled_back_);
    const VectorXd squares = wave_squares_.transpose() * by_value.cwiseAbs2();
    constexpr double tiny = std::numeric_limits<double>::min();
    std::vector<std::pair<double, std::size_t>> promises;
    for (std::size_t w = 0; w < waves_.size(); ++w) {
      const auto sine = static_cast<Index>(2 * w);
      promises.emplace_back(
          along[sine] * along[sine] / std::max(squares[sine], tiny) +
              along[sine + 1] * along[sine + 1] / std::max(squares[sine + 1], tiny),
          w);
    }
    const std::size_t few = std::min(waves_of_a_lever, promises.size());
    std::partial_sort(promises.begin(), promises.begin() + static_cast<std::ptrdiff_t>(few),
                      promises.end(), std::greater<>());
    MatrixXd chosen(wave_values_.rows(), static_cast<Index>(2 * few));
    for (std::size_t i = 0; i < few; ++i) {
      chosen.middleCols(static_cast<Index>(2 * i), 2) =
          wave_values_.middleCols(static_cast<Index>(2 * promises[i].second), 2);
    }
    const MatrixXd seen = columns(lever, chosen);
    for (std::size_t i = 0; i < few; ++i) {
      const auto& [c, period] = waves_[promises[i].second];
      const auto sine = static_cast<Index>(2 * i);
      keep_wave(l, c, period, family(seen, {sine, sine + 1}));
    }
  }

  void add_products() {
    for (std::size_t x = 0; x < screening_.covariates_.size(); ++x) {
      for (std::size_t y = 0; y < x; ++y) {
        if (covariate(x).is_place || covariate(y).is_place) continue;
        if (is_of_noise(x) || is_of_noise(y)) continue;
        products_.push_back({Form::product, x, y});
        if (is_logarithmic(x)) products_.push_back({Form::product, x, y, {1}, true});
        if (is_logarithmic(y)) products_.push_back({Form::product, x, y, {1}, false, true});
      }
    }
  }

  // The law of a load, alone or with the constant of the same site.
  void keep_load(std::size_t l, const MatrixXd& seen) {
    const Lever& lever = screening_.levers_[l];
    Made made{term(lever, lever.logarithmic ? Form::log : Form::linear),
              {},
              {},
              price_of_covariate(),
              0,
              1};
    made.term.x = lever.load;
    const Family alone = family(seen, {0});
    if (alone.gain > 0) {
      made.values = {alone.size[0]};
      made.gain = alone.gain;
      keep(l, made);
    }
    std::size_t plain = l;
    while (screening_.levers_[plain].by_load) --plain;
    MatrixXd both(seen.rows(), 2);
    both << columns(screening_.levers_[plain], values_.leftCols(1)), seen.col(0);
    const Family pair = family(both, {0, 1});
    if (!(pair.gain > 0)) return;
    made.term.x.logarithmic = lever.logarithmic;
    if (!move_crossing(made.term.x, pair.size[0], pair.size[1])) return;
    made.term.x.logarithmic = false;
    made.values = {pair.size[1]};
    made.gain = pair.gain;
    made.crossing = {made.term.x.middle};
    keep(l, made);
  }

  void keep_straight(std::size_t l, std::size_t c, const MatrixXd& seen, Index column, Form form) {
    const Lever& lever = screening_.levers_[l];
    Made made{term(lever, form), {}, {}, price_of(lever, c), 0, 2 + 3 * c};
    made.term.x = covariate(c).covariate;
    const bool loaded = lever.by_load;
    if (loaded) {
      if (form == Form::log) return;
      made.term.form = Form::product;
      made.term.y = made.term.x;
      made.term.x = lever.load;
      made.term.x.logarithmic = lever.logarithmic;
      made.price += price_of_product;
    }
    const Family alone = family(seen, {column});
    if (alone.gain > 0) {
      made.values = {alone.size[0]};
      made.gain = alone.gain;
      keep(l, made);
    }
    if (loaded) return;
    const Family pair = family(seen, {0, column});
    if (!(pair.gain > 0)) return;
    made.term.x.logarithmic = form == Form::log;
    if (!move_crossing(made.term.x, pair.size[0], pair.size[1])) return;
    made.term.x.logarithmic = false;
    made.values = {pair.size[1]};
    made.gain = pair.gain;
    made.crossing = {made.term.x.middle};
    keep(l, made);
  }

  // If a parabola gains, some bent law may.
  void note_bend(std::size_t l, std::size_t c, const Family& bent) {
    if (!(bent.gain > 0) || covariate(c).is_motor || is_of_noise(c) ||
        screening_.levers_[l].by_load)
      return;
    const double evidence = bent.gain - price(screening_.levers_[l]) -
                            price_of(screening_.levers_[l], c) - price_of_bend - std::log(degrees_);
    bends_.push_back({evidence, l, c});
  }

  void keep_wave(std::size_t l, std::size_t c, double period, const Family& wave) {
    if (!(wave.gain > 0)) return;
    Made made{term(screening_.levers_[l], Form::sine),
              {wave.size[0], wave.size[1], period},
              {},
              price_of(screening_.levers_[l], c) + price_of_bend,
              wave.gain,
              3 + 3 * c};
    made.term.x = covariate(c).covariate;
    keep(l, made);
  }

  void keep_product(std::size_t l, const RowLaw& of, const MatrixXd& seen, Index column) {
    Made made{term(screening_.levers_[l], Form::product),
              {},
              {},
              price_of(screening_.levers_[l], of.x) + price_of(screening_.levers_[l], of.y) +
                  price_of_product,
              0,
              1000 + of.x * screening_.covariates_.size() + of.y};
    made.term.x = covariate(of.x).covariate;
    made.term.y = covariate(of.y).covariate;
    made.term.x.logarithmic = of.x_logarithmic;
    made.term.y.logarithmic = of.y_logarithmic;
    const Family alone = family(seen, {column});
    if (alone.gain > 0) {
      made.values = {alone.size[0]};
      made.gain = alone.gain;
      keep(l, made);
    }
    const auto own_column = [&](std::size_t c, bool logarithmic) {
      return static_cast<Index>(logarithmic ? log_column_[c] : 1 + c);
    };
    const Family crossed = family(
        seen, {own_column(of.x, of.x_logarithmic), own_column(of.y, of.y_logarithmic), column});
    if (!(crossed.gain > 0)) return;
    if (!move_crossing(made.term.x, crossed.size[1], crossed.size[2]) ||
        !move_crossing(made.term.y, crossed.size[0], crossed.size[2])) {
      return;
    }
    made.values = {crossed.size[2]};
    made.gain = crossed.gain;
    made.crossing = {made.term.x.middle, made.term.y.middle};
    keep(l, made);
  }

  // Screens what one run or one group does by itself.
  void screen_parts(std::size_t l) {
    constexpr std::size_t few_runs = 4;
    if (runs_.size() >= few_runs) {
      screen_parts(l, runs_, screening_.run_of_row_, price_of_apart,
                   [&](Site& site, std::size_t run) { site.run = screening_.runs_[run]; });
    }
    if (groups_.size() >= 2) {
      screen_parts(l, groups_, screening_.group_of_row_, 0,
                   [&](Site& site, std::size_t group) { site.group = screening_.groups_[group]; });
    }
  }

  void screen_parts(std::size_t l, const std::set<std::size_t>& among,
                    const std::vector<std::size_t>& part_of_row, double own_price,
                    const std::function<void(Site&, std::size_t)>& restrict_to) {
    const Lever& lever = screening_.levers_[l];
    const std::vector<std::size_t> parts(among.begin(), among.end());
    MatrixXd own(static_cast<Index>(cells_.size()), static_cast<Index>(parts.size()));
    own.setZero();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::size_t own_part = part_of_row[row_of_cell_[i]];
      const auto part = std::lower_bound(parts.begin(), parts.end(), own_part);
      if (part == parts.end() || *part != own_part) continue;
      own(static_cast<Index>(i), part - parts.begin()) =
          lever.by_value_N[cells_[i]] / problem_.deviation_N[static_cast<Index>(i)];
    }
    own = seen(std::move(own));
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Family of = family(own, {static_cast<Index>(k)});
      if (!(of.gain > 0)) continue;
      Made made{term(lever, Form::constant),
                {of.size[0]},
                {},
                std::log(static_cast<double>(parts.size())) + own_price,
                of.gain,
                1};
      restrict_to(made.term.site, parts[k]);
      keep(l, made);
    }
  }

  struct Bend {
    double evidence = 0;
    std::size_t lever = 0;
    std::size_t covariate = 0;
  };

  void screen_bent() {
    std::stable_sort(bends_.begin(), bends_.end(),
                     [](const Bend& a, const Bend& b) { return a.evidence > b.evidence; });
    for (std::size_t i = 0; i < std::min(most_bent, bends_.size()); ++i) {
      if (bends_[i].evidence <= 0) break;
      screen_bent(bends_[i].lever, bends_[i].covariate);
    }
  }

  void screen_bent(std::size_t l, std::size_t c) {
    const auto [low, high] = covariate(c).covariate.seen;
    std::vector<RowLaw> laws;
    if (low > 0) {
      for (const double b : {-2.0, -1.0, -0.5, 0.5, 2.0, 3.0}) {
        laws.push_back({Form::power, c, 0, {1, b}});
      }
    }
    if (high > 0) {
      for (const double part : {0.05, 0.1, 0.2, 0.4, 0.8}) {
        laws.push_back({Form::exponential, c, 0, {1, part * high}});
      }
    }
    for (int k = 0; k <= 8; ++k) {
      laws.push_back({Form::quadratic, c, 0, {1, low + (high - low) * (k - 2) / 4}});
    }
    keep_bent(l, c, laws);
    screen_knots(l, c, Form::hinge, 1);
    screen_knots(l, c, Form::step, 0);
  }

  // A hinge or a step between any two neighbours of the recorded values: a few over the range
  // first, then all about the best. No fit would move a step, and next to its place another run
  // pays.
  void screen_knots(std::size_t l, std::size_t c, Form form, std::size_t first) {
    const std::vector<double>& values = covariate(c).distinct;
    const std::size_t stride = std::max<std::size_t>(1, values.size() / most_knots);
    const auto between = [&](std::size_t k) {
      return RowLaw{form, c, 0, {1, (values[k] + values[k + 1]) / 2}};
    };
    std::vector<std::size_t> knots;
    std::vector<RowLaw> laws;
    for (std::size_t k = first; k + 1 < values.size(); k += stride) {
      knots.push_back(k);
      laws.push_back(between(k));
    }
    if (laws.empty()) return;
    const std::size_t best = knots[keep_bent(l, c, laws)];
    laws.clear();
    const std::size_t last = std::min(best + stride, values.size() - 1);
    for (std::size_t k = std::max(best, first + stride) - stride + 1; k < last; ++k) {
      if (k != best) laws.push_back(between(k));
    }
    if (!laws.empty()) keep_bent(l, c, laws);
  }

  // Returns which of the laws gains most.
  std::size_t keep_bent(std::size_t l, std::size_t c, const std::vector<RowLaw>& laws) {
    const MatrixXd seen = columns(screening_.levers_[l], values(laws));
    std::size_t best = 0;
    double greatest = 0;
    for (std::size_t j = 0; j < laws.size(); ++j) {
      const Family bent = family(seen, {static_cast<Index>(j)});
      if (!(bent.gain > 0)) continue;
      if (bent.gain > greatest) {
        greatest = bent.gain;
        best = j;
      }
      Made made{term(screening_.levers_[l], laws[j].form),
                {bent.size[0], laws[j].values[1]},
                {},
                price_of(screening_.levers_[l], c) + price_of_bend,
                bent.gain,
                3 + 3 * c};
      if (laws[j].form == Form::step) made.price += price_of_knot(c);
      made.term.x = covariate(c).covariate;
      keep(l, made);
    }
    return best;
  }

  const LawScreening& screening_;
  const Problem& problem_;
  const Forecast& at_;
  const Projection& projection_;
  const VectorXd& residuals_;
  bool are_set_;
  double before_;
  double degrees_;
  std::vector<std::size_t> rows_;         // row indices of the screening's dataset
  std::vector<std::size_t> row_of_cell_;  // likewise
  std::vector<Index> cells_;              // likewise
  std::set<std::size_t> runs_;
  std::set<std::size_t> groups_;
  std::vector<std::size_t> log_column_;  // column of each covariate's logarithm; 0 if it has none
  std::size_t first_quadratic_ = 0;
  std::size_t first_product_ = 0;
  std::vector<std::pair<std::size_t, double>> waves_;  // covariate and period
  std::vector<RowLaw> products_;
  MatrixXd values_;  // values of the laws of all levers, and of products
  MatrixXd wave_values_, wave_squares_;
  VectorXd pulled_back_;  // the residuals, as raw columns meet them
  std::vector<Found> found_;
  std::vector<Bend> bends_;
};

LawScreening::LawScreening(const Dataset& dataset, const Model& model, const Forecast& at,
                           Workers& workers)
    : levers_(levers(dataset, model, at, workers)),
      covariates_(row_covariates(dataset)),
      runs_(dataset.data->runs),
      groups_(dataset.data->groups) {
  for (const DatasetRow& row : dataset.rows) {
    reading_of_row_.push_back(row.reading);
    first_cell_.push_back(row.first);
    const Reading& reading = dataset.data->readings[row.reading];
    run_of_row_.push_back(reading.run);
    group_of_row_.push_back(reading.group.value_or(groups_.size()));
  }
  for (const Lever& lever : levers_) {
    levers_of_breadth_[static_cast<std::size_t>(lever.breadth)] += 1;
  }
}

std::vector<ScreenedLaw> LawScreening::best(const Problem& problem, const Forecast& at,
                                            const Projection& projection, const VectorXd& residuals,
                                            std::size_t most) const {
  return LawFamilies(*this, problem, at, projection, residuals).run(most);
}

}  // namespace reeve::diagnosis
