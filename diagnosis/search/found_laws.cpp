#include "diagnosis/search/found_laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "causes/term.hpp"

namespace reeve::diagnosis {
namespace {

using What = LawKind::What;

constexpr double price_of_law = 1;  // beside what the library has a name for
constexpr double price_of_bend = 2;
constexpr double price_of_product = 2;
constexpr double price_of_place = 2;
constexpr double price_of_apart = 4;
constexpr double price_of_breadth = 1;

// A force that contacts take is none that they give.
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

What kind_of(Form form) {
  if (form == Form::constant) return What::constant;
  if (form == Form::product) return What::product;
  return form == Form::linear || form == Form::log ? What::straight : What::bent;
}

Covariate as_factor(Covariate x, bool is_logarithmic) {
  x.logarithmic = is_logarithmic;
  return x;
}

}  // namespace

FoundLaws::FoundLaws(const LawColumns& columns)
    : columns_(columns), parameter_price_(std::log(columns.degrees_of_freedom()) / 2) {
  for (const Lever& lever : columns.table().levers) {
    levers_of_breadth_[static_cast<std::size_t>(lever.breadth)] += 1;
  }
}

double FoundLaws::price(const Lever& lever) const {
  const auto breadth = static_cast<std::size_t>(lever.breadth);
  // Friction is in proportion to the load but for rare cases.
  const double price_of_force = lever.target == Target::force ? 0.5 : 0;
  return price_of_law + price_of_force + std::log(levers_of_breadth_[breadth]) +
         price_of_breadth * static_cast<double>(breadth);
}

// The load is a covariate, too.
double FoundLaws::price_of_covariate() const {
  return std::log(1.0 + static_cast<double>(columns_.table().covariates.size()));
}

double FoundLaws::price_of(const Lever& lever, std::size_t c) const {
  return price_of_covariate() + (columns_.covariate(c).is_place ? price_of_place : 0) +
         price_of_breadth * static_cast<double>(lever.breadth);
}

LeverLaw FoundLaws::law(std::size_t l, const RowLaw& of) const {
  const Lever& lever = columns_.lever(l);
  LeverLaw law{l, {kind_of(of.form), of.x, of.y}, {lever.target, lever.site, of.form, {}, {}}, 0};
  if (of.form == Form::constant) {
    if (!lever.by_load) return law;
    law.kind.what = What::own;
    law.term.form = lever.logarithmic ? Form::log : Form::linear;
    law.term.x = lever.load;
    law.price = price_of_covariate();
    return law;
  }
  const RowCovariate& x = columns_.covariate(of.x);
  law.term.x = as_factor(x.covariate, of.x_logarithmic);
  law.price = price_of(lever, of.x);
  if (lever.by_load) {
    law.term.form = Form::product;
    law.term.y = law.term.x;
    law.term.x = as_factor(lever.load, lever.logarithmic);
    law.price += price_of_product;
  } else if (law.kind.what == What::product) {
    law.term.y = as_factor(columns_.covariate(of.y).covariate, of.y_logarithmic);
    law.price += price_of(lever, of.y) + price_of_product;
  } else if (law.kind.what == What::bent) {
    law.price += price_of_bend;
  }
  // The place of a step is one of as many as the column has values, and no fitted parameter.
  if (of.form == Form::step) {
    law.price += std::log(static_cast<double>(x.distinct.size())) - parameter_price_;
  }
  return law;
}

LeverLaw FoundLaws::law_of_part(std::size_t l, std::size_t parts, bool is_run) const {
  LeverLaw result = law(l, {});
  result.kind.what = What::own;
  result.price = std::log(static_cast<double>(parts)) + (is_run ? price_of_apart : 0);
  return result;
}

double FoundLaws::bent_evidence(std::size_t l, std::size_t c, double gain) const {
  const Lever& lever = columns_.lever(l);
  return gain - price(lever) - price_of(lever, c) - price_of_bend - 2 * parameter_price_;
}

void FoundLaws::keep(const LeverLaw& law, double gain, std::vector<double> values,
                     const std::vector<double>& crossing) {
  if (!(gain > 0) || causes::fault(law.term) || !is_possible(law.term, values)) return;
  values.insert(values.end(), crossing.begin(), crossing.end());
  const double cost = price(columns_.lever(law.lever)) + law.price;
  const double evidence = gain - cost - static_cast<double>(values.size()) * parameter_price_;
  if (evidence <= 0) return;
  const Cause& cause =
      crossing.empty() ? causes::law(law.term) : causes::law_with_free_crossing(law.term);
  found_.push_back({{{&cause, {}, std::move(values)}, cost, evidence}, law.lever, law.kind});
}

std::vector<ScreenedLaw> FoundLaws::best(std::size_t most) const {
  std::vector<const Found*> in_turn;
  for (const Found& found : found_) in_turn.push_back(&found);
  std::stable_sort(in_turn.begin(), in_turn.end(), [](const Found* a, const Found* b) {
    return a->law.evidence > b->law.evidence;
  });
  std::vector<ScreenedLaw> result;
  std::set<std::pair<std::size_t, LawKind>> met;
  for (const Found* found : in_turn) {
    if (result.size() >= most) break;
    if (!met.insert({found->lever, found->kind}).second) continue;
    result.push_back(found->law);
    const auto constant = std::find_if(in_turn.begin(), in_turn.end(), [&](const Found* other) {
      return other->lever == found->lever && other->kind == LawKind{};
    });
    if (constant == in_turn.end() || !met.insert({found->lever, LawKind{}}).second) continue;
    result.push_back((*constant)->law);
  }
  return result;
}

}  // namespace reeve::diagnosis
