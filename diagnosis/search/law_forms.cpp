#include "diagnosis/search/law_forms.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double price_of_force = 0.5;  // friction is in proportion to the load but for rare cases
constexpr double price_of_bend = 2;

bool is_bent(Form form) {
  return form != Form::constant && form != Form::linear && form != Form::log &&
         form != Form::product;
}

// Values of the covariate over its range; as many between any two orders where it is above 0.
VectorXd places(const Range& seen) {
  constexpr Index count = 20;
  if (!(seen.low > 0)) return VectorXd::LinSpaced(count, seen.low, seen.high);
  return VectorXd::LinSpaced(count, std::log(seen.low), std::log(seen.high)).array().exp();
}

VectorXd values_at(const Term& term, const VectorXd& x, const std::vector<double>& values) {
  return x.unaryExpr([&](double each) { return causes::law_value(term, each, 0, values.data()); });
}

// The law of this shape that follows `wanted` but for a constant, which other parameters take. The
// crossing of a law that has one makes up for the constant.
std::vector<double> start(const Term& term, std::vector<double> shape, const VectorXd& x,
                          const VectorXd& wanted) {
  const VectorXd unit = values_at(term, x, shape);
  const VectorXd from_mean = unit.array() - unit.mean();
  const double square = from_mean.squaredNorm();
  shape[0] = square > 0 ? from_mean.dot(wanted) / square : 0;
  if (!causes::has_crossing(term) || shape[0] == 0) return shape;
  const double below = (wanted.mean() / shape[0]) - unit.mean();
  shape.push_back(term.form == Form::log ? term.x.middle * std::exp(-below)
                                         : term.x.middle - below);
  return shape;
}

std::vector<RowLaw> shapes(const Covariate& x) {
  std::vector<RowLaw> result = smooth_bends(0, x.seen);
  result.push_back({Form::linear, 0});
  if (x.seen.low > 0) result.push_back({Form::log, 0});
  for (const double part : {0.1, 0.25, 0.5, 0.75}) {
    result.push_back({Form::hinge, 0, 0, {1, x.seen.low + part * (x.seen.high - x.seen.low)}});
  }
  return result;
}

// The constant of one direction says what that of the other does beside another coefficient.
LawForm in_other_direction(const Effect& law, Term term) {
  term.site.direction =
      *term.site.direction == Direction::pull ? Direction::release : Direction::pull;
  const double a = law.values.front();
  const bool is_factor = term.target == Target::gain || (term.target == Target::exponent &&
                                                         causes::is_tube_or_sheath(term.site.kind));
  const std::vector<double> start{is_factor && a > -1 ? 1 / (1 + a) - 1 : -a};
  return {{&causes::law(term), law.subject, start}, {start}, 0};
}

}  // namespace

std::vector<RowLaw> smooth_bends(std::size_t c, const Range& seen) {
  const auto [low, high] = seen;
  std::vector<RowLaw> laws;
  if (low > 0) {
    for (const double b : {-2.0, -1.0, -0.5, 0.5, 2.0, 3.0}) {
      laws.push_back({Form::power, c, 0, {1, b}});
    }
    for (const double b : {0.3, 0.5, 0.7, 1.5, 2.0, 3.0}) {
      laws.push_back({Form::scaling, c, 0, {1, b}});
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
  return laws;
}

bool is_possible(const Term& term, const std::vector<double>& values) {
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

double price_of_form(const Term& term) {
  return (term.target == Target::force ? price_of_force : 0) +
         (is_bent(term.form) ? price_of_bend : 0);
}

std::vector<LawForm> other_forms(const Effect& law) {
  const Term* own = causes::term_of(*law.cause);
  if (own != nullptr && own->form == Form::constant && own->site.direction) {
    return {in_other_direction(law, *own)};
  }
  const bool is_of_one = own != nullptr && own->form != Form::constant &&
                         own->form != Form::product && own->form != Form::sine;
  if (!is_of_one) return {};
  const bool turns =
      own->site.place == SitePlace::contacts && own->x.kind == causes::CovariateKind::load;
  const VectorXd x = places(own->x.seen);
  const VectorXd f = values_at(*own, x, law.values);
  std::map<std::pair<Target, Form>, LawForm> found;
  for (const Target target :
       {own->target, own->target == Target::force ? Target::exponent : Target::force}) {
    const bool is_other = target != own->target;
    if (is_other && !turns) continue;
    const VectorXd wanted = !is_other                 ? f
                            : target == Target::force ? VectorXd(f.cwiseProduct(x))
                                                      : VectorXd(f.cwiseQuotient(x));
    for (const RowLaw& shape : shapes(own->x)) {
      Term term = *own;
      term.target = target;
      term.form = shape.form;
      if (causes::fault(term) || (!is_other && term.form == own->form)) continue;
      LawForm& form = found[{target, term.form}];
      form.effect = {
          &(causes::has_crossing(term) ? causes::law_with_free_crossing(term) : causes::law(term)),
          law.subject,
          {}};
      form.starts.push_back(start(term, shape.values, x, wanted));
      form.effect.values = form.starts.front();
      form.more_price = price_of_form(term) - price_of_form(*own);
    }
  }
  std::vector<LawForm> result;
  for (auto& [key, form] : found) result.push_back(std::move(form));
  return result;
}

}  // namespace reeve::diagnosis
