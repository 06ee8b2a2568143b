// Terms and their parts, with numbers of their own.
#pragma once

#include <utility>
#include <vector>

#include "causes/term.hpp"

namespace reeve::testing {

inline Covariate humidity() {
  Covariate x;
  x.kind = CovariateKind::column;
  x.column = "humidity_pct";
  x.middle = 50;
  x.seen = {20, 80};
  return x;
}

inline Covariate of_kind(CovariateKind kind, double middle, Range seen) {
  Covariate x;
  x.kind = kind;
  x.middle = middle;
  x.seen = seen;
  return x;
}

inline Covariate load(double middle, Range seen = {0.1, 100}) {
  return of_kind(CovariateKind::load, middle, seen);
}

inline Covariate logarithmic(Covariate x) {
  x.logarithmic = true;
  return x;
}

inline Site contacts(ContactKind kind) {
  Site site;
  site.kind = kind;
  return site;
}

inline Site at(SitePlace place) {
  Site site;
  site.place = place;
  return site;
}

inline Site channel(const char* name) {
  Site site = at(SitePlace::channel);
  site.channel = parse_segment(name);
  return site;
}

inline Term constant(Target target, const Site& site) { return {target, site}; }

inline Effect effect_of(const Term& term, std::vector<double> values) {
  return {&law(term), {}, std::move(values)};
}

inline Term of_form(Form form, const Covariate& x = humidity()) {
  return {Target::exponent, contacts(ContactKind::sheath), form, x};
}

}  // namespace reeve::testing
