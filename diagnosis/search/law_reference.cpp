#include "diagnosis/search/law_reference.hpp"

#include <cmath>

namespace reeve::diagnosis {
namespace {

// Share of the range of x that an estimated x0 may lie outside it.
constexpr double at_most_off = 0.1;

// The x at which the law has this value.
double where(const Term& law, const std::vector<double>& values, double value) {
  const double by_a = value / values[0];
  switch (law.form) {
    case Form::linear:
      return law.x.middle + by_a;
    case Form::log:
      return law.x.middle * std::exp(by_a);
    default:
      return law.x.middle * std::pow(1 + by_a, 1 / values[1]);
  }
}

}  // namespace

bool is_law_of(const Term& law, const Effect& coefficient) {
  Site of_all;
  of_all.kind = law.site.kind;
  return law.target == Target::exponent && law.site == of_all &&
         causes::is_tube_or_sheath(law.site.kind) && coefficient.cause->acts_at(law.site.kind) &&
         (law.form == Form::linear || law.form == Form::log || law.form == Form::power);
}

std::optional<Effect> law_from(double nominal, double mu, const Effect& law) {
  Term term = *term_of(*law.cause);
  const double x0 = where(term, law.values, nominal / mu - 1);
  const double off = at_most_off * (term.x.seen.high - term.x.seen.low);
  if (!(x0 >= term.x.seen.low - off && x0 <= term.x.seen.high + off)) return std::nullopt;
  std::vector<double> values = law.values;
  values[0] *= mu / nominal;
  if (term.form == Form::power) values[0] *= std::pow(x0 / term.x.middle, values[1]);
  term.x.middle = x0;
  return Effect{&causes::law(term), law.subject, std::move(values)};
}

}  // namespace reeve::diagnosis
