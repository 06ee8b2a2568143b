#include "diagnosis/search/found_laws.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "causes/term.hpp"
#include "diagnosis/search/law_forms.hpp"

namespace reeve::diagnosis {
namespace {

using What = LawKind::What;

constexpr double price_of_law = 1;  // beside what the library has a name for
constexpr double price_of_product = 2;
// A lever with a load offers laws by contact, straight and logarithmic, besides those by row.
constexpr double laws_by_load = 2;
constexpr double price_of_place = 2;
constexpr double price_of_apart = 4;
constexpr double price_of_breadth = 1;

What kind_of(Form form) {
  if (form == Form::constant) return What::constant;
  if (form == Form::product) return What::product;
  return form == Form::linear || form == Form::log ? What::straight : What::bent;
}

// std::lgamma, the shorter way, writes its sign to a variable that all threads share.
double log_choose(std::size_t of, std::size_t chosen) {
  double log = 0;
  for (std::size_t i = 1; i <= chosen; ++i) {
    log += std::log(static_cast<double>(of - chosen + i) / static_cast<double>(i));
  }
  return log;
}

Covariate as_factor(Covariate x, bool is_logarithmic) {
  x.logarithmic = is_logarithmic;
  return x;
}

}  // namespace

FoundLaws::FoundLaws(const LawColumns& columns)
    : columns_(columns), parameter_price_(std::log(columns.degrees_of_freedom()) / 2) {
  for (const Lever& lever : columns.table().levers) {
    levers_of_breadth_[static_cast<std::size_t>(lever.breadth)] +=
        lever.load ? 1 + laws_by_load : 1;
  }
}

double FoundLaws::price(const Lever& lever) const {
  const auto breadth = static_cast<std::size_t>(lever.breadth);
  return price_of_law + std::log(levers_of_breadth_[breadth]) +
         price_of_breadth * static_cast<double>(breadth);
}

double FoundLaws::price_of(const Lever& lever, std::size_t c) const {
  const auto count = static_cast<double>(columns_.table().covariates.size());
  return std::log(1 + count) +  // the load is a covariate, too
         (columns_.covariate(lever, c).is_place ? price_of_place : 0) +
         price_of_breadth * static_cast<double>(lever.breadth);
}

LeverLaw FoundLaws::law(std::size_t l, const RowLaw& of) const {
  const Lever& lever = columns_.lever(l);
  LeverLaw law{l, {kind_of(of.form), of.x, of.y}, {lever.target, lever.site, of.form, {}, {}}, 0};
  law.price = price_of_form(law.term);
  if (of.form == Form::constant) return law;
  const RowCovariate& x = columns_.covariate(lever, of.x);
  law.term.x = as_factor(x.covariate, of.x_logarithmic);
  law.price += price_of(lever, of.x);
  if (law.kind.what == What::product) {
    law.term.y = as_factor(columns_.covariate(lever, of.y).covariate, of.y_logarithmic);
    law.price += price_of(lever, of.y) + price_of_product;
  }
  // The place of a step is one of as many as the column has values, and no fitted parameter.
  if (of.form == Form::step) {
    law.price += std::log(static_cast<double>(x.distinct.size())) - parameter_price_;
  }
  return law;
}

LeverLaw FoundLaws::law_of_runs(std::size_t l, std::size_t size, std::size_t runs) const {
  LeverLaw result = law(l, {});
  result.kind.what = What::of_part;
  result.price += price_of_apart + log_choose(runs, size);
  return result;
}

LeverLaw FoundLaws::law_of_tension(std::size_t l, const Covariate& tension, std::size_t n,
                                   std::size_t tensions) const {
  const Lever& lever = columns_.lever(l);
  const std::size_t behind_load = columns_.load() + 1;
  LeverLaw law{l, {What::straight, behind_load + n}, {}, 0};
  law.term = {lever.target, lever.site, Form::linear, tension, {}};
  law.price = price_of_form(law.term) + std::log(static_cast<double>(tensions));
  return law;
}

double FoundLaws::bent_evidence(std::size_t l, std::size_t c, double gain, int parameters) const {
  const Lever& lever = columns_.lever(l);
  return gain - price(lever) - price_of(lever, c) -
         price_of_form({lever.target, lever.site, Form::power, {}, {}}) -
         parameters * parameter_price_;
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
  found_.push_back({{{&cause, {}, std::move(values)}, cost, gain, evidence}, law.lever, law.kind});
}

std::vector<ScreenedLaw> FoundLaws::best(std::size_t most) const {
  std::vector<const Found*> in_turn;
  for (const Found& found : found_) in_turn.push_back(&found);
  std::ranges::stable_sort(
      in_turn, [](const Found* a, const Found* b) { return a->law.evidence > b->law.evidence; });
  std::vector<ScreenedLaw> result;
  std::set<std::pair<std::size_t, LawKind>> met;
  for (const Found* found : in_turn) {
    if (result.size() >= most) break;
    if (!met.insert({found->lever, found->kind}).second) continue;
    result.push_back(found->law);
    const auto constant = std::ranges::find_if(in_turn, [&](const Found* other) {
      return other->lever == found->lever && other->kind == LawKind{};
    });
    if (constant == in_turn.end() || !met.insert({found->lever, LawKind{}}).second) continue;
    result.push_back((*constant)->law);
  }
  return result;
}

}  // namespace reeve::diagnosis
